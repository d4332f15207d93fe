// Reports and pictures of a recording: what they say, that nothing is left out, and that the files are whole.
#include "ui/report/report_files.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <cmath>

#include "ui/report/report_text.h"
#include "ui/report/spectrogram_picture.h"
#include "ui/report/table.h"

namespace stillcut::ui {
namespace {

constexpr std::size_t kToneBin = 40;
constexpr UnitSystem kMetric = UnitSystem::Metric;

Instant at(double seconds) {
  return Instant(toDuration(Seconds(seconds)));
}

// Ten seconds; chatter from 4 s, answered at 4.2 s, quiet at 4.6 s.
SessionSummary example() {
  SessionSummary s;
  s.file = "/tmp/cut.h5";
  s.kind = "Stillcut session";
  s.session = true;
  s.configuration = "[gate]\nhighest-speed = 12000  # rpm\n\n# a comment\nlowest-speed = 3000\n";
  s.setup.machine = "Mill 3";
  s.setup.tool = "T12 D12 Z4";
  s.setup.teeth = 4;
  s.setup.nominalSpeed = Rpm(8500.0);
  s.setup.rate = Hertz(25'600.0);
  s.length = Seconds(10.0);
  s.alarms = 1;
  s.chatterTime = Seconds(0.6);
  s.chatterLength = Metres(0.0123);
  s.highestAuthority = Authority::Auto;
  s.spectrumTop = Hertz(12'800.0);
  s.columnWidth = Seconds(0.1);
  for (int i = 0; i < 100; ++i) {
    SpectrumColumn column;
    column.time = at(0.05 + 0.1 * i);
    column.level_dB.fill(-60.0F);
    column.level_dB[kToneBin] = 0.0F;
    if (i >= 40 && i < 46) column.chatter = Hertz(1000.0);
    s.spectrogram.push_back(column);
    SummaryPoint point;
    point.time = Seconds(0.05 + 0.1 * i);
    point.valid = true;
    point.state = i >= 40 && i < 46 ? CutState::Chatter : CutState::Stable;
    point.vibration = point.state == CutState::Chatter ? 20.0 : 2.0;
    point.severity = point.state == CutState::Chatter ? 0.8 : 0.02;
    point.speed = Rpm(i < 42 ? 8500.0 : 8000.0);
    s.curve.push_back(point);
  }
  Intervention move;
  move.began = at(4.0);
  move.commanded = at(4.2);
  move.finished = move.quiet = true;
  move.timeToStable = Seconds(0.6);
  move.frequency = Hertz(1000.0);
  move.speedBefore = Rpm(8500.0);
  move.speedAfter = Rpm(8000.0);
  s.interventions.push_back(move);
  s.sensors.push_back({{"x", SensorQuantity::Acceleration, 9.8, "x"}, true, 0.0, 3.0, 20.0, SensorHealth::InOrder});
  s.sensors.push_back({{"mic", SensorQuantity::Sound, 1.0, ""}, true, 0.0, 0.0, 0.0, SensorHealth::Dead});
  return s;
}

QByteArray contentOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  return file.readAll();
}

int pagesOf(const QByteArray& pdf) {
  return static_cast<int>(pdf.count("/Type /Page\n") + pdf.count("/Type /Page "));
}

TEST(Report, WhatTheDetectorsSayOfARecordingIsItsAnswer) {
  SessionSummary sound;
  sound.kind = "WAV";
  EXPECT_TRUE(whatHappened(sound, kMetric).contains(QStringLiteral("measurements only")));
  sound.answer = SummaryAnswer{
      Finding::Chatter,
      {message("chatter at %1 Hz from %2 s on", "1502", "3.3"), message("judged %1 of %2 s", "6.0", "8.0")}};
  EXPECT_EQ(whatHappened(sound, kMetric).toStdString(), "Chatter at 1502 Hz from 3.3 s on. Judged 6.0 of 8.0 s.");
  EXPECT_EQ(whatHappenedTone(sound), Tone::Chatter);
  sound.answer->finding = Finding::NotJudged;
  EXPECT_EQ(whatHappenedTone(sound), Tone::Onset) << "not judged is no all-clear";
  SessionSummary session = example();
  const QString recorded = whatHappened(session, kMetric);
  session.answer = sound.answer;
  EXPECT_TRUE(whatHappened(session, kMetric).startsWith(recorded)) << "what was recorded stays as it was";
  EXPECT_TRUE(whatHappened(session, kMetric).contains(QStringLiteral("Judged again: Chatter at 1502 Hz")));
}

TEST(Report, IsAPdfThatGrowsWithWhatHappened) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("cut.pdf"));
  SessionSummary s = example();
  ASSERT_TRUE(writeReport(s, path, kMetric).ok());
  const QByteArray brief = contentOf(path);
  EXPECT_TRUE(brief.startsWith("%PDF-"));
  EXPECT_EQ(pagesOf(brief), 2);
  for (int i = 0; i < 200; ++i) s.interventions.push_back(s.interventions.front());
  ASSERT_TRUE(writeReport(s, path, kMetric).ok());
  EXPECT_GE(pagesOf(contentOf(path)), 6) << "forty rows a page";
}

TEST(Report, ItsNumbersCanBeSearchedAndCopied) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("cut.pdf"));
  ASSERT_TRUE(writeReport(example(), path, kMetric).ok());
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"), {path, QStringLiteral("-")});
  ASSERT_TRUE(reader.waitForFinished()) << "pdftotext (poppler-utils): " << qPrintable(reader.errorString());
  const QString text = QString::fromUtf8(reader.readAllStandardOutput());
  EXPECT_TRUE(text.contains(QStringLiteral("T12 D12 Z4"))) << qPrintable(text);
}

