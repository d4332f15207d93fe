// The spectrogram with its other axes: in the waterfall frequency lies to the right and time upwards, on the order axis
// every column has a stretch of its own. What is drawn over it and what moves it must follow.
#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/ui/support/analyse_fixture.h"
#include "tests/ui/support/page_picture.h"
#include "ui/plots/spectrogram/waterfall_stack.h"

namespace stillcut::ui {
namespace {

class WaterfallPage : public Analyse {
 protected:
  void openWaterfall() {
    openPage();
    press("waterfall");
    ASSERT_EQ(view().options().form, SpectrogramForm::Waterfall);
  }
  HistoryMap* map() const { return find<HistoryMap>(); }
  Seconds reach() const { return secondsBetween(view().to(), view().newest()); }
  Hertz width() const { return view().options().high - view().options().low; }
  double xOf(Hertz f) const {
    const QRect plot = map()->plotRect();
    return plot.left() + (f - view().options().low) / width() * plot.width();
  }
  // Pixels of about this colour.
  static int count(const QImage& image, const QRect& where, const QColor& color) {
    int found = 0;
    for (int y = where.top(); y <= where.bottom(); ++y) {
      for (int x = where.left(); x <= where.right(); ++x) {
        const QColor c = image.pixelColor(x, y);
        found +=
            std::abs(c.red() - color.red()) + std::abs(c.green() - color.green()) + std::abs(c.blue() - color.blue()) <
                    24
                ? 1
                : 0;
      }
    }
    return found;
  }
  const ThemeColors colors_ = themeColors(ThemeKind::Light);
};

TEST_F(WaterfallPage, DragsWheelAndKeysMoveTheAxesAsTheyAreDrawn) {
  openWaterfall();
  AnalyseOptions o = view().options();
  o.low = Hertz(1000);
  o.high = Hertz(3000);
  view().setOptions(o);
  drag(map(), inMap(0.5, 0.5), inMap(0.25, 0.5));
  EXPECT_TRUE(view().following()) << "along the axis of frequency time stands";
  EXPECT_NEAR(view().options().low.value, 1500.0, 20.0);
  EXPECT_NEAR(width().value, 2000.0, 1e-6);

  const Hertz pointed = view().options().low + width() * 0.25;
  wheel(map(), inMap(0.25, 0.5), 1);
  EXPECT_NEAR(width().value, 1600.0, 1e-6);
  EXPECT_NEAR((view().options().low + width() * 0.25).value, pointed.value, 5.0) << "what is pointed at stays";
  EXPECT_EQ(view().options().span, o.span);
  wheel(map(), inMap(0.25, 0.9), 1, Qt::ControlModifier);
  EXPECT_NEAR(view().options().span / o.span, 0.8, 1e-6);
  EXPECT_NEAR(width().value, 1600.0, 1e-6);

  const Hertz low = view().options().low;
  QTest::keyClick(map(), Qt::Key_Right);
  EXPECT_GT(view().options().low, low);
  EXPECT_TRUE(view().following());
  drag(map(), inMap(0.5, 0.3), inMap(0.5, 0.5));
  EXPECT_FALSE(view().following()) << "down the stack lies the past";
  EXPECT_GT(reach().value, 1.0);
}

TEST_F(WaterfallPage, ControlAndDragZoomsToTheFrequenciesDrawnOver) {
  openWaterfall();
  const AnalyseOptions before = view().options();
  drag(map(), inMap(0.2, 0.5), inMap(0.6, 0.5), Qt::ControlModifier);
  EXPECT_NEAR(view().options().low.value, before.high.value * 0.2, 20.0);
  EXPECT_NEAR(view().options().high.value, before.high.value * 0.6, 20.0);
  EXPECT_EQ(view().options().span, before.span);
}

TEST_F(WaterfallPage, ACursorIsASpectrumOfTheStackWithItsLetter) {
  openWaterfall();
  play(3.0);
  const QImage plain = map()->grab().toImage();
  const QRect plot = map()->plotRect();
  QTest::mouseClick(map(), Qt::LeftButton, {}, inMap(0.97, 0.7));
  QTest::mouseClick(map(), Qt::LeftButton, Qt::ShiftModifier, inMap(0.97, 0.9));
  ASSERT_TRUE(view().cursor(AnalyseView::A) && view().cursor(AnalyseView::B));
  const Instant a = *view().cursor(AnalyseView::A);
  EXPECT_GT(secondsBetween(a, *view().cursor(AnalyseView::B)).value, 1.0) << "lower is newer";

  const QImage marked = map()->grab().toImage();
  const QRect beside(plot.right() + 2, plot.top(), map()->width() - plot.right() - 2, plot.height());
  EXPECT_EQ(count(plain, beside, colors_.advice), 0);
  EXPECT_GT(count(marked, beside, colors_.advice), 40) << "the flag of A";
  EXPECT_GT(count(marked, plot, colors_.advice), plot.width() / 2) << "the spectrum itself";
  const int x = static_cast<int>(map()->xOf(a));
  EXPECT_LT(count(marked, QRect(x - 1, plot.top(), 3, plot.height()), colors_.advice), plot.height() / 4)
      << "no line at the time it would have along the lower axis";
  play(0.4);
  EXPECT_EQ(view().cursor(AnalyseView::A), a);
  EXPECT_GT(count(map()->grab().toImage(), plot, colors_.advice), plot.width() / 2) << "it stays among the others";
}

TEST(WaterfallStack, APeakThatHidesOthersIsWhatAClickTakes) {
  FakeSession session;
  RunHistory history;
  for (int k = 0; k < 220; ++k) {
    session.advance(Seconds(0.04));
    history.see(*session.pull());
  }
  AnalyseView view;
  view.setReach(history.begin(), history.end(), history.spectrumTop());
  const WaterfallStack stack(history, view, QRect(0, 0, 800, 400), [](float level_dB) {
    return std::clamp((static_cast<double>(level_dB) + 60.0) / 60.0, 0.0, 1.0);
  });
  ASSERT_GT(stack.lines().size(), 20U);
  const SpectrumColumn& front = *stack.lines().back().column;
  const double x = stack.xOf(Hertz(1713), front), crest = stack.crestAt(front, x);
  EXPECT_LT(crest, stack.footOf(stack.lines()[stack.lines().size() - 4].column->time)) << "it hides the ones behind";
  EXPECT_EQ(&stack.under({x, crest + 5.0}), &front);
  EXPECT_NE(&stack.under({x, crest - 30.0}), &front);
}

TEST_F(WaterfallPage, TeethHarmonicsChatterAndGapsAreMarkedAsInTheHeatMap) {
  openWaterfall();
  const QRect plot = map()->plotRect();
  const QImage before = map()->grab().toImage();
  const auto tickAt = [&](Hertz f) { return QRect(static_cast<int>(xOf(f)) - 2, plot.top() - 6, 5, 5); };
  const Hertz passing(8800.0 / 60.0 * 4);
  EXPECT_EQ(count(before, tickAt(passing * 1.5), colors_.panel), 25);
  EXPECT_LT(count(before, tickAt(passing * 5.0), colors_.panel), 22) << "a tick above the fifth tooth passing";

  view().setHarmonic(Hertz(2100));
  const QImage after = map()->grab().toImage();
  const QRect second(static_cast<int>(xOf(Hertz(4200))) - 2, plot.top(), 5, plot.height() / 4);
  EXPECT_EQ(count(before, second, colors_.track), second.width() * second.height());
  EXPECT_LT(count(after, second, colors_.track), second.width() * second.height() - 10);

  session_.lose(Seconds(0.8));
  play(3.0);
  EXPECT_GT(count(map()->grab().toImage(), plot, colors_.gap), 1000) << "what was lost is hatched across the stack";
}

class AnalysePictures : public Analyse, public testing::WithParamInterface<PageLook> {};

TEST_P(AnalysePictures, TheOtherFormsFit) {
  open(GetParam().width, GetParam().height, GetParam().theme);
  press("advise");
  press("page-analyse");
  while (!session_.snapshot().adviceOpen) play(0.04);
  session_.send({OperatorAction::Accept}, session_.generation());
  play(3.0);
  QTest::mouseClick(find<HistoryMap>(), Qt::LeftButton, {}, inMap(0.6, 0.5));
  QTest::mouseClick(find<HistoryMap>(), Qt::LeftButton, Qt::ShiftModifier, inMap(0.8, 0.5));
  view().setHarmonic(Hertz(1713));
  play(0.2);
  savePage(*window_, "analyse", GetParam(), "cursors");
  press("order");
  press("linear");
  play(0.2);
  savePage(*window_, "analyse", GetParam(), "orders");
  press("linear");
  press("waterfall");
  session_.lose(Seconds(0.6));
  play(1.6);
  savePage(*window_, "analyse", GetParam(), "waterfall");
}

INSTANTIATE_TEST_SUITE_P(Looks, AnalysePictures,
                         testing::Values(kPageLooks[0], kPageLooks[1], kPageLooks[2],
                                         PageLook{"contrast-1280", ThemeKind::HighContrast, 1280, 800}),
                         lookName);

// A tone of constant frequency while the spindle slows down: on the order axis column and mark move together.
TEST_F(UiTest, OnTheOrderAxisTheChatterMarksLieOnTheirLine) {
  RunHistory history;
  Snapshot s;
  s.spectrumTop = Hertz(12800);
  const Hertz tone(1712.5);
  for (int k = 0; k < 100; ++k) {
    SpectrumColumn& c = s.columns[s.columnCount % kSpectrumColumns];
    c.number = s.columnCount++;
    s.time += std::chrono::milliseconds(40);
    c.time = s.time;
    c.spindle = Hertz((k < 50 ? 8500.0 : 7012.0) / 60.0);
    c.chatter = tone;
    c.level_dB.fill(-60.0F);
    c.level_dB[static_cast<std::size_t>(tone.value / 25.0)] = 0.0F;
    ++s.number;
    history.see(s);
  }
  AnalyseView view;
  view.setReach(history.begin(), history.end(), history.spectrumTop());
  AnalyseOptions o;
  o.axis = FrequencyAxis::Order;
  o.span = Seconds(4);
  o.high = Hertz(2500);
  view.setOptions(o);
  HistoryMap map(view);
  map.resize(900, 600);
  map.display(&history, 4, QStringLiteral("m/s\u00b2"));
  const QImage image = map.grab().toImage();
  const QRect plot = map.plotRect();
  for (const double seconds : {1.0, 3.0}) {
    const int middle = static_cast<int>(map.xOf(Instant() + toDuration(Seconds(seconds))));
    std::vector<double> marks, line;
    for (int x = middle - 20; x < middle + 20; ++x) {
      int bright = plot.top();
      for (int y = plot.top(); y <= plot.bottom(); ++y) {
        if (image.pixelColor(x, y) == QColor(Qt::white)) marks.push_back(y);
        const auto light = [&](int row) {
          const QColor c = image.pixelColor(x, row);
          return c == QColor(Qt::white) ? 0 : c.red() + c.green();
        };
        if (light(y) > light(bright)) bright = y;
      }
      line.push_back(bright);
    }
    ASSERT_FALSE(marks.empty());
    EXPECT_NEAR(marks[marks.size() / 2], line[line.size() / 2], 6.0) << "a bin is five pixels high, at " << seconds;
  }
}

}  // namespace
}  // namespace stillcut::ui
