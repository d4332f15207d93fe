// Fingers: pinch and fling on the plots, pages and lists that move under a finger and leave alone what it began on, and
// targets large enough for a glove also where a page has sheets.
#include <QListView>
#include <QPointingDevice>
#include <QScrollArea>
#include <QScrollBar>

#include "tests/ui/support/analyse_fixture.h"
#include "tests/ui/support/fake_session_desk.h"
#include "tests/ui/support/fake_setup_desk.h"
#include "tests/ui/support/fake_tuning.h"
#include "tests/ui/support/page_picture.h"
#include "ui/plots/lobe_chart.h"
#include "ui/plots/session_timeline.h"
#include "ui/plots/spectrogram/history_map.h"
#include "ui/plots/spectrogram/spectrogram_widget.h"
#include "ui/plots/spectrum_plot.h"
#include "ui/plots/touch_input.h"
#include "ui/plots/trace_plot.h"
#include "ui/shell/page_table.h"
#include "ui/widgets/value_slider.h"

namespace stillcut::ui {
namespace {

class Touch : public Analyse {
 protected:
  void SetUp() override {
    session_.setTuning(&tuning_);
    session_.setSetup(&setup_);
    session_.setSessions(&sessions_);
  }
  QPoint inWindow(const QWidget* widget, QPoint at) const { return widget->mapTo(window_.get(), at); }
  // What was under a finger when it began gets all of it, wherever the finger goes.
  void finger(const QWidget* widget, QPoint from, QPoint by, int steps = 6) const {
    const QPoint begin = inWindow(widget, from);
    QTest::touchEvent(window_.get(), device_).press(0, begin, window_.get());
    for (int k = 1; k <= steps; ++k) {
      QTest::touchEvent(window_.get(), device_).move(0, begin + by * k / steps, window_.get());
    }
    QTest::touchEvent(window_.get(), device_).release(0, begin + by, window_.get());
  }
  void tap(const QWidget* widget, QPoint at) const { finger(widget, at, {}, 0); }
  // From `apart` to `then` around the same middle.
  void pinch(const QWidget* widget, QPoint middle, QPoint apart, QPoint then) const {
    const QPoint m = inWindow(widget, middle);
    MainWindow* w = window_.get();
    QTest::touchEvent(w, device_).press(0, m - apart / 2, w).press(1, m + apart / 2, w);
    constexpr int kSteps = 5;
    for (int k = 1; k <= kSteps; ++k) {
      const QPoint now = (apart + (then - apart) * k / kSteps) / 2;
      QTest::touchEvent(w, device_).move(0, m - now, w).move(1, m + now, w);
    }
    QTest::touchEvent(w, device_).release(0, m - then / 2, w).release(1, m + then / 2, w);
  }
  static TouchInput* input(const QWidget* surface) {
    return surface->findChild<TouchInput*>({}, Qt::FindDirectChildrenOnly);
  }

