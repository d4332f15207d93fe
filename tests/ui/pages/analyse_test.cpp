// The Analyse page driven as the engineer at the desk would: mouse, wheel, keys, typing.
#include <QComboBox>
#include <QLineEdit>
#include <QTemporaryDir>
#include <cmath>

#include "tests/ui/support/analyse_fixture.h"
#include "ui/plots/spectrum_plot.h"
#include "ui/plots/trace_plot.h"
#include "ui/plots/track_plot.h"

namespace stillcut::ui {
namespace {

TEST_F(Analyse, ClicksPutCursorsThatStay) {
  openPage();
  auto* map = find<HistoryMap>();
  QTest::mouseClick(map, Qt::LeftButton, {}, inMap(0.5, 0.5));
  ASSERT_TRUE(view().cursor(AnalyseView::A));
  const Instant a = *view().cursor(AnalyseView::A);
  EXPECT_NEAR(secondsBetween(a, view().newest()).value, 5.0, 0.1);
  QTest::mouseClick(map, Qt::LeftButton, Qt::ShiftModifier, inMap(0.75, 0.5));
  ASSERT_TRUE(view().cursor(AnalyseView::B));
  play(2.0);
  EXPECT_EQ(view().cursor(AnalyseView::A), a);
  EXPECT_TRUE(find<SpectrumPlot>()->spectrum().atCursor);
  QTest::keyClick(map, Qt::Key_Delete);
  EXPECT_FALSE(view().cursor(AnalyseView::A));
}

TEST_F(Analyse, DragMovesWheelZoomsEndFollows) {
  openPage();
  auto* map = find<HistoryMap>();
  const Instant newest = view().newest();
  drag(map, inMap(0.3, 0.5), inMap(0.5, 0.5));
  EXPECT_FALSE(view().following());
  EXPECT_NEAR(secondsBetween(view().to(), newest).value, 2.0, 0.2);
  const Seconds before = view().options().span;
  wheel(map, inMap(0.5, 0.5), 2);
  EXPECT_NEAR(view().options().span / before, 0.64, 1e-6);
  const Hertz high = view().options().high;
  wheel(map, inMap(0.5, 0.9), 1, Qt::ControlModifier);
  EXPECT_LT(view().options().high, high);
  QTest::keyClick(map, Qt::Key_End);
  EXPECT_TRUE(view().following());
}

TEST_F(Analyse, ControlAndDragZoomsToTheStretchDrawnOver) {
  openPage();
  auto* map = find<HistoryMap>();
  const Instant from = map->timeAt(inMap(0.5, 0.5).x()), to = map->timeAt(inMap(0.7, 0.5).x());
  drag(map, inMap(0.5, 0.5), inMap(0.7, 0.5), Qt::ControlModifier);
  EXPECT_NEAR(secondsBetween(from, view().from()).value, 0.0, 0.05);
  EXPECT_NEAR(secondsBetween(to, view().to()).value, 0.0, 0.05);
}

TEST_F(Analyse, EveryKeyAndButtonOfTheRowChangesThePicture) {
  openPage();
  auto* map = find<HistoryMap>();
  map->setFocus();
  const auto& options = [this]() -> const AnalyseOptions& { return view().options(); };
  QTest::keyClick(map, Qt::Key_W);
  EXPECT_EQ(options().form, SpectrogramForm::Waterfall);
  press("waterfall");
  EXPECT_EQ(options().form, SpectrogramForm::HeatMap);
  const QImage decibel = map->grab().toImage();
  QTest::keyClick(map, Qt::Key_L);
  EXPECT_EQ(options().level, LevelScale::Linear);
  EXPECT_GT(differentPixels(decibel, map->grab().toImage()), 1000);
  press("order");
  EXPECT_EQ(options().axis, FrequencyAxis::Order);
  QTest::keyClick(map, Qt::Key_M);
  EXPECT_TRUE(options().maxHold);
  tick(40);
  EXPECT_TRUE(find<SpectrumPlot>()->spectrum().hold);
  QTest::keyClick(map, Qt::Key_R);
  EXPECT_TRUE(find<SpectrumPlot>()->hasReference());
  QTest::keyClick(map, Qt::Key_R);
  EXPECT_FALSE(find<SpectrumPlot>()->hasReference());
  QTest::keyClick(map, Qt::Key_Space);
  EXPECT_FALSE(view().following());
}

TEST_F(Analyse, HarmonicCursorByClickAndOnTheStrongestLine) {
  openPage();
  auto* spectrum = find<SpectrumPlot>();
  QTest::mouseClick(spectrum, Qt::LeftButton, {}, QPoint(spectrum->width() / 2, spectrum->height() / 2));
  ASSERT_TRUE(view().harmonic());
  QTest::keyClick(spectrum, Qt::Key_H);
  tick(40);
  EXPECT_FALSE(spectrum->spectrum().reading.isEmpty());
  EXPECT_FALSE(spectrum->accessibleDescription().isEmpty());
  const Hertz at = *view().harmonic();
  QTest::keyClick(spectrum, Qt::Key_Right);
  EXPECT_GT(*view().harmonic(), at);
  QTest::keyClick(spectrum, Qt::Key_Delete);
  EXPECT_FALSE(view().harmonic());
}

// What a level is counted from stands beside it, and cursors read levels, not only times.
TEST_F(Analyse, LevelsHaveTheirUnitAndAreReadAtTheCursors) {
  openPage();
  auto* map = find<HistoryMap>();
  const QRect header(map->plotRect().left(), 0, map->plotRect().width(), map->plotRect().top());
  const QImage key = map->grab(header).toImage();
  int colourful = 0;
  for (int x = 0; x < key.width(); ++x) colourful += key.pixelColor(x, key.height() / 2).hsvSaturation() > 100 ? 1 : 0;
  EXPECT_GT(colourful, 80) << "the palette beside the title";
  EXPECT_EQ(find<SpectrumPlot>()->spectrum().unit, QStringLiteral("m/s\u00b2"));
  EXPECT_EQ(decibelUnit(find<SpectrumPlot>()->spectrum().unit), QStringLiteral("dB re 1 m/s\u00b2"));
  view().setHarmonic(Hertz(1713));
  QTest::mouseClick(map, Qt::LeftButton, {}, inMap(0.5, 0.5));
  tick(40);
  const QString alone = find<SpectrumPlot>()->spectrum().reading;
  EXPECT_TRUE(alone.endsWith(QStringLiteral("dB"))) << alone.toStdString();
  QTest::mouseClick(map, Qt::LeftButton, Qt::ShiftModifier, inMap(0.97, 0.5));
  tick(40);
  const QString both = find<SpectrumPlot>()->spectrum().reading;
  EXPECT_TRUE(both.startsWith(alone) && both.contains("B:")) << both.toStdString();
  press("linear");
  tick(40);
  EXPECT_TRUE(find<SpectrumPlot>()->spectrum().reading.endsWith(QStringLiteral("m/s\u00b2")));
}

// The limit of a detector that has one is a line across its row; a reading stands beside each cursor.
TEST_F(Analyse, TracksHaveTheirScaleTheirLimitAndReadings) {
  openPage();
  auto* tracks = find<TrackPlot>();
  const QImage with = tracks->grab().toImage();
  session_.mutableInfo().limits.energyRatio = std::nan("");
  session_.mutableInfo().limits.coherence = std::nan("");
  session_.touch();
  tick(40);
  const QImage without = tracks->grab().toImage();
  const QRect plot = tracks->plotRect();
  const auto changedRows = [&](const QImage& a, const QImage& b) {
    int rows = 0;
    for (int y = plot.top(); y <= plot.bottom(); ++y) {
      int count = 0;
      for (int x = plot.left(); x < plot.left() + plot.width() / 3; ++x)
        count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
      rows += count > plot.width() / 12 ? 1 : 0;
    }
    return rows;
  };
  EXPECT_GE(changedRows(with, without), 2) << "one limit in each of two rows";
  QTest::mouseClick(find<HistoryMap>(), Qt::LeftButton, {}, inMap(0.5, 0.5));
  const QImage read = tracks->grab().toImage();
  const int x = static_cast<int>(tracks->xOf(*view().cursor(AnalyseView::A))) + 3;
  const QRect beside(x, plot.top(), 24, 16);
  EXPECT_GT(differentPixels(without.copy(beside), read.copy(beside)), 100);
}

TEST_F(Analyse, GoToAMomentByTyping) {
  openPage();
  auto* moment = find<QLineEdit>("moment");
  QTest::keyClicks(moment, "-3");
  QTest::keyClick(moment, Qt::Key_Return);
  ASSERT_TRUE(view().cursor(AnalyseView::A));
  EXPECT_NEAR(secondsBetween(*view().cursor(AnalyseView::A), view().newest()).value, 3.0, 1e-6);
  EXPECT_FALSE(view().following());
  view().follow();
  moment->clear();
  QTest::keyClicks(moment, "half past");
  press("go-to");
  EXPECT_TRUE(view().following()) << "what is no moment moves nothing";
}

TEST_F(Analyse, ChannelChoiceReachesTheSession) {
  openPage();
  auto* channel = find<QComboBox>("channel");
  ASSERT_EQ(channel->count(), 2);
  QTest::keyClick(channel, Qt::Key_Down);
  emit channel->activated(channel->currentIndex());
  play(0.2);
  EXPECT_EQ(session_.shownChannel(), 1);
}

TEST_F(Analyse, APresetIsSavedUsedAndOutlivesARestart) {
  const QTemporaryDir folder;
  session_.keepStateIn(folder.path());
  openPage();
  press("order");
  auto* names = find<QComboBox>("preset");
  names->lineEdit()->selectAll();
  QTest::keyClicks(names->lineEdit(), "my orders");
  press("save-preset");
  press("order");
  window_->close();
  window_.reset();

  open();
  press("page-analyse");
  EXPECT_EQ(view().options().axis, FrequencyAxis::Hertz) << "as it was left";
  names = find<QComboBox>("preset");
  const int row = names->findText("my orders");
  ASSERT_GE(row, 0);
  names->setCurrentIndex(row);
  emit names->activated(row);
  EXPECT_EQ(view().options().axis, FrequencyAxis::Order);
}

TEST_F(Analyse, MissingSamplesAreShadedAndAStalePictureSaysSo) {
  openPage();
  auto* trace = find<TracePlot>();
  const QImage whole = trace->grab().toImage();
  session_.lose(Seconds(0.4));
  play(1.0);
  const QRect plot = trace->plotRect();
  const int x = static_cast<int>(trace->xOf(session_.snapshot().time - toDuration(Seconds(0.8))));
  ASSERT_TRUE(plot.contains(x, plot.center().y()));
  EXPECT_NE(trace->grab().toImage().pixel(x, plot.top() + 3), whole.pixel(x, plot.top() + 3));
  const QImage live = find<HistoryMap>()->grab().toImage();
  tick(2000);
  EXPECT_GT(differentPixels(live, find<HistoryMap>()->grab().toImage()), 1000);
}

TEST_F(Analyse, ALimitThatIsMovedHoldsFromThenOn) {
  session_.mutableInfo().limits.energyRatio = 0.2;
  openPage();
  const Instant before = session_.snapshot().time;
  session_.mutableInfo().limits.energyRatio = 0.35;
  play(1.0);
  const auto* tracks = find<TrackPlot>();
  EXPECT_DOUBLE_EQ(tracks->limitAt(0, before), 0.2) << "the past was judged by that";
  EXPECT_DOUBLE_EQ(tracks->limitAt(0, session_.snapshot().time), 0.35);
}

}  // namespace
}  // namespace stillcut::ui