TEST(Report, OfAnEmptyRecordingIsStillAReport) {
  const QTemporaryDir folder;
  SessionSummary s;
  s.file = "empty.wav";
  s.sensors.push_back({});
  EXPECT_TRUE(writeReport(s, folder.filePath(QStringLiteral("e.pdf")), kMetric).ok());
  EXPECT_TRUE(writePicture(s, folder.filePath(QStringLiteral("e.png")), {800, 600}).ok());
}

TEST(Report, WhatCannotBeWrittenIsOneLineAndLeavesNothing) {
  const QTemporaryDir folder;
  const Status pdf = writeReport(example(), folder.filePath(QStringLiteral("no/such/cut.pdf")), kMetric);
  ASSERT_FALSE(pdf.ok());
  EXPECT_NE(pdf.error().line().find("cannot be written"), std::string::npos);
  EXPECT_FALSE(writePicture(example(), folder.filePath(QStringLiteral("cut.gif")), {800, 600}).ok());
  EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(Picture, PngHasItsSizeAndSvgIsWellFormed) {
  const QTemporaryDir folder;
  const QString png = folder.filePath(QStringLiteral("cut.png"));
  ASSERT_TRUE(writePicture(example(), png, {1000, 700}).ok());
  EXPECT_EQ(QImage(png).size(), QSize(1000, 700));
  const QString svg = folder.filePath(QStringLiteral("cut.svg"));
  ASSERT_TRUE(writePicture(example(), svg, {1000, 700}).ok());
  QXmlStreamReader xml(contentOf(svg));
  while (!xml.atEnd()) xml.readNext();
  EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
}

TEST(Picture, AToneLiesAtItsFrequencyAndAGapIsSeen) {
  SessionSummary s = example();
  s.spectrogram.erase(s.spectrogram.begin() + 60, s.spectrogram.begin() + 80);
  constexpr QRgb kGap = qRgb(1, 2, 3);
  const QImage image = spectrogramImage(s, s.spectrumTop, levelSpan(s), kGap);
  ASSERT_EQ(image.height(), kSpectrumBins);
  const int toneRow = kSpectrumBins - 1 - static_cast<int>(kToneBin);
  const int x = image.width() / 4;
  for (int y = 0; y < image.height(); ++y) {
    if (y == toneRow) continue;
    EXPECT_GT(qGreen(image.pixel(x, toneRow)), qGreen(image.pixel(x, y))) << y;
  }
  EXPECT_EQ(image.pixel(image.width() * 70 / 100, toneRow), kGap);
}

TEST(Picture, TheTopShowsThePowerAndTheChatterWithItsHarmonics) {
  SessionSummary s = example();
  EXPECT_GE(visibleTop(s).value, 3500.0) << "harmonics of 1000 Hz";
  EXPECT_LT(visibleTop(s).value, 12'800.0 / 2.0) << "nothing to see above";
  for (SpectrumColumn& column : s.spectrogram) column.level_dB.fill(-10.0F);
  EXPECT_DOUBLE_EQ(visibleTop(s).value, 12'800.0) << "noise everywhere";
}

TEST(ReportText, TellsWhatHappened) {
  SessionSummary s = example();
  EXPECT_EQ(
      whatHappened(s, kMetric).toStdString(),
      "Chatter began once, first at 1\u202f000\u00a0Hz; it lasted 600\u00a0ms in all and marked 12.3\u00a0mm of path. "
      "Stillcut moved speed and feed; the cut was stable again.");
  EXPECT_EQ(whatHappenedTone(s), Tone::Onset);
  s.interventions[0].quiet = false;
  EXPECT_EQ(whatHappenedTone(s), Tone::Chatter);
  s.interventions[0].commanded = Instant{};
  EXPECT_TRUE(whatHappened(s, kMetric).endsWith(QStringLiteral("The overrides were not touched.")));
  s.chatterTime = Seconds();
  s.chatterLength = Metres();
  EXPECT_EQ(whatHappened(s, kMetric).toStdString(),
            "The onset of chatter was found once, first at 1\u202f000\u00a0Hz; it became no chatter. "
            "The overrides were not touched.");
  s.alarms = 0;
  EXPECT_EQ(whatHappened(s, kMetric), QStringLiteral("No chatter was found."));
  s.session = false;
  EXPECT_TRUE(whatHappened(s, kMetric).contains(QStringLiteral("measurements only")));
}

TEST(ReportText, TablesHaveACellForEveryColumn) {
  const SessionSummary s = example();
  for (const TableRow& row : interventionRows(s, kMetric)) {
    EXPECT_EQ(row.cells.size(), static_cast<qsizetype>(interventionColumns(kMetric).size()));
  }
  const auto sensors = sensorRows(s);
  ASSERT_EQ(sensors.size(), 2U);
  EXPECT_EQ(sensors[0].cells.size(), static_cast<qsizetype>(sensorColumns().size()));
  EXPECT_EQ(sensors[0].tone, Tone::Normal);
  EXPECT_EQ(sensors[1].tone, Tone::Chatter) << "a dead sensor is a fault";
  EXPECT_EQ(settingLines(s), QStringList({QStringLiteral("[gate]"), QStringLiteral("highest-speed = 12000"),
                                          QStringLiteral("lowest-speed = 3000")}));
}

TEST(ReportText, LengthsAndFeedsAreInTheUnitsOfTheScreen) {
  SessionSummary s = example();
  s.setup.toolDiameter = Metres(12.7e-3);
  s.setup.nominalFeed = MetresPerSecond(2.54 / 60.0);
  s.interventions[0].feedBefore = s.setup.nominalFeed;
  s.interventions[0].feedAfter = s.setup.nominalFeed * 0.5;
  s.interventions[0].marked = Metres(25.4e-3);
  const auto all = [&](UnitSystem units) {
    QStringList words{whatHappened(s, units)};
    for (const auto& [fact, value] : cutFacts(s, units)) words << value;
    for (const TableColumn& column : interventionColumns(units)) words << column.title;
    for (const TableRow& row : interventionRows(s, units)) words << row.cells;
    return words.join(u'\n');
  };
  const QString inch = all(UnitSystem::Inch), metric = all(kMetric);
  for (const char* const metricWord : {"\u00a0mm", "[mm", "\u00a0m/min"}) {
    EXPECT_FALSE(inch.contains(QString::fromUtf8(metricWord))) << inch.toStdString();
  }
  for (const char* const word : {"0.500\u00a0in", "100.0\u00a0in/min", "[in/min]", "50.0", "1.000\u00a0in"}) {
    EXPECT_TRUE(inch.contains(QString::fromUtf8(word))) << word << " in\n" << inch.toStdString();
  }
  EXPECT_TRUE(metric.contains(QStringLiteral("[mm/min]")));
  EXPECT_TRUE(metric.contains(QStringLiteral("12.7\u00a0mm")));
  EXPECT_FALSE(metric.contains(QStringLiteral("in/min]")) && !metric.contains(QStringLiteral("mm/min]")));
}

QString factOf(const SessionSummary& s, const QString& name) {
  for (const auto& [fact, value] : cutFacts(s, kMetric)) {
    if (fact == name) return value;
  }
  return {};
}

TEST(ReportText, TellsWhenWhoAndForWhichJob) {
  SessionSummary s = example();
  EXPECT_TRUE(factOf(s, QStringLiteral("Date")).isEmpty()) << "a file that does not say so";
  s.started_ns = 1'795'335'000'000'000'000;  // 2026-11-22 08:10 UTC
  s.operatorName = "Ada";
  s.job = "Gehäuse 7";
  EXPECT_TRUE(factOf(s, QStringLiteral("Date")).startsWith(QStringLiteral("2026-11-22 ")))
      << factOf(s, QStringLiteral("Date")).toStdString();
  EXPECT_EQ(factOf(s, QStringLiteral("Operator")), QStringLiteral("Ada"));
  EXPECT_EQ(factOf(s, QStringLiteral("Job")), QString::fromUtf8("Gehäuse 7"));
}

TEST(ReportText, MarkersAndSettingsChangedDuringTheCutAreInTheReport) {
  SessionSummary s = example();
  s.markers = {{0, at(4.5), at(4.5), kLabelTrueAlarm, "Ada", "", 0},
               {1, at(6.0), at(7.5), "burr on the edge", "engineer", "measured 0.2 mm", 0}};
  s.settingChanges = {{Seconds(3.25), "energy-ratio.chatter", "0.3"}, {Seconds(5.0), "", ""}};
  const auto rows = markerRows(s);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].cells[2], QStringLiteral("true alarm"));
  EXPECT_EQ(rows[1].cells.join(u'|'),
            QString::fromUtf8("6.00\u00a0s|1.5\u00a0s|burr on the edge|engineer|measured 0.2 mm"));
  const auto changes = changeRows(s);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].cells.join(u'|'), QString::fromUtf8("3.25\u00a0s|energy-ratio.chatter|0.3"));
  EXPECT_EQ(rows[0].cells.size(), static_cast<qsizetype>(markerColumns().size()));
  EXPECT_EQ(changes[0].cells.size(), static_cast<qsizetype>(changeColumns().size()));
  const QTemporaryDir folder;
  const auto pages = [&folder](const SessionSummary& summary) {
    const QString path = folder.filePath(QStringLiteral("cut.pdf"));
    EXPECT_TRUE(writeReport(summary, path, kMetric).ok());
    return pagesOf(contentOf(path));
  };
  const int few = pages(s);
  s.markers.resize(100, s.markers.back());
  EXPECT_GE(pages(s), few + 2) << "every marker has its line";
  s.markers.resize(1);
  for (int k = 0; k < 300; ++k) s.markers[0].note += "\u6bdb\u523a";
  EXPECT_GE(pages(s), few) << "and a long note as many as it needs";
}

