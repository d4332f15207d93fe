#include "ui/models/tap/tap_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr double kPerMicrometre = 1e-6;  // stiffness in N/um

QString axisName(int axis) {
  return axis == 1 ? QStringLiteral("y") : QStringLiteral("x");
}

// "872.1 ±0.4": no more digits than the doubt leaves.
QString withDoubt(double value, double doubt) {
  const int decimals = doubt > 0.0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(doubt))), 0, 3) : 1;
  return QStringLiteral("%1 \u00b1%2").arg(number(value, decimals), number(doubt, decimals));
}

double roundUp(double value) {
  if (!(value > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (value <= step * power) return step * power;
  }
  return 10.0 * power;
}

TapSign listeningSign(const TapListening& listening) {
  switch (listening.state) {
    case TapListening::State::Off:
      return {say("Choose a device"), say("Or open files of a tap test, or drop them here."), Tone::Faint};
    case TapListening::State::Opening:
      return {say("Opening the device"), {}, Tone::Faint};
    case TapListening::State::Failed:
      return {say("No samples"), listening.problem, Tone::Onset};
    case TapListening::State::Running:
      break;
  }
  if (listening.response < 0) return {say("No sensor"), say("None of its channels feels the tool."), Tone::Onset};
  return {say("Ready"),
          listening.force < 0 ? say("Without a hammer: frequencies, damping and speeds to try; no stiffness, no depth.")
                              : say("Press BEGIN, then hit the tip five times."),
          Tone::Normal};
}

QString lastFault(const std::vector<TapHitRow>& hits) {
  if (hits.empty() || hits.back().fault == TapFault::None || hits.back().used) return {};
  return say("Refused: %1.").arg(tapFaultText(hits.back().fault)) + QLatin1Char(' ');
}

}  // namespace

QString tapFaultText(TapFault fault) {
  switch (fault) {
    case TapFault::None:
      return say("good");
    case TapFault::DoubleHit:
      return say("double hit");
    case TapFault::ForceOverload:
      return say("overload of the hammer");
    case TapFault::ResponseOverload:
      return say("overload of the sensor");
    case TapFault::Weak:
      return say("too weak");
    case TapFault::TooSoon:
      return say("it still rang");
    case TapFault::Gap:
      return say("samples were lost");
    case TapFault::Incoherent:
      return say("differs from the others");
  }
  return {};
}

TapSign tapSign(const TapController& controller) {
  const TapFileReading& reading = controller.reading();
  if (reading.runs) return {say("Reading"), {}, Tone::Faint};
  if (!reading.problem.isEmpty()) {
    const bool asks = !reading.questions.empty() || reading.flipAsked;
    return {asks ? say("What the file does not say") : say("Not measured"), reading.problem, Tone::Onset};
  }
  if (!controller.files().isEmpty()) {
    return {say("From files"),
            QStringList(controller.files())
                .replaceInStrings(QRegularExpression(QStringLiteral("^.*/")), {})
                .join(QStringLiteral(", ")),
            Tone::Normal};
  }
  if (controller.listening().state == TapListening::State::Failed) return listeningSign(controller.listening());
  const TapRun run = controller.run();
  const QString count = say("%1 of %2 good hits along %3").arg(run.good).arg(run.wanted).arg(axisName(run.axis));
  switch (run.phase) {
    case TapRun::Phase::Off:
      return listeningSign(controller.listening());
    case TapRun::Phase::Settling:
      return {say("Be quiet"), say("The noise is being measured."), Tone::Normal};
    case TapRun::Phase::HitNow:
      return {say("HIT NOW"), lastFault(controller.hits(run.axis)) + count, Tone::Advice};
    case TapRun::Phase::Recording:
      return {say("Listening"), count, Tone::Normal};
    case TapRun::Phase::Ringing:
      return {say("Wait"), say("It still rings. %1").arg(count), Tone::Normal};
    case TapRun::Phase::Enough:
      return {say("Done along %1").arg(axisName(run.axis)),
              run.axis == 0 ? say("Turn hammer and sensor and measure y, or go on to MODES.") : say("Go on to MODES."),
              Tone::Normal};
  }
  return {};
}

TapQuestionText tapQuestion(TapQuestion question) {
  switch (question) {
    case TapQuestion::Hammer:
      return {say("Channel of the hammer"), say("its name, or its number from 0")};
    case TapQuestion::Sensor:
      return {say("Channel of the sensor"), say("its name, or its number from 0")};
    case TapQuestion::ForceUnit:
      return {say("Unit of the force"), QStringLiteral("N, kN, lbf, V")};
    case TapQuestion::ResponseUnit:
      return {say("Unit of the response"), QStringLiteral("m/s^2, g, mm/s, um, V")};
    case TapQuestion::ForceSensitivity:
      return {say("Sensitivity of the hammer"), QStringLiteral("2.25 mV/N")};
    case TapQuestion::ResponseSensitivity:
      return {say("Sensitivity of the sensor"), QStringLiteral("100 mV/g")};
    case TapQuestion::ForceFullScale:
      return {say("Force at full scale"), say("in the unit beside it")};
    case TapQuestion::ResponseFullScale:
      return {say("Response at full scale"), say("in the unit beside it")};
    case TapQuestion::Unit:
      return {say("Unit of the frequency response"), QStringLiteral("m/N, um/N, (m/s^2)/N, g/N")};
    case TapQuestion::FrequencyUnit:
      return {say("Unit of the frequencies"), QStringLiteral("Hz, kHz, rad/s")};
    case TapQuestion::PhaseUnit:
      return {say("Unit of the phase"), QStringLiteral("deg, rad")};
  }
  return {};
}