  FakeTuning tuning_{"fuzzy-learning"};
  FakeSetupDesk setup_;
  FakeSessionDesk sessions_;
  QPointingDevice* device_ = QTest::createTouchDevice();
};

TEST_F(Touch, TwoFingersZoomTimeOrFrequencyAsTheyLie) {
  openPage();
  auto* map = find<HistoryMap>();
  const QPoint middle = map->plotRect().center();
  const AnalyseOptions before = view().options();
  const Instant under = map->timeAt(middle.x());
  view().goTo(under);
  pinch(map, middle, {100, 0}, {200, 0});
  EXPECT_NEAR(view().options().span / before.span, 0.5, 0.02);
  EXPECT_NEAR(secondsBetween(under, map->timeAt(middle.x())).value, 0.0, 0.05)
      << "what was between the fingers stays there";
  EXPECT_EQ(view().options().high, before.high);
  pinch(map, middle, {0, 150}, {0, 75});
  EXPECT_NEAR(view().options().span / before.span, 0.5, 0.02) << "only the axis they lie along";
  const auto wide = [this] { return (view().options().high - view().options().low).value; };
  const double wider = wide();
  EXPECT_GT(wider, (before.high - before.low).value);
  pinch(map, middle, {0, 75}, {0, 150});
  EXPECT_NEAR(wide() / wider, 0.5, 0.02);
  EXPECT_FALSE(view().cursor(AnalyseView::A)) << "and nothing was clicked";
}

TEST_F(Touch, ATapIsAClickAndADragMovesAndRunsOn) {
  openPage();
  auto* trace = find<TracePlot>();
  const QPoint middle = trace->plotRect().center();
  tap(trace, middle);
  ASSERT_TRUE(view().cursor(AnalyseView::A));
  EXPECT_TRUE(view().following());
  const Instant before = view().to();
  finger(trace, middle, {120, 0});
  const Instant lifted = view().to();
  EXPECT_LT(lifted, before) << "earlier samples come into the picture";
  EXPECT_TRUE(input(trace)->running());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !input(trace)->running(); }, 10'000));
  EXPECT_LT(view().to(), lifted) << "it was flung";
  const Instant rest = view().to();
  tick(40);
  EXPECT_EQ(view().to(), rest);
}

TEST_F(Touch, AFingerThatRestsBeforeItLeavesFlingsNothing) {
  openPage();
  auto* trace = find<TracePlot>();
  qint64 now_ms = 0;
  input(trace)->setClock([&] { return now_ms; });
  const QPoint begin = inWindow(trace, trace->plotRect().center());
  MainWindow* w = window_.get();
  QTest::touchEvent(w, device_).press(0, begin, w);
  for (int k = 1; k <= 5; ++k) {
    now_ms += 16;
    QTest::touchEvent(w, device_).move(0, begin + QPoint(20 * k, 0), w);
  }
  now_ms += 500;
  QTest::touchEvent(w, device_).release(0, begin + QPoint(100, 0), w);
  EXPECT_FALSE(input(trace)->running());
}

TEST_F(Touch, SpectrumAndSpectrogramAreZoomedToo) {
  openPage();
  auto* spectrum = find<SpectrumPlot>();
  const double wide = (view().options().high - view().options().low).value;
  pinch(spectrum, spectrum->rect().center(), {80, 0}, {160, 0});
  EXPECT_NEAR((view().options().high - view().options().low).value / wide, 0.5, 0.02);
  window_->showPage(QStringLiteral("operate"));
  play(0.2);
  auto* live = find<SpectrogramWidget>();
  const Hertz top = live->visibleTop();
  pinch(live, live->rect().center(), {0, 60}, {0, 120});
  EXPECT_NEAR(live->visibleTop() / top, 0.5, 0.02);
}

TEST_F(Touch, OnTheLobesOneFingerAsksWhatIfAndTwoZoom) {
  open();
  window_->showPage(QStringLiteral("lobes"));
  play(0.2);
  session_.fakeLobes().finish();
  play(0.2);
  QCoreApplication::processEvents();
  auto* chart = find<LobeChart>();
  const QPoint from = chart->place(chart->handle()), to = chart->place({Rpm(7000), Metres(2e-3)});
  finger(chart, from, to - from);
  EXPECT_NEAR(chart->handle().speed.value, 7000.0, 60.0);
  EXPECT_NEAR(chart->handle().depth.value, 2e-3, 0.05e-3);
  const Rpm whole = chart->rightmost() - chart->leftmost();
  const SpeedDepth asked = chart->handle();
  pinch(chart, to, {80, 0}, {240, 0});
  EXPECT_NEAR((chart->rightmost() - chart->leftmost()) / whole, 1.0 / 3.0, 0.02);
  QCoreApplication::processEvents();
  EXPECT_NEAR(chart->place({Rpm(7000), Metres(2e-3)}).x(), to.x(), 4) << "what is between the fingers stays there";
  EXPECT_EQ(chart->handle().speed, asked.speed) << "the ring is not dragged by that";
  pinch(chart, to, {0, 80}, {0, 160});
  EXPECT_NEAR(chart->deepest().value, 2e-3, 0.1e-3);
  QTest::keyClick(chart, Qt::Key_0);
  EXPECT_EQ(chart->rightmost() - chart->leftmost(), whole);
  QTest::keyClick(chart, Qt::Key_Plus);
  EXPECT_LT((chart->rightmost() - chart->leftmost()).value, whole.value) << "without fingers as well";
}

TEST_F(Touch, OnARecordingOneFingerSelectsAndTwoZoomAndMove) {
  sessions_.open(sessions_.entries().front().path);
  open();
  window_->showPage(QStringLiteral("sessions"));
  play(0.2);
  auto* timeline = find<SessionTimeline>();
  const QPoint middle(timeline->width() / 2, timeline->height() / 3);
  const auto timeAt = [&](int x) {
    tap(timeline, {x, middle.y()});
    return sessions_.state.position.value;
  };
  const double left = timeAt(middle.x() - 100), right = timeAt(middle.x() + 100);
  ASSERT_GT(right, left);
  pinch(timeline, middle, {60, 0}, {180, 0});
  EXPECT_NEAR(timeAt(middle.x() + 100) - timeAt(middle.x() - 100), (right - left) / 3.0, 0.05 * (right - left));
  EXPECT_FALSE(timeline->hasSelection());
  finger(timeline, middle, {90, 0});
  EXPECT_TRUE(timeline->hasSelection());
}

// The page that a Tune part is on is longer than its window.
TEST_F(Touch, ALongPageMovesUnderAFingerAndLeavesAloneWhatItBeganOn) {
  open();
  window_->showPage(QStringLiteral("tune"));
  press("tune-expert");
  play(0.4);
  QCoreApplication::processEvents();  // rows that were made a moment ago have their places now
  auto* area = find<QScrollArea>("tune-rows");
  TouchInput* input = area->viewport()->findChild<TouchInput*>();
  QScrollBar* bar = area->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 400);
  const auto rest = [input] { return QTest::qWaitFor([input] { return !input->running(); }, 10'000); };
  finger(area->viewport(), {area->viewport()->width() / 2, 300}, {4, -90});
  EXPECT_GE(bar->value(), 80);
  EXPECT_TRUE(rest());
  EXPECT_GT(bar->value(), 95) << "it was flung";
  auto* slider = find<ValueSlider>("energy-ratio.chatter-slider");
  ASSERT_NE(slider, nullptr);
  area->ensureWidgetVisible(slider, 0, area->viewport()->height() / 3);
  QCoreApplication::processEvents();
  const int before = bar->value();
  const double fraction = slider->fraction();
  finger(slider, {slider->width() / 4, slider->height() / 2}, {slider->width() / 3, 2});
  EXPECT_NE(slider->fraction(), fraction) << "along the slider it is the slider that is meant";
  EXPECT_EQ(bar->value(), before);
  const double moved = slider->fraction();
  finger(slider, {slider->width() * 3 / 4, slider->height() / 2}, {4, 60});
  EXPECT_LT(bar->value(), before);
  EXPECT_EQ(slider->fraction(), moved) << "nobody meant to change it";
  EXPECT_TRUE(rest());
}

TEST_F(Touch, ListsMoveUnderAFingerAndATapChooses) {
  open();
  window_->showPage(QStringLiteral("tune"));
  press("tune-expert");
  play(0.4);
  auto* list = find<QListView>("tune-parts");
  constexpr int kFew = 260;  // pixels: more methods than that
  list->setFixedHeight(kFew);
  QCoreApplication::processEvents();
  QScrollBar* bar = list->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 0);
  const QModelIndex chosen = list->currentIndex();
  const QPoint second = list->visualRect(list->model()->index(1, 0)).center();
  finger(list->viewport(), second, {0, -60});
  EXPECT_GT(bar->value(), 0);
  EXPECT_EQ(list->currentIndex(), chosen);
  TouchInput* input = list->viewport()->findChild<TouchInput*>();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !input->running(); }, 10'000));
  bar->setValue(0);
  tap(list->viewport(), second);
  EXPECT_EQ(list->currentIndex().row(), 1);
}

