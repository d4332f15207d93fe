// The active work-holder on the Tune page: what is said of it, and the page driven as a person would.
#include <QListView>

#include "tests/ui/support/fake_active_desk.h"
#include "tests/ui/support/fake_tuning.h"
#include "tests/ui/support/page_picture.h"
#include "ui/models/active_text.h"
#include "ui/models/strip_view.h"
#include "ui/pages/active_view.h"
#include "ui/plots/path_fit_plot.h"

namespace stillcut::ui {
namespace {

TEST(ActiveWords, TellWhatIsEarnedUsedAndLeft) {
  const ActiveAxisView x = makeActiveAxis(exampleActive(), 0);
  EXPECT_EQ(x.state, QStringLiteral("on"));
  EXPECT_EQ(x.tone, Tone::Normal);
  EXPECT_EQ(x.stroke, QStringLiteral("stroke 42\u00a0%"));
  ASSERT_EQ(x.lines.size(), 2) << "a line nobody has heard is not told";
  EXPECT_TRUE(x.lines[1].contains(QStringLiteral("\u221224.9"))) << x.lines[1].toStdString();
  EXPECT_TRUE(x.model.contains(QStringLiteral("70\u00b0"))) << x.model.toStdString();
  EXPECT_TRUE(x.model.contains(QStringLiteral("identified 1\u00a0min"))) << x.model.toStdString();
  EXPECT_TRUE(x.modelSound);
}

TEST(ActiveWords, SayWhyItLetGoAndThatTheStrokeIsShort) {
  const ActiveAxisView y = makeActiveAxis(exampleActive(), 1);
  EXPECT_EQ(y.state, QStringLiteral("let go: the loop diverged"));
  EXPECT_EQ(y.tone, Tone::Chatter);
  EXPECT_TRUE(y.stroke.contains(QStringLiteral("at its end for 20")));
  EXPECT_TRUE(y.model.contains(QStringLiteral("No model")));
  EXPECT_FALSE(y.modelSound);
  ActiveSnapshot asked = exampleActive();
  asked.axes[1].release = ActuatorRelease::Asked;
  EXPECT_EQ(makeActiveAxis(asked, 1).state, QStringLiteral("off")) << "a stop that was asked for is no fault";
}

TEST(ActiveWords, AModelWithLittlePhaseLeftIsNotSound) {
  ActiveSnapshot s = exampleActive();
  s.paths[0].phaseMargin = 0.3;
  EXPECT_FALSE(makeActiveAxis(s, 0).modelSound);
  s.paths[0].predictedStable = false;
  EXPECT_TRUE(makeActiveAxis(s, 0).model.contains(QStringLiteral("identify anew")));
}

TEST(ActiveWords, EveryPageIsToldWhatTheTableDoes) {
  ActiveSnapshot s = exampleActive();
  ActiveTableView table = makeActiveTable(s);
  EXPECT_EQ(table.text, QStringLiteral("y let go, x\u00a042\u00a0%"));
  EXPECT_EQ(table.tone, Tone::Chatter);
  EXPECT_TRUE(table.fault.contains(QStringLiteral("along y: the loop diverged"))) << table.fault.toStdString();
  Picture picture;
  picture.table = &s;
  EXPECT_EQ(makeEventLine(picture).text, table.fault) << "for as long as it stays off";
  s.axes[1].state = ActuatorState::On;
  s.axes[1].release = ActuatorRelease::None;
  EXPECT_TRUE(makeEventLine(picture).text.isEmpty());
  table = makeActiveTable(s);
  EXPECT_EQ(table.text, QStringLiteral("x\u00a042\u00a0%, y\u00a0100\u00a0%"));
  EXPECT_EQ(table.tone, Tone::Onset) << "a stroke at its end";
  EXPECT_TRUE(table.fault.isEmpty());
  for (ActiveAxis& axis : s.axes) {
    axis.state = ActuatorState::Off;
    axis.release = ActuatorRelease::Asked;
    axis.limitedFraction = 0.0;
  }
  EXPECT_EQ(makeActiveTable(s).text, QStringLiteral("off"));
  s.identifying = true;
  s.identified = 0.5;
  EXPECT_TRUE(makeActiveTable(s).text.contains(QStringLiteral("50"))) << "the table moves";
  s.identifying = s.open = false;
  EXPECT_EQ(makeActiveTable(s).tone, Tone::Faint);
  s.axes[0].release = ActuatorRelease::DeviceFault;
  EXPECT_TRUE(makeActiveTable(s).fault.contains(QStringLiteral("lost"))) << "unplugged while it held the cut";
}

TEST(PathFitPlot, PhaseErrorIsThatOfTheModelWhereCoherenceTells) {
  const PathFit fit = exampleFit();
  EXPECT_NEAR(PathFitPlot::phaseError(fit, 79), -0.2 * 360.0 / kTwoPi, 1e-6) << "at 1000 Hz";
  EXPECT_TRUE(std::isnan(PathFitPlot::phaseError(fit, 190))) << "the measurement says little there";
}

class ActivePage : public WindowTest, public testing::WithParamInterface<PageLook> {
 protected:
  void openActive(int width = 1280, int height = 800, ThemeKind theme = ThemeKind::Light) {
    session_.setTuning(&tuning_);
    session_.setActive(&controller_);
    open(width, height, theme);
    window_->showPage(QStringLiteral("tune"));
    press("tune-expert");
    auto* list = find<QListView>("tune-parts");
    for (int k = 0; k < list->model()->rowCount() && !find<ActiveView>()->isVisible(); ++k) {
      list->setCurrentIndex(list->model()->index(k, 0));
    }
    play(0.2);
  }

  FakeTuning tuning_;
  FakeActiveDesk controller_;
};

TEST_F(ActivePage, IdentifiesStartsWatchesAndStops) {
  openActive();
  ASSERT_TRUE(find<ActiveView>()->isVisible());
  EXPECT_FALSE(find<PathFitPlot>()->hasFit());
  press("active-start");
  tick(40);
  const auto told = [this](const QString& part) {
    for (const TextLabel* label : window_->findChildren<TextLabel*>()) {
      if (label->isVisible() && label->text().contains(part)) return true;
    }
    return false;
  };
  EXPECT_TRUE(told(QStringLiteral("identify it first")));
  press("active-identify");
  EXPECT_EQ(controller_.identifications, 1);
  controller_.fits = {exampleFit(), std::nullopt};
  controller_.snapshot = exampleActive();
  press("active-start");
  tick(40);
  EXPECT_EQ(controller_.starts, 1);
  EXPECT_TRUE(find<PathFitPlot>()->hasFit());
  EXPECT_TRUE(told(QStringLiteral("\u221223.4")));
  EXPECT_TRUE(told(QStringLiteral("y: let go: the loop diverged"))) << "of the other axis too";
  press("active-y");
  tick(40);
  EXPECT_FALSE(find<PathFitPlot>()->hasFit());
  press("active-stop");
  EXPECT_EQ(controller_.stops, 1);
}

TEST_P(ActivePage, Fits) {
  controller_.fits = {exampleFit(), std::nullopt};
  controller_.snapshot = exampleActive();
  openActive(GetParam().width, GetParam().height, GetParam().theme);
  savePage(*window_, "tune", GetParam(), "active");
  window_->showPage(QStringLiteral("operate"));
  play(0.2);
  savePage(*window_, "operate", GetParam(), "active");
}

INSTANTIATE_TEST_SUITE_P(Looks, ActivePage, testing::ValuesIn(kPageLooks), lookName);

}  // namespace
}  // namespace stillcut::ui