TEST(ReportText, AuthorityIsAWord) {
  SessionSummary s = example();
  s.events.push_back({at(1.0), 0, EventLevel::Info, {ReasonCode::AuthorityChanged, {0.0, 2.0, 0.0, 0.0}}});
  const auto rows = eventRows(s);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].cells.back(), QStringLiteral("Authority changed from Off to Auto"));
}

// In the width that they have on paper; nothing of it is lost.
TEST(ReportTable, LongCellsGoOnInTheNextLineAlsoWithoutSpaces) {
  const std::vector<TableColumn> columns{{QStringLiteral("At"), 1.0, true}, {QStringLiteral("Note"), 3.0}};
  const PageStyle style;
  constexpr double kTableWidth = 400.0;
  QString words, path = QStringLiteral("/");
  for (int k = 0; k < 40; ++k) words += QStringLiteral(" word%1").arg(k);
  for (int k = 0; k < 60; ++k) path += QStringLiteral("folder%1_").arg(k);
  const QString chinese = QString::fromUtf8("\u6bdb\u523a\u5728\u8fb9\u7f18\u4e0a").repeated(30);
  for (const QString& note : {words.trimmed(), path, chinese}) {
    SCOPED_TRACE(note.toStdString());
    const auto rows = wrapped(columns, {{{QStringLiteral("1.5"), note}, Tone::Onset}}, kTableWidth, style);
    ASSERT_GE(rows.size(), 4U);
    QStringList told;
    for (const TableRow& row : rows) {
      ASSERT_EQ(row.cells.size(), 2);
      EXPECT_LE(QFontMetricsF(style.font(11)).horizontalAdvance(row.cells[1]), kTableWidth * 0.75 + 0.5);
      EXPECT_EQ(row.tone, Tone::Onset);
      told << row.cells[1];
    }
    EXPECT_EQ(rows[0].cells[0], QStringLiteral("1.5"));
    EXPECT_TRUE(rows[1].cells[0].isEmpty());
    EXPECT_EQ(told.join(note.contains(u' ') ? QStringLiteral(" ") : QString()), note);
  }
  EXPECT_EQ(
      wrapped(columns, {{{QStringLiteral("1.5"), QStringLiteral("short")}, Tone::Normal}}, kTableWidth, style).size(),
      1U);
}

