#include "ui/report/report_text.h"

#include <algorithm>
#include <cmath>

#include "ui/models/format.h"
#include "ui/models/reason_text.h"
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

QString mmPerMin(MetresPerSecond feed) {
  return feed.value > 0.0 ? number(toMmPerMin(feed)) : kNothing;
}

QString siText(SensorQuantity quantity) {
  const std::string_view unit = siUnit(quantity);
  return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString authorityText(Authority authority) {
  if (authority == Authority::Auto) return reportText("Auto: Stillcut commanded the overrides");
  if (authority == Authority::Advise) return reportText("Advise: Stillcut proposed");
  return reportText("Off: Stillcut watched");
}

QString healthText(SensorHealth health) {
  switch (health) {
    case SensorHealth::Dead:
      return reportText("no signal: check cable and supply");
    case SensorHealth::Clipped:
      return reportText("clipped: lower the gain");
    case SensorHealth::Offset:
      return reportText("large constant part: check coupling");
    case SensorHealth::Faint:
      return reportText("far weaker than the others: loose?");
    case SensorHealth::InOrder:
      break;
  }
  return reportText("in order");
}

QString outcome(const Intervention& i) {
  if (i.quiet) return reportText("quiet");
  if (!i.finished) return reportText("cut ended");
  return toNs(i.commanded) > 0 ? reportText("not quiet") : reportText("not answered");
}

// Something of our own scale instead of the last digits of a sum.
QString meanText(const SensorSummary& sensor) {
  return std::abs(sensor.mean) < 1e-3 * sensor.rms ? QStringLiteral("0") : significant(sensor.mean, 3);
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

}  // namespace

Facts cutFacts(const SessionSummary& s) {
  Facts facts;
  const CutSetup& setup = s.setup;
  if (s.session) {
    facts.emplace_back(reportText("Machine"), text(setup.machine) + (s.simulated ? reportText(" (simulated)") : ""));
    facts.emplace_back(reportText("Tool"), text(setup.tool));
    if (setup.teeth > 0) {
      QString teeth = QString::number(setup.teeth);
      if (setup.toolDiameter.value > 0.0) teeth += reportText(", diameter ") + millimetres(setup.toolDiameter);
      facts.emplace_back(reportText("Teeth"), teeth);
    }
    facts.emplace_back(reportText("Programmed"), join(rpm(setup.nominalSpeed), reportText("rpm")) +
                                                     QStringLiteral(", ") +
                                                     join(mmPerMin(setup.nominalFeed), reportText("mm/min")));
    facts.emplace_back(reportText("Authority"), authorityText(s.highestAuthority));
  }
  facts.emplace_back(reportText("Length"), duration(s.length));
  facts.emplace_back(reportText("Sensors"),
                     reportText("%1 at %2 Hz").arg(s.sensors.size()).arg(number(setup.rate.value)));
  if (s.lostFrames > 0 || s.gaps > 0) {
    const double lost = static_cast<double>(s.lostFrames) / std::max(setup.rate.value, 1e-9);
    facts.emplace_back(reportText("Missing"), reportText("%1 in %2 gaps").arg(duration(Seconds(lost))).arg(s.gaps));
  }
  if (!s.session) facts.emplace_back(reportText("Format"), text(s.kind));
  if (!s.closedCleanly) facts.emplace_back(reportText("File"), reportText("not closed: ends where it was cut off"));
  if (!s.programVersion.empty())
    facts.emplace_back(reportText("Recorded by"), QStringLiteral("Stillcut ") + text(s.programVersion));
  return facts;
}

QString whatHappened(const SessionSummary& s) {
  if (!s.session) {
    return reportText(
        "This recording holds measurements only: nobody decided while it was made. Vibration and "
        "spectrogram are shown as they are.");
  }
  if (s.alarms == 0) return reportText("No chatter was found.");
  QString words = s.alarms == 1 ? reportText("Chatter began once") : reportText("Chatter began %1 times").arg(s.alarms);
  if (!s.interventions.empty() && s.interventions.front().frequency.value > 0.0) {
    words += reportText(", first at %1").arg(join(number(s.interventions.front().frequency.value), reportText("Hz")));
  }
  words += reportText("; it lasted %1 in all").arg(duration(s.chatterTime));
  if (s.chatterLength.value > 0.0) words += reportText(" and marked %1 of path").arg(millimetres(s.chatterLength));
  words += QStringLiteral(". ");
  const std::size_t moved = movedCount(s);
  if (moved == 0) {
    return words + reportText("The overrides were not touched.");
  }
  words += moved == 1 ? reportText("Stillcut moved speed and feed once; ")
                      : reportText("Stillcut moved speed and feed %1 times; ").arg(moved);
  const std::size_t quiet = quietCount(s);
  if (quiet == moved)
    return words +
           (moved == 1 ? reportText("the cut was quiet again.") : reportText("each time the cut was quiet again."));
  if (quiet == 0) return words + reportText("it did not become quiet before the cut ended.");
  return words + (quiet == 1 ? reportText("once the cut was quiet again before it ended.")
                             : reportText("%1 times the cut was quiet again before it ended.").arg(quiet));
}

Tone whatHappenedTone(const SessionSummary& s) {
  if (!s.session || s.alarms == 0) return Tone::Normal;
  const bool lost = std::any_of(s.interventions.begin(), s.interventions.end(),
                                [](const Intervention& i) { return i.finished && !i.quiet; });
  return lost ? Tone::Chatter : Tone::Onset;
}

std::vector<TableColumn> interventionColumns() {
  return {{reportText("No."), 0.5, true},           {reportText("At"), 0.9, true},
          {reportText("Chatter"), 1.1, true},       {reportText("Speed [rpm]"), 1.9, true},
          {reportText("Feed [mm/min]"), 1.9, true}, {reportText("Energy ratio"), 1.6, true},
          {reportText("Vibration rms"), 1.8, true}, {reportText("Quiet after"), 1.35, true},
          {reportText("Marked"), 1.0, true},        {reportText("Outcome"), 1.4, false}};
}

std::vector<TableRow> interventionRows(const SessionSummary& s) {
  std::vector<TableRow> rows;
  for (const Intervention& i : s.interventions) {
    const bool moved = toNs(i.commanded) > 0;
    const auto pair = [moved](const QString& before, const QString& after) {
      return moved ? before + kArrow + after : before;
    };
    TableRow row;
    row.cells << QString::number(i.number + 1) << join(number(sinceEpoch(i.began).value, 2), QStringLiteral("s"))
              << join(number(i.frequency.value), reportText("Hz")) << pair(rpm(i.speedBefore), rpm(i.speedAfter))
              << pair(mmPerMin(i.feedBefore), mmPerMin(i.feedAfter))
              << pair(number(i.severityBefore.value, 2), number(i.severityAfter.value, 2))
              << pair(significant(i.vibrationBefore, 3), significant(i.vibrationAfter, 3))
              << (i.quiet ? duration(i.timeToQuiet) : kNothing)
              << (i.marked.value > 0.0 ? millimetres(i.marked) : kNothing) << outcome(i);
    row.tone = i.finished && !i.quiet ? Tone::Chatter : Tone::Normal;
    rows.push_back(row);
  }
  return rows;
}

std::vector<TableColumn> sensorColumns() {
  return {{reportText("Sensor"), 1.6, false}, {reportText("Quantity"), 1.6, false}, {reportText("Scale"), 1.6, true},
          {reportText("rms"), 1.0, true},     {reportText("Peak"), 1.0, true},      {reportText("Mean"), 1.0, true},
          {reportText("Unit"), 0.8, false},   {reportText("Check"), 3.0, false}};
}

std::vector<TableRow> sensorRows(const SessionSummary& s) {
  std::vector<TableRow> rows;
  for (const SensorSummary& sensor : s.sensors) {
    TableRow row;
    const std::string_view quantity = name(sensor.info.quantity);
    const QString unit = siText(sensor.info.quantity);
    row.cells << text(sensor.info.name)
              << QString::fromUtf8(quantity.data(), static_cast<qsizetype>(quantity.size())) +
                     (sensor.calibrated ? QString() : reportText(" (assumed)"))
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
  return {{reportText("At"), 0.7, true}, {reportText("Level"), 0.9, false}, {reportText("What"), 9.0, false}};
}

std::vector<TableRow> eventRows(const SessionSummary& s) {
  std::vector<TableRow> rows;
  for (const Event& event : s.events) {
    TableRow row;
    const QString level = event.level == EventLevel::Fault     ? reportText("fault")
                          : event.level == EventLevel::Warning ? reportText("warning")
                                                               : reportText("info");
    row.cells << join(number(sinceEpoch(event.time).value, 2), QStringLiteral("s")) << level
              << reasonText(event.reason);
    if (event.level == EventLevel::Fault) row.tone = Tone::Chatter;
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
