#include "ui/report/report_text.h"

#include <QDateTime>
#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"
#include "ui/models/history/event_log.h"
#include "ui/models/session_models.h"
#include "ui/report/page_style.h"

namespace stillcut::ui {
namespace {

const QString kNothing = QStringLiteral("\u2013");
const QString kArrow = QStringLiteral(" \u2192 ");

QString text(const std::string& utf8) {
  return utf8.empty() ? kNothing : QString::fromStdString(utf8);
}

QString rpm(Rpm speed) {
  return speed.value > 0.0 ? number(speed.value) : kNothing;
}

// Without its unit.
QString feedNumber(MetresPerSecond feed, UnitSystem units) {
  return feed.value > 0.0 ? number(feedIn(feed, units), units == UnitSystem::Inch ? 1 : 0) : kNothing;
}

QString siText(SensorQuantity quantity) {
  const std::string_view unit = siUnit(quantity);
  return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString authorityText(Authority authority) {
  if (authority == Authority::Auto) return say("Auto: Stillcut commanded the overrides");
  if (authority == Authority::Advise) return say("Advise: Stillcut proposed");
  return say("Off: Stillcut watched");
}

QString healthText(SensorHealth health) {
  switch (health) {
    case SensorHealth::Dead:
      return say("no signal: check cable and supply");
    case SensorHealth::Clipped:
      return say("clipped: lower the gain");
    case SensorHealth::Offset:
      return say("large constant part: check coupling");
    case SensorHealth::Faint:
      return say("far weaker than the others: loose?");
    case SensorHealth::InOrder:
      break;
  }
  return say("in order");
}

QString outcome(const Intervention& i) {
  if (i.quiet) return say("stable");
  if (!i.finished) return say("cut ended");
  return toNs(i.commanded) > 0 ? say("not stable") : say("not answered");
}

// Something of our own scale instead of the last digits of a sum.
QString meanText(const SensorSummary& sensor) {
  return std::abs(sensor.mean) < 1e-3 * sensor.rms ? QStringLiteral("0") : significant(sensor.mean, 3);
}

// As the plots count, and by the clock where the recording tells it.
QString when(const SessionSummary& s, Instant time) {
  const QString seconds = join(number(sinceEpoch(time).value, 2), QStringLiteral("s"));
  if (s.started_ns <= 0) return seconds;
  return QStringLiteral("%1, %2").arg(clockTime((s.started_ns + toNs(time)) / 1'000'000), seconds);
}

std::size_t quietCount(const SessionSummary& s) {
  return static_cast<std::size_t>(
      std::count_if(s.interventions.begin(), s.interventions.end(),
                    [](const Intervention& i) { return i.quiet && toNs(i.commanded) > 0; }));
}

std::size_t movedCount(const SessionSummary& s) {
  return static_cast<std::size_t>(std::count_if(s.interventions.begin(), s.interventions.end(),
                                                [](const Intervention& i) { return toNs(i.commanded) > 0; }));
}

QString answerText(const SummaryAnswer& answer) {
  QStringList sentences;
  for (const Message& message : answer.sentences) {
    QString sentence = sayCore(message);
    if (sentence.isEmpty()) continue;
    sentence[0] = sentence[0].toUpper();
    sentences << sentence + u'.';
  }
  return sentences.join(u' ');
}

QString whatWasRecorded(const SessionSummary& s, UnitSystem units) {
  if (!s.session) {
    return say(
        "This recording holds measurements only: nobody decided while it was made. Vibration and "
        "spectrogram are shown as they are.");
  }
  if (s.alarms == 0) return say("No chatter was found.");
  const bool chatter = s.chatterTime.value > 0.0;  // else it was stopped, or went, at its onset
  QString words = !chatter        ? (s.alarms == 1 ? say("The onset of chatter was found once")
                                                   : say("The onset of chatter was found %1 times").arg(s.alarms))
                  : s.alarms == 1 ? say("Chatter began once")
                                  : say("Chatter began %1 times").arg(s.alarms);
  if (!s.interventions.empty() && s.interventions.front().frequency.value > 0.0) {
    words += say(", first at %1").arg(join(number(s.interventions.front().frequency.value), say("Hz")));
  }
  words += chatter ? say("; it lasted %1 in all").arg(duration(s.chatterTime)) : say("; it became no chatter");
  if (s.chatterLength.value > 0.0) words += say(" and marked %1 of path").arg(lengthText(s.chatterLength, units));
  words += QStringLiteral(". ");
  const std::size_t moved = movedCount(s);
  if (moved == 0) {
    return words + say("The overrides were not touched.");
  }
  // Counted by alarms: one may have taken several moves.
  words += s.alarms == 1 ? say("Stillcut moved speed and feed; ")
                         : say("Stillcut moved speed and feed after %1 of them; ").arg(moved);
  const std::size_t quiet = quietCount(s);
  if (quiet == moved)
    return words + (moved == 1 ? say("the cut was stable again.") : say("each time the cut was stable again."));
  if (quiet == 0) return words + say("it did not become stable before the cut ended.");
  return words + (quiet == 1 ? say("once the cut was stable again before it ended.")
                             : say("%1 times the cut was stable again before it ended.").arg(quiet));
}

}  // namespace

Facts cutFacts(const SessionSummary& s, UnitSystem units) {
  Facts facts;
  const CutSetup& setup = s.setup;
  if (s.started_ns > 0) {
    const QDateTime begun = QDateTime::fromMSecsSinceEpoch(s.started_ns / 1'000'000);
    facts.emplace_back(say("Date"), begun.toString(QStringLiteral("yyyy-MM-dd HH:mm t")));
  }
  if (!s.operatorName.empty()) facts.emplace_back(say("Operator"), text(s.operatorName));
  if (!s.job.empty()) facts.emplace_back(say("Job"), text(s.job));
  if (s.session) {
    facts.emplace_back(say("Machine"), text(setup.machine) + (s.simulated ? say(" (simulated)") : ""));
    facts.emplace_back(say("Tool"), text(setup.tool));
    if (setup.teeth > 0) {
      QString teeth = QString::number(setup.teeth);
      if (setup.toolDiameter.value > 0.0) teeth += say(", diameter ") + lengthText(setup.toolDiameter, units);
      facts.emplace_back(say("Flutes"), teeth);
    }
    facts.emplace_back(say("Programmed"), join(rpm(setup.nominalSpeed), rpmUnit()) + QStringLiteral(", ") +
                                              join(feedNumber(setup.nominalFeed, units), feedUnit(units)));
    facts.emplace_back(say("Authority"), authorityText(s.highestAuthority));
  }
  facts.emplace_back(say("Length"), duration(s.length));
  facts.emplace_back(say("Sensors"), say("%1 at %2 Hz").arg(setup.channels.size()).arg(number(setup.rate.value)));
  if (s.lostFrames > 0 || s.gaps > 0) {
    const double lost = static_cast<double>(s.lostFrames) / std::max(setup.rate.value, 1e-9);
    facts.emplace_back(say("Missing"), say("%1 in %2 gaps").arg(duration(Seconds(lost))).arg(s.gaps));
  }
  if (!s.session) facts.emplace_back(say("Format"), text(s.kind));
  if (!s.closedCleanly) facts.emplace_back(say("File"), say("not closed: ends where it was cut off"));
  if (!s.programVersion.empty())
    facts.emplace_back(say("Recorded by"), QStringLiteral("Stillcut ") + text(s.programVersion));
  return facts;
}

QString whatHappened(const SessionSummary& s, UnitSystem units) {
  if (s.answer && !s.session) return answerText(*s.answer);
  const QString recorded = whatWasRecorded(s, units);
  return s.answer ? recorded + u'\n' + say("Judged again: %1").arg(answerText(*s.answer)) : recorded;
}

Tone whatHappenedTone(const SessionSummary& s) {
  if (s.answer && !s.session) {
    return s.answer->finding == Finding::Chatter     ? Tone::Chatter
           : s.answer->finding == Finding::NotJudged ? Tone::Onset
                                                     : Tone::Normal;
  }
  if (!s.session || s.alarms == 0) return Tone::Normal;
  const bool lost = std::any_of(s.interventions.begin(), s.interventions.end(),
                                [](const Intervention& i) { return i.finished && !i.quiet; });
  return lost ? Tone::Chatter : Tone::Onset;
}

std::vector<TableColumn> interventionColumns(UnitSystem units) {
  return {{say("No."), 0.5, true},
          {say("At"), 0.9, true},
          {say("Chatter"), 1.1, true},
          {say("Speed [%1]").arg(rpmUnit()), 1.9, true},
          {say("Feed [%1]").arg(feedUnit(units)), 1.9, true},
          {say("Energy ratio"), 1.6, true},
          {say("Vibration rms"), 1.8, true},
          {say("Stable after"), 1.35, true},
          {say("Marked"), 1.0, true},
          {say("Outcome"), 1.4, false}};
}

std::vector<TableRow> interventionRows(const SessionSummary& s, UnitSystem units) {
  std::vector<TableRow> rows;
  for (const Intervention& i : s.interventions) {
    const bool moved = toNs(i.commanded) > 0;
    const auto pair = [moved](const QString& before, const QString& after) {
      return moved ? before + kArrow + after : before;
    };
    TableRow row;
    row.cells << QString::number(i.number + 1) << when(s, i.began) << join(number(i.frequency.value), say("Hz"))
              << pair(rpm(i.speedBefore), rpm(i.speedAfter))
              << pair(feedNumber(i.feedBefore, units), feedNumber(i.feedAfter, units))
              << pair(number(i.severityBefore.value, 2), number(i.severityAfter.value, 2))
              << pair(significant(i.vibrationBefore, 3), significant(i.vibrationAfter, 3))
              << (i.quiet ? duration(i.timeToStable) : kNothing)
              << (i.marked.value > 0.0 ? lengthText(i.marked, units) : kNothing) << outcome(i);
    row.tone = i.finished && !i.quiet ? Tone::Chatter : Tone::Normal;
    rows.push_back(row);
  }
  return rows;
}

std::vector<TableColumn> sensorColumns() {
  return {{say("Sensor"), 1.6, false}, {say("Quantity"), 1.6, false}, {say("Scale"), 1.6, true},
          {say("rms"), 1.0, true},     {say("Peak"), 1.0, true},      {say("Mean"), 1.0, true},
          {say("Unit"), 0.8, false},   {say("Check"), 3.0, false}};
}

std::vector<TableRow> sensorRows(const SessionSummary& s) {
  std::vector<TableRow> rows;
  for (const SensorSummary& sensor : s.sensors) {
    TableRow row;
    const std::string_view quantity = name(sensor.info.quantity);
    const QString unit = siText(sensor.info.quantity);
    row.cells << text(sensor.info.name)
              << QString::fromUtf8(quantity.data(), static_cast<qsizetype>(quantity.size())) +
                     (sensor.calibrated ? QString() : say(" (assumed)"))
              << QString::number(sensor.info.scale, 'g', 6) << significant(sensor.rms, 3) << significant(sensor.peak, 3)
              << meanText(sensor) << (sensor.calibrated ? unit : kNothing) << healthText(sensor.health);
    row.tone = sensor.health == SensorHealth::InOrder ? Tone::Normal
               : sensor.health == SensorHealth::Dead  ? Tone::Chatter
                                                      : Tone::Onset;
    rows.push_back(row);
  }
  return rows;
}

std::vector<TableColumn> eventColumns() {
  return {{say("At"), 0.7, true}, {say("Level"), 0.9, false}, {say("What"), 9.0, false}};
}

std::vector<TableRow> eventRows(const SessionSummary& s) {
  std::vector<TableRow> rows;
  for (const Event& event : s.events) {
    TableRow row;
    const QString level = event.level == EventLevel::Fault     ? say("fault")
                          : event.level == EventLevel::Warning ? say("warning")
                                                               : say("info");
    const bool onset = event.reason.code == ReasonCode::ChatterBegan && stayedOnset(s, event.time);
    row.cells << when(s, event.time) << level << (onset ? onsetText(event.reason) : reasonText(event.reason));
    if (event.level == EventLevel::Fault) row.tone = Tone::Chatter;
    rows.push_back(row);
  }
  return rows;
}

std::vector<TableColumn> markerColumns() {
  return {{say("At"), 0.9, true},
          {say("Length"), 0.9, true},
          {say("Marked as"), 2.0, false},
          {say("By"), 1.4, false},
          {say("Note"), 5.0, false}};
}

std::vector<TableRow> markerRows(const SessionSummary& s) {
  std::vector<TableRow> rows;
  for (const Marker& marker : s.markers) {
    TableRow row;
    const Seconds length = secondsBetween(marker.begin, marker.end);
    row.cells << when(s, marker.begin) << (length.value > 0.0 ? duration(length) : kNothing) << markerText(marker.label)
              << text(marker.author) << QString::fromStdString(marker.note);
    rows.push_back(row);
  }
  return rows;
}

std::vector<TableColumn> changeColumns() {
  return {{say("At"), 0.9, true}, {say("Parameter"), 4.0, false}, {say("Set to"), 4.0, false}};
}

std::vector<TableRow> changeRows(const SessionSummary& s) {
  std::vector<TableRow> rows;
  for (const SettingChange& change : s.settingChanges) {
    TableRow row;
    row.cells << join(number(change.time.value, 2), QStringLiteral("s"))
              << (change.key.empty() ? say("one this program does not know") : text(change.key)) << text(change.value);
    rows.push_back(row);
  }
  return rows;
}

QStringList settingLines(const SessionSummary& s) {
  QStringList lines;
  for (const QString& raw : QString::fromStdString(s.configuration).split(u'\n')) {
    const QString line = raw.section(QStringLiteral("  #"), 0, 0).trimmed();
    if (!line.isEmpty() && !line.startsWith(u'#')) lines << line;
  }
  return lines;
}

}  // namespace stillcut::ui