TEST(ReportTable, NumbersAreNeverCut) {
  const std::vector<TableColumn> columns{{QStringLiteral("At"), 0.2, true}, {QStringLiteral("What"), 9.0}};
  const QString number = QStringLiteral("14:00:03, 1234.56 s");
  const PageStyle style;
  const auto fit = fitted(columns, {{{number, QStringLiteral("alarm")}, Tone::Normal}}, 400.0, style);
  const double width = fit[0].share / (fit[0].share + fit[1].share) * (400.0 - 10.0);
  EXPECT_GE(width + 0.5, QFontMetricsF(style.font(11)).horizontalAdvance(number));
}

TEST(Report, IsAPageForABrowserAsWell) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("cut.html"));
  ASSERT_TRUE(writeByName(example(), file, kMetric).ok());
  QFile page(file);
  ASSERT_TRUE(page.open(QIODevice::ReadOnly));
  const QString text = QString::fromUtf8(page.readAll());
  EXPECT_TRUE(text.contains(QStringLiteral("<svg"))) << "the plots are in it";
  EXPECT_TRUE(text.contains(whatHappened(example(), kMetric).toHtmlEscaped()));
  EXPECT_FALSE(text.contains(QStringLiteral("src=\"http"))) << "nothing is fetched";
  EXPECT_TRUE(text.trimmed().endsWith(QStringLiteral("</html>")));
}

TEST(ReportTable, RowsThatDoNotFitAreLeftForTheNextPage) {
  QImage paper(400, 400, QImage::Format_RGB32);
  QPainter painter(&paper);
  const std::vector<TableRow> rows(25, TableRow{{QStringLiteral("a"), QStringLiteral("b")}, Tone::Normal});
  const std::vector<TableColumn> columns{{QStringLiteral("A")}, {QStringLiteral("B")}};
  int drawn = 0;
  int pages = 0;
  while (drawn < 25 && pages < 10) {
    double used = 0.0;
    drawn += drawTable(painter, QRectF(0, 0, 400, 11 * kTableRow), columns, rows, drawn, PageStyle(), used);
    EXPECT_LE(used, 11 * kTableRow);
    ++pages;
  }
  EXPECT_EQ(drawn, 25);
  EXPECT_EQ(pages, 3);
}

}  // namespace
}  // namespace stillcut::ui