TEST_F(Touch, SidesAAndBAreInReachOfAGlove) {
  open();
  window_->showPage(QStringLiteral("tune"));
  press("tune-expert");
  play(0.4);
  const int least = pixelsFor(kTouchMm, window_.get());
  for (const char* const name : {"tune-b", "tune-a"}) {
    auto* side = find<TouchButton>(QLatin1String(name));
    EXPECT_GE(std::min(side->width(), side->height()), least) << name;
    tap(side, side->rect().center());
    EXPECT_EQ(tuning_.controller().side(),
              QLatin1String(name) == QStringLiteral("tune-b") ? TuningController::B : TuningController::A);
  }
}

void expectApart(const QWidget& window, const std::string& where) {
  const int touch = pixelsFor(kTouchMm, &window), apart = pixelsFor(kTouchGapMm, &window);
  QList<QRect> places;
  QStringList names;
  for (const TouchButton* button : window.findChildren<TouchButton*>()) {
    if (!button->isVisible()) continue;
    EXPECT_GE(std::min(button->width(), button->height()), touch) << where << ": " << button->text().toStdString();
    // What has been scrolled out of sight lies behind something else.
    if (button->visibleRegion().isEmpty()) continue;
    places << QRect(button->mapTo(&window, QPoint()), button->size());
    names << button->text();
  }
  EXPECT_GE(places.size(), 7) << where;
  for (int a = 0; a < places.size(); ++a) {
    const QRect wide = places[a].adjusted(-apart + 1, -apart + 1, apart - 1, apart - 1);
    for (int b = a + 1; b < places.size(); ++b) {
      EXPECT_FALSE(wide.intersects(places[b]))
          << where << ": " << names[a].toStdString() << " and " << names[b].toStdString();
    }
  }
  for (const ValueSlider* slider : window.findChildren<ValueSlider*>()) {
    if (!slider->isVisible()) continue;
    EXPECT_GE(slider->height(), touch) << where;
  }
}

TEST_F(Touch, TargetsOfSheetsAreTwelveMillimetresAndThreeApart) {
  setup_.kept[QStringLiteral("mill3")] = {};
  sessions_.open(sessions_.entries().front().path);
  open();
  const auto sheet = [&](const char* page, const char* button) {
    window_->showPage(QLatin1String(page));
    press(QLatin1String(button));
    play(0.3);
    expectApart(*window_, button);
  };
  for (const char* const tab : {"setup-guide", "setup-machine", "setup-limits", "setup-sensors", "setup-tools",
                                "setup-recording", "setup-profile"}) {
    sheet("setup", tab);
  }
  for (const char* const below : {"sheet-mark", "sheet-compare", "sheet-events"}) sheet("sessions", below);
  window_->showPage(QStringLiteral("tune"));
  press("tune-expert");
  play(0.3);
  expectApart(*window_, "tune");
}

}  // namespace
}  // namespace stillcut::ui
