#include "ui/models/machine_view.h"

#include <algorithm>
#include <cmath>

#include "core/model/channel.h"
#include "ui/base/format.h"
#include "ui/base/say.h"
#include "ui/models/simulation_over.h"

namespace stillcut::ui {
namespace {

constexpr Seconds kOldAfter{1.0};  // a machine state older than this is no longer "actual"

OverrideRow row(const QString& label, const QString& unit, double programmed, Ratio inForce, Ratio knob,
                double actual) {
  OverrideRow r;
  r.label = label;
  r.unit = unit;
  r.programmed = number(programmed);
  r.overridden = overrideText(inForce.value);
  r.actual = number(actual);
  if (std::abs(inForce.value - knob.value) > 0.004) r.tone = Tone::Advice;
  return r;
}

// Overrides of ours in a machine that takes none while it is off: they stay until somebody brings them back.
QString machineOff(const MachineState& m) {
  const auto stays = [](Ratio inForce, Ratio knob) { return std::abs(inForce.value - knob.value) > 0.004; };
  if (!stays(m.speedOverride, m.operatorSpeed) && !stays(m.feedOverride, m.operatorFeed)) {
    return say("The machine is off");
  }
  return say("The machine is off at speed %1, feed %2; Stillcut brings them back when it is on")
      .arg(overrideText(m.speedOverride.value), overrideText(m.feedOverride.value));
}

QString blocked(const MachineState& m) {
  switch (m.block) {
    case OverrideInhibit::MachineOff:
      return machineOff(m);
    case OverrideInhibit::MachineAlarm:
      return say("The machine is in alarm");
    case OverrideInhibit::NoProgram:
      return say("No program runs");
    case OverrideInhibit::OverridesLocked:
      return say("The program has locked both overrides (M49)");
    case OverrideInhibit::SpeedLocked:
      return say(
          "The spindle override has no effect: locked by the program (M51, M49), or the machine is at its limit");
    case OverrideInhibit::FeedLocked:
      return say("The feed override has no effect: locked by the program (M50, M49), or the machine is at its limit");
    case OverrideInhibit::AdaptiveLocked:
      return say("Adaptive feed has no effect: the program has not said M52 P1");
    case OverrideInhibit::OtherClient:
      return say("Another program has the overrides");
    case OverrideInhibit::ControlRefused:
      return say("LinuxCNC refuses control: is the control password right?");
    case OverrideInhibit::ComponentSilent:
      return say("stillcut-hal does not answer");
    case OverrideInhibit::ComponentDown:
      return say("stillcut-hal has not seen the machine's watchdog act");
    case OverrideInhibit::ComponentOut:
      return say("The machine's watchdog or the operator's switch has taken Stillcut out");
    case OverrideInhibit::Starting:
      return say("The controller starts, as many do when their port is opened: this takes up to 4 s");
    case OverrideInhibit::None:
      break;
  }
  return {};
}

QString whatHinders(const MachineState& m, Seconds age) {
  if (!m.linkUp) return say("The machine does not answer; last values %1 old").arg(duration(age));
  if (age > kOldAfter) return say("Values are %1 old").arg(duration(age));
  if (m.block != OverrideInhibit::None) return blocked(m);
  if (!m.controlOurs) return say("Another program has the overrides");
  if (!m.overridesEnabled) return say("The program has switched overrides off");
  if (!m.programRunning) return say("No program runs, or the machine is off");
  if (m.feedHold) return say("Feed hold");
  return {};
}

// What our overrides leave of the feed per tooth, and the knobs. Overrides are read back in steps of up to 1 %.
QString knobs(const MachineState& m) {
  constexpr double kReadBack = 0.015;
  const QString speed = overrideText(m.operatorSpeed.value), feed = overrideText(m.operatorFeed.value);
  const double perTooth = (m.feedOverride / m.operatorFeed) / (m.speedOverride / m.operatorSpeed);
  if (!std::isfinite(perTooth) || std::abs(perTooth - 1.0) <= kReadBack) return say("Knobs %1, %2").arg(speed, feed);
  return say("Knobs %1, %2; feed per tooth %3").arg(speed, feed, overrideText(perTooth));
}

double clampedFraction(double value, double full) {
  return full > 0 ? std::clamp(value / full, 0.0, 1.0) : 0.0;
}

void mark(BarView& bar, double limit, double full) {
  if (std::isfinite(limit) && limit > 0 && limit <= full) bar.marks.push_back(limit / full);
}

BarView ratioBar(const QString& label, double value, bool known) {
  BarView bar;
  bar.label = label;
  bar.known = known && std::isfinite(value);
  if (!bar.known) {
    bar.value = number(std::nan(""));
    return bar;
  }
  bar.value = number(value, 2);
  bar.full = number(1.0);
  bar.fraction = clampedFraction(value, 1.0);
  return bar;
}

int detectorIndex(const SessionInfo& info, const QString& id) {
  const auto found =
      std::find_if(info.detectors.begin(), info.detectors.end(), [&](const DetectorLabel& d) { return d.id == id; });
  return found == info.detectors.end() ? -1 : static_cast<int>(found - info.detectors.begin());
}

// As the detector says: a ratio may pass its limit for a moment, as at a change of speed, without an alarm.
Tone toneOf(const Verdict& verdict) {
  if (!verdict.alarming()) return Tone::Normal;
  return verdict.state == CutState::Chatter ? Tone::Chatter : Tone::Onset;
}

BarView energyBar(const Picture& p, bool live) {
  const int index = detectorIndex(*p.info, QStringLiteral("energy-ratio"));
  const Verdict none;
  const Verdict& verdict =
      live ? p.snapshot->verdicts[static_cast<std::size_t>(index >= 0 ? index : p.snapshot->inCharge)] : none;
  BarView bar = ratioBar(say("Energy ratio"), verdict.severity.value, verdict.valid);
  mark(bar, p.info->limits.energyRatio, 1.0);
  bar.tone = toneOf(verdict);
  bar.counts = live && (index < 0 || index == p.snapshot->inCharge);
  return bar;
}

// Nobody has told what a unit of the device is worth: the numbers are right among each other and nowhere else.
bool uncalibrated(const Picture& p) {
  const auto& channels = p.info->setup.channels;
  if (channels.empty() || p.info->simulatedMachine) return false;
  const ChannelInfo& first = channels.front();
  return !(first.sensitivity > 0.0) && std::abs(first.scale - 1.0) < 1e-12;
}

BarView vibrationBar(const Picture& p, bool live, VibrationScale& scale) {
  BarView bar;
  bar.label = say("Vibration");
  const auto& channels = p.info->setup.channels;
  const SensorQuantity quantity = channels.empty() ? SensorQuantity::Acceleration : channels.front().quantity;
  const std::string_view siName = siUnit(quantity);
  const QString unit = QString::fromUtf8(siName.data(), static_cast<qsizetype>(siName.size()));
  const double rms = live ? p.snapshot->vibrationRms : 0.0, limit = p.info->limits.vibration;
  const bool compared = live && std::isfinite(p.vibrationWithout);
  const double full = scale.fullFor(compared ? std::max(rms, p.vibrationWithout) : rms, limit);
  bar.known = live && std::isfinite(rms);
  bar.full = join(significant(full), unit);
  if (uncalibrated(p)) bar.label = say("Vibration, uncalibrated");
  bar.value = bar.known ? join(significant(rms), unit) : join(number(std::nan("")), unit);
  bar.fraction = bar.known ? clampedFraction(rms, full) : 0.0;
  if (compared) {
    bar.without = clampedFraction(p.vibrationWithout, full);
    bar.withoutText = say("without Stillcut %1").arg(join(significant(p.vibrationWithout), unit));
  }
  mark(bar, limit, full);
  if (bar.known && std::isfinite(limit) && rms >= limit) bar.tone = Tone::Chatter;
  return bar;
}

BarView coherenceBar(const Picture& p, bool live, int detector) {
  const auto which = static_cast<std::size_t>(detector);
  const DetectorLabel& info = p.info->detectors[which];
  const qsizetype place = std::max<qsizetype>(info.indicators.indexOf(QStringLiteral("gamma_max")), 0);
  const Verdict none;
  const Verdict& verdict = live ? p.snapshot->verdicts[which] : none;
  BarView bar = ratioBar(say("Coherence"), verdict.indicators[static_cast<std::size_t>(place)], verdict.valid);
  mark(bar, p.info->limits.coherence, 1.0);
  bar.tone = toneOf(verdict);
  bar.counts = live && detector == p.snapshot->inCharge;
  return bar;
}

// Without a machine: what was set up, and what the vibration says.
MachineView withoutMachine(const Picture& picture) {
  MachineView view;
  const QString none = number(std::nan(""));
  const CutSetup& cut = picture.info->setup;
  const auto shown = [&none](double value) { return value > 0.0 ? number(value) : none; };
  const bool live = picture.snapshot && !picture.stale && picture.verdict().spindle.value > 0.0;
  const double turns = live ? picture.verdict().spindle.value * 60.0 : 0.0;
  view.speed = {say("Speed"), shown(cut.nominalSpeed.value), none, shown(turns), rpmUnit(), Tone::Normal, false};
  view.feed = {
      say("Feed"), shown(feedIn(cut.nominalFeed, picture.units)), none, none, feedUnit(picture.units), Tone::Normal,
      false};
  view.note = say("No machine link");
  return view;
}

}  // namespace

MachineView makeMachineView(const Picture& picture) {
  if (picture.info->linkLabel.isEmpty() && !(picture.snapshot && picture.snapshot->machine.valid)) {
    return withoutMachine(picture);
  }
  MachineView view;
  const QString rpm = rpmUnit(), feed = feedUnit(picture.units);
  const bool known = picture.snapshot && picture.snapshot->machine.valid;
  if (!known) {
    const QString none = number(std::nan(""));
    view.speed = {say("Speed"), none, none, none, rpm, Tone::Faint, true};
    view.feed = {say("Feed"), none, none, none, feed, Tone::Faint, true};
    view.warning = picture.snapshot != nullptr;
    if (!view.warning) return view;
    const bool starting = picture.snapshot->machine.block == OverrideInhibit::Starting;
    view.note = starting ? blocked(picture.snapshot->machine) : say("Nothing was read from the machine yet");
    return view;
  }
  const MachineState& m = picture.snapshot->machine;
  const bool measured = m.actualSpeed.value > 0.0 || m.link.speed != Instant{};
  view.speed = row(say("Speed"), rpm, m.programmedSpeed.value, m.speedOverride, m.operatorSpeed, m.actualSpeed.value);
  if (!measured) view.speed.actual = say("not measured");
  view.feed = row(say("Feed"), feed, feedIn(m.programmedFeed, picture.units), m.feedOverride, m.operatorFeed,
                  feedIn(m.actualFeed, picture.units));
  // Read after the block was recorded: as new as can be.
  const Seconds age =
      std::max(Seconds(), secondsBetween(m.time, picture.snapshot->time)) + (picture.stale ? picture.age : Seconds());
  view.note = simulationOver(picture) ? QString() : whatHinders(m, age);
  view.warning = !view.note.isEmpty();
  if (!view.warning) {
    view.note = simulationOver(picture) ? say("As the run ended") : knobs(m);
  }
  view.speed.old = view.feed.old = !m.linkUp || age > kOldAfter;
  return view;
}

double VibrationScale::fullFor(double rms, double limit) {
  double wanted = std::isfinite(limit) && limit > 0 ? 2.0 * limit : 0.0;
  if (std::isfinite(rms)) wanted = std::max(wanted, rms);
  if (wanted > full_ && wanted > 0) {
    const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
    const double lead = wanted / decade;
    full_ = decade * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
  }
  return full_;
}

std::vector<BarView> makeBars(const Picture& picture, VibrationScale& scale) {
  const bool live = picture.snapshot && !picture.stale;
  std::vector<BarView> bars{energyBar(picture, live), vibrationBar(picture, live, scale)};
  const int coherence = detectorIndex(*picture.info, QStringLiteral("coherence"));
  if (coherence >= 0) bars.push_back(coherenceBar(picture, live, coherence));
  return bars;
}

}  // namespace stillcut::ui
