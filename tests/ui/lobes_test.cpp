// The Lobes page driven as a person would: compute, cancel, drag "what if", choose a pocket.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableView>

#include "tests/ui/ui_fixture.h"
#include "ui/pages/lobes_page.h"
#include "ui/plots/lobe_chart.h"

namespace stillcut::ui {
namespace {

class LobesPageTest : public WindowTest {
 protected:
  void openPage() {
    open();
    press("page-lobes");
    play(0.2);
  }
  void computed() {
    openPage();
    session_.fakeLobes().finish();
    play(0.2);
    QCoreApplication::processEvents();
  }
  FakeLobes& lobes() { return session_.fakeLobes(); }
  QString answer() const { return find<QLabel>("what-if")->text(); }
};

TEST_F(LobesPageTest, TheFirstLookComputesAndCanBeCancelled) {
  openPage();
  ASSERT_TRUE(lobes().asked());
  EXPECT_EQ(lobes().asked()->method, LobeMethod::Exact);
  EXPECT_EQ(find<TouchButton>("compute")->text(), "CANCEL");
  press("compute");
  EXPECT_EQ(lobes().progress().state, LobeProgress::State::Cancelled);
  tick(40);
  EXPECT_EQ(find<TouchButton>("compute")->text(), "COMPUTE");
  press("method-zoa");
  EXPECT_EQ(lobes().asked()->method, LobeMethod::ZerothOrder);
  EXPECT_EQ(lobes().progress().state, LobeProgress::State::Running);
}

TEST_F(LobesPageTest, DraggingTheRingAsksWhatIf) {
  computed();
  auto* chart = find<LobeChart>();
  const QPoint quiet = chart->place({Rpm(7000), Metres(2e-3)}), loud = chart->place({Rpm(8250), Metres(2e-3)});
  QTest::mousePress(chart->viewport(), Qt::LeftButton, {}, quiet);
  EXPECT_TRUE(answer().startsWith("STABLE")) << answer().toStdString();
  QTest::mouseMove(chart->viewport(), loud);
  QTest::mouseRelease(chart->viewport(), Qt::LeftButton, {}, loud);
  EXPECT_TRUE(answer().startsWith("CHATTER")) << answer().toStdString();
  EXPECT_NEAR(find<QDoubleSpinBox>("what-if-speed")->value(), 8250.0, 30.0);
  EXPECT_NEAR(find<QDoubleSpinBox>("what-if-depth")->value(), 2.0, 0.05);
  const double before = chart->handle().speed.value;
  QTest::keyClick(chart, Qt::Key_Left);
  EXPECT_LT(chart->handle().speed.value, before);
}

TEST_F(LobesPageTest, TypingADepthChangesThePockets) {
  computed();
  auto* pockets = find<QTableView>();
  EXPECT_EQ(pockets->model()->rowCount(), 4);
  auto* depth = find<QDoubleSpinBox>("what-if-depth");
  depth->selectAll();
  QTest::keyClicks(depth, "3.5");
  QTest::keyClick(depth, Qt::Key_Return);
  EXPECT_EQ(pockets->model()->rowCount(), 0);
}

TEST_F(LobesPageTest, ATouchOnAPocketTriesItsBestSpeed) {
  computed();
  auto* pockets = find<QTableView>();
  QTest::mouseClick(pockets->viewport(), Qt::LeftButton, {},
                    pockets->visualRect(pockets->model()->index(1, 0)).center());
  EXPECT_NEAR(find<LobeChart>()->handle().speed.value, 7000.0, 51.0);
  EXPECT_TRUE(answer().startsWith("STABLE"));
}

TEST_F(LobesPageTest, ShowsWhereTheCutIsAndWhereItIsAdvisedToGo) {
  computed();
  const QImage calm = find<LobeChart>()->grab().toImage();
  press("advise");
  while (!session_.snapshot().adviceOpen) play(0.04);
  play(0.2);
  const QImage advised = find<LobeChart>()->grab().toImage();
  const auto* chart = find<LobeChart>();
  const QPoint target = chart->place({session_.snapshot().request.speed, Metres(1.5e-3)});
  EXPECT_NE(calm.pixel(target + QPoint(4, 0)), advised.pixel(target + QPoint(4, 0))) << "the head of the arrow";
}

TEST_F(LobesPageTest, WithoutModesThePageSaysWhatToDo) {
  session_.forgetLobes();
  openPage();
  bool said = false;
  for (const QLabel* label : window_->findChildren<QLabel*>()) said = said || label->text().contains("not known");
  EXPECT_TRUE(said);
  press("compute");  // nothing to compute, and nothing happens
}

// Above the limit a stretch of depths can be quiet again; what lies on it is stable, what lies beside it is not.
TEST(LobeIslands, AreQuietBetweenSpeedsThatBothHaveThem) {
  LobeDiagram diagram;
  for (int k = 0; k < 5; ++k) {
    LobeLimit limit{Rpm(5000.0 + 100.0 * k), Metres(1e-3), true, ChatterKind::Hopf, Hertz(900)};
    if (k == 2 || k == 3) limit.islands = {{Metres(2e-3), Metres(3e-3)}};
    diagram.limits.push_back(limit);
  }
  EXPECT_TRUE(onIsland(diagram, Rpm(5250), Metres(2.5e-3)));
  EXPECT_TRUE(onIsland(diagram, Rpm(5200), Metres(2.5e-3)));
  EXPECT_FALSE(onIsland(diagram, Rpm(5150), Metres(2.5e-3))) << "only one side is known to be quiet";
  EXPECT_FALSE(onIsland(diagram, Rpm(5250), Metres(1.5e-3)));
  EXPECT_FALSE(onIsland(diagram, Rpm(9000), Metres(2.5e-3)));
  const WhatIf quiet = whatIf(&diagram, {}, Rpm(5250), Metres(2.5e-3), UnitSystem::Metric);
  EXPECT_TRUE(quiet.stable);
  EXPECT_TRUE(quiet.verdict.contains(QStringLiteral("island")));
  EXPECT_FALSE(whatIf(&diagram, {}, Rpm(5250), Metres(1.5e-3), UnitSystem::Metric).stable);
}

}  // namespace
}  // namespace stillcut::ui
