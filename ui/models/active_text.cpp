#include "ui/models/active_text.h"

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr double kDegrees = 360.0 / kTwoPi;
constexpr double kLimited = 0.01;  // of the samples: the stroke is short
constexpr double kWarnPhase =
    30.0;  // [degrees] left of the 90: the loop stands it, a little more delay and it does not

QString decibel(double value) {
  return join((value > 0.0 ? QStringLiteral("+") : QString()) + number(value, 1), QStringLiteral("dB"));
}

QString degrees(double radians) {
  return number(radians * kDegrees) + QStringLiteral("\u00b0");
}

QString modelText(const ActivePath& path, Instant now) {
  if (!path.known) return say("No model of this path: identify it, with the tool out of the cut");
  QString text = say("Model: leaves %1 unexplained, %2 of 90\u00b0 phase error left, worst at %3")
                     .arg(percent(path.residual), degrees(path.phaseMargin),
                          join(number(path.worstFrequency.value), QStringLiteral("Hz")));
  text += u'\n' + say("Loop delay %1, may grow by %2; identified %3 ago")
                      .arg(join(number(path.delay.value * 1e3, 2), QStringLiteral("ms")),
                           join(number(path.delayMargin.value * 1e3, 2), QStringLiteral("ms")),
                           duration(secondsBetween(path.identified, now)));
  if (!path.predictedStable) text += u'\n' + say("It promises no stable control: identify anew");
  return text;
}

QString stateText(const ActiveAxis& axis) {
  switch (axis.state) {
    case ActuatorState::RampIn:
      return say("starting");
    case ActuatorState::On:
      return say("on");
    case ActuatorState::RampOut:
    case ActuatorState::Off:
      break;
  }
  const bool byItself = axis.release != ActuatorRelease::None && axis.release != ActuatorRelease::Asked;
  return byItself ? say("let go: %1").arg(activeReleaseText(axis.release)) : say("off");
}

}  // namespace

QString activeReleaseText(ActuatorRelease why) {
  switch (why) {
    case ActuatorRelease::None:
      return {};
    case ActuatorRelease::Asked:
      return say("released");
    case ActuatorRelease::LeaseOver:
      return say("nobody renewed the lease");
    case ActuatorRelease::NotFinite:
      return say("a value was not finite");
    case ActuatorRelease::Diverging:
      return say("the loop diverged");
    case ActuatorRelease::Saturated:
      return say("the actuator was at its end and the vibration grew");
    case ActuatorRelease::Worse:
      return say("control made the vibration worse");
    case ActuatorRelease::DeadSensor:
      return say("the error sensor stands still");
    case ActuatorRelease::DeviceFault:
      return say("the device lost a block");
  }
  return {};
}

ActiveAxisView makeActiveAxis(const ActiveSnapshot& snapshot, int axis) {
  const ActiveAxis& a = snapshot.axes[static_cast<std::size_t>(axis)];
  const ActivePath& path = snapshot.paths[static_cast<std::size_t>(axis)];
  ActiveAxisView view;
  view.state = stateText(a);
  const bool fell = a.release != ActuatorRelease::None && a.release != ActuatorRelease::Asked;
  const bool off = a.state == ActuatorState::Off || a.state == ActuatorState::RampOut;
  const bool limited = a.limitedFraction > kLimited;
  view.tone = off && fell ? Tone::Chatter : limited ? Tone::Onset : Tone::Normal;
  view.stroke =
      limited ? say("stroke %1, at its end for %2 of the time").arg(percent(a.strokePeak), percent(a.limitedFraction))
              : say("stroke %1").arg(percent(a.strokePeak));
  for (int k = 0; k < std::min(a.lineCount, kActiveLines); ++k) {
    const LineAttenuation& line = a.lines[static_cast<std::size_t>(k)];
    if (!line.known) continue;
    view.lines << say("%1: %2").arg(join(number(line.frequency.value), QStringLiteral("Hz")), decibel(-line.gain_dB));
  }
  view.model = modelText(path, snapshot.time);
  view.modelSound = path.known && path.predictedStable && path.phaseMargin * kDegrees > kWarnPhase;
  return view;
}

ActiveTableView makeActiveTable(const ActiveSnapshot& snapshot) {
  ActiveTableView view;
  if (snapshot.identifying && snapshot.open)
    return {say("identifying, %1").arg(percent(snapshot.identified)), Tone::Advice, {}};
  QStringList moving, fallen;
  for (int axis = 0; axis < kActiveAxes; ++axis) {
    const ActiveAxis& a = snapshot.axes[static_cast<std::size_t>(axis)];
    const QString name = axis == 0 ? QStringLiteral("x") : QStringLiteral("y");
    const ActiveAxisView one = makeActiveAxis(snapshot, axis);
    if (one.tone == Tone::Chatter) {
      fallen << say("%1 let go").arg(name);
      view.fault = say("The active table let go along %1: %2").arg(name, activeReleaseText(a.release));
      view.tone = Tone::Chatter;
    } else if (a.state != ActuatorState::Off) {
      moving << join(name, percent(a.strokePeak));
      if (view.tone == Tone::Normal) view.tone = one.tone;
    }
  }
  fallen += moving;
  if (!snapshot.open && fallen.isEmpty()) return {say("does not run"), Tone::Faint, {}};
  if (fallen.isEmpty()) return {say("off"), Tone::Faint, {}};
  view.text = fallen.join(QStringLiteral(", "));
  return view;
}

QString activeDeviceText(const ActiveSnapshot& snapshot, const QString& device) {
  if (!snapshot.open) return say("%1: does not run").arg(device);
  if (snapshot.identifying) return say("Identifying the paths: %1").arg(percent(snapshot.identified));
  const QString text =
      say("%1: %2, blocks of %3, worst block %4")
          .arg(device, join(number(snapshot.rate.value), QStringLiteral("Hz")), number(snapshot.blockFrames),
               join(number(snapshot.worstBlock.value * 1e6), QStringLiteral("\u00b5s")));
  return snapshot.underruns == 0 ? text
                                 : say("%1, %2 blocks late").arg(text, number(static_cast<double>(snapshot.underruns)));
}

}  // namespace stillcut::ui