QStringList hitHeader(bool withForce) {
  return {say("Hit"), withForce ? say("Force") : say("Response"), withForce ? say("Width") : QString(), say("Judged")};
}

std::vector<TickRow> hitRows(const std::vector<TapHitRow>& hits, bool withForce) {
  std::vector<TickRow> rows;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const TapHitRow& hit = hits[i];
    TickRow row;
    row.cells << number(static_cast<double>(i + 1));
    row.cells << (withForce ? join(significant(hit.peak, 3), QStringLiteral("N")) : significant(hit.peak));
    row.cells << (hit.width.value > 0.0 ? join(number(1e3 * hit.width.value, 2), QStringLiteral("ms")) : QString());
    row.cells << (hit.file.isEmpty() ? tapFaultText(hit.fault)
                                     : QStringLiteral("%1, %2").arg(tapFaultText(hit.fault), hit.file));
    row.ticked = hit.used;
    row.hint = say("A touch takes it, or leaves it out");
    rows.push_back(std::move(row));
  }
  return rows;
}

QStringList modeHeader(bool withForce) {
  QStringList header{QStringLiteral("Hz"), say("Damping, %")};
  header << (withForce ? QStringLiteral("N/\u00b5m") : QString()) << say("Soft, %")
         << (withForce ? say("Coherence") : QString());
  return header;
}

std::vector<TickRow> modeRows(const TapResponse& response) {
  std::vector<TickRow> rows;
  for (const TapMode& m : response.modes) {
    TickRow row;
    row.cells << withDoubt(m.frequency.value, m.frequencySd) << withDoubt(100.0 * m.damping, 100.0 * m.dampingSd);
    row.cells << (m.stiffness > 0.0 ? withDoubt(kPerMicrometre * m.stiffness, kPerMicrometre * m.stiffnessSd)
                                    : QString());
    row.cells << number(100.0 * m.share);
    row.cells << (m.coherence > 0.0 ? number(m.coherence, 3) : QString());
    row.ticked = m.used;
    row.hint = m.doubt;
    rows.push_back(std::move(row));
  }
  return rows;
}

BarView tapMeter(const TapChannel& channel) {
  const double full = roundUp(std::max(channel.most, 1e-3));
  BarView bar;
  bar.label = channel.name;
  bar.value = join(significant(channel.level), channel.unit);
  bar.fraction = std::clamp(channel.level / full, 0.0, 1.0);
  bar.known = true;
  bar.tone = channel.clipped ? Tone::Onset : Tone::Normal;
  bar.counts = true;
  bar.full = join(significant(full), channel.unit);
  return bar;
}

TapSign tapAnswer(const TapLobes& lobes, UnitSystem units) {
  switch (lobes.state) {
    case TapLobes::State::None:
      return {say("No modes yet"), say("Measure first, or tick a mode under MODES."), Tone::Faint};
    case TapLobes::State::Working:
      return {say("Computing"), {}, Tone::Faint};
    case TapLobes::State::Failed:
      return {say("Cannot be computed"), lobes.problem, Tone::Onset};
    case TapLobes::State::Done:
      break;
  }
  if (lobes.limits.empty()) {
    QStringList speeds;
    for (const TapSpeed& s : lobes.toTry) speeds << number(s.speed.value);
    constexpr qsizetype kMost = 6;
    const QString more = speeds.size() > kMost ? QStringLiteral(" \u2026") : QString();
    return {say("Try %1 rpm").arg(speeds.mid(0, 1).join(QString())),
            say("Speeds to try: %1. At these the tool swings whole times between two teeth. How deep cannot be told: "
                "that takes the force of a hammer.")
                .arg(QStringList(speeds.mid(0, kMost)).join(QStringLiteral(", ")) + more),
            Tone::Advice};
  }
  const QString at = say("%1 rpm, %2").arg(number(lobes.speed.value), depthText(lobes.depth, units));
  QString detail = say("Removes %1. At any speed only %2 deep.")
                       .arg(removalText(lobes.removal, units), depthText(lobes.anySpeed, units));
  detail += QLatin1Char(' ');
  if (lobes.rigid >= 0) {
    detail +=
        say("Nothing was measured along %1: taken as rigid there. The true limit may be far lower; measure it first.")
            .arg(axisName(lobes.rigid));
    return {at, detail, Tone::Onset};
  }
  detail += lobes.open ? say("The tool's length ends it, not chatter.")
                       : say("Nine times in ten the true limit lies deeper; a tenth is taken off besides.");
  return {at, detail, Tone::Advice};
}

}  // namespace stillcut::ui
