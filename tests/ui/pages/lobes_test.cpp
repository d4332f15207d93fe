// The Lobes page driven as a person would: compute, cancel, drag "what if", choose a pocket.
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableView>

#include "tests/ui/support/ui_fixture.h"
#include "ui/base/format.h"
#include "ui/pages/lobes_page.h"
#include "ui/plots/lobe_chart.h"

namespace stillcut::ui {
namespace {

QRect plotOf(const LobeChart& chart) {
  return chart.chart()->plotArea().toRect();
}

// The rectangle around every pixel of this colour; null: there is none.
QRect findColor(const QImage& image, const QRect& where, const QColor& color) {
  QRect found;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) {
      if (image.pixelColor(x, y) == color) found |= QRect(x, y, 1, 1);
    }
  }
  return found;
}

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
  bool said(const QString& text) const {
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) return true;
    }
    return false;
  }
  QString answer() const { return find<QLabel>("what-if")->text(); }
};

TEST_F(LobesPageTest, TheFirstLookComputesAndCanBeCancelled) {
  openPage();
  ASSERT_TRUE(lobes().asked());
  EXPECT_EQ(lobes().asked()->method, LobeMethodChoice::Exact);
  EXPECT_EQ(find<TouchButton>("compute")->text(), "CANCEL");
  press("compute");
  EXPECT_EQ(lobes().progress().state, LobeProgress::State::Cancelled);
  tick(40);
  EXPECT_EQ(find<TouchButton>("compute")->text(), "COMPUTE");
  press("method-zoa");
  EXPECT_EQ(lobes().asked()->method, LobeMethodChoice::ZerothOrder);
  EXPECT_EQ(lobes().progress().state, LobeProgress::State::Running);
}

TEST_F(LobesPageTest, BeforeTheDiagramTheTableIsInTheUnitsOfTheScreenToo) {
  openPage();
  const auto head = [this] {
    return find<QTableView>()->model()->headerData(PocketTable::Removal, Qt::Horizontal).toString();
  };
  EXPECT_EQ(head(), removalUnit(UnitSystem::Metric));
  EXPECT_FALSE(said("In brackets")) << "there are none yet";
  press("display");
  press("units-1");
  tick(40);
  tick(80);
  EXPECT_EQ(find<QTableView>()->model()->rowCount(), 0);
  EXPECT_EQ(head(), removalUnit(UnitSystem::Inch));
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

TEST_F(LobesPageTest, APocketIsTriedWithArrowsAndEnter) {
  computed();
  auto* pockets = find<QTableView>();
  pockets->setFocus();
  pockets->setCurrentIndex(pockets->model()->index(0, 0));
  QTest::keyClick(pockets, Qt::Key_Down);
  QTest::keyClick(pockets, Qt::Key_Return);
  EXPECT_NEAR(find<LobeChart>()->handle().speed.value, 7000.0, 51.0);
  EXPECT_EQ(pockets->currentIndex().row(), 1) << "and the arrows go on from there";
}

TEST_F(LobesPageTest, SaysWhyTheWorkingPointIsGone) {
  computed();
  const QString gone = QStringLiteral("working point is not shown");
  EXPECT_FALSE(said(gone));
  tick(2000);
  EXPECT_TRUE(said(gone));
  play(0.2);
  EXPECT_FALSE(said(gone));
}

TEST_F(LobesPageTest, TellsTheDepthOfTheCutAndShowsNoPointAtADepthThatNobodyTold) {
  computed();
  const auto* chart = find<LobeChart>();
  EXPECT_TRUE(said(QStringLiteral("depth of cut up to 1.50\u00a0mm")));
  EXPECT_TRUE(chart->now());
  lobes().mutableFrame().depthKnown = false;
  play(0.2);
  EXPECT_FALSE(chart->now());
  EXPECT_TRUE(said(QStringLiteral("tell it under Set up, MACHINE")));
  EXPECT_FALSE(said(QStringLiteral("depth of cut up to 1.50")));
}

TEST_F(LobesPageTest, UnderAReplayTheDiagramIsOfTheReplaysToolOrNone) {
  computed();
  ASSERT_TRUE(said(QStringLiteral("model of the test")));
  Snapshot recorded = session_.snapshot();
  FakeLobes ofRecording;
  ofRecording.mutableFrame().name = QStringLiteral("tool of the recording");
  session_.setReplayLobes(&ofRecording);
  session_.showReplay(recorded);
  play(0.1);
  ASSERT_TRUE(ofRecording.asked()) << "the first look computes here too";
  ofRecording.finish();
  play(0.1);
  EXPECT_TRUE(said(QStringLiteral("tool of the recording")));
  EXPECT_FALSE(said(QStringLiteral("model of the test")));
  session_.setReplayLobes(nullptr);
  session_.showReplay(recorded);
  play(0.1);
  EXPECT_TRUE(said(QStringLiteral("does not say which modes its tool has")));
  EXPECT_FALSE(find<LobeChart>()->now());
  EXPECT_EQ(find<QTableView>()->model()->rowCount(), 0) << "no pockets of another tool";
  EXPECT_TRUE(answer().isEmpty());
  session_.showReplay({});
  play(0.1);
  EXPECT_TRUE(said(QStringLiteral("model of the test"))) << "the machine's own comes back with its cut";
}

TEST_F(LobesPageTest, ShowsWhereTheCutIsAndWhereItIsAdvisedToGo) {
  computed();
  const auto* chart = find<LobeChart>();
  const QColor advice = themeColors(ThemeKind::Light).advice;
  EXPECT_TRUE(findColor(find<LobeChart>()->grab().toImage(), plotOf(*chart), advice).isNull());
  press("advise");
  while (!session_.snapshot().adviceOpen) play(0.04);
  play(0.2);
  const QRect arrow = findColor(find<LobeChart>()->grab().toImage(), plotOf(*chart), advice);
  const QPoint now = chart->place({Rpm(8799), Metres(1.5e-3)});
  const QPoint target = chart->place({session_.snapshot().request.speed, Metres(1.5e-3)});
  EXPECT_LT(now.x() - target.x(), 20) << "a short move";
  EXPECT_GT(arrow.right() - target.x(), 35) << "and yet an arrow";
  EXPECT_LT(arrow.bottom(), target.y() + 4) << "above what it leads to";
}

// All in one place: each sign leaves the others in sight.
TEST_F(UiTest, RingCrossAndPointsOfTheLobeChartDoNotCoverEachOther) {
  FakeLobes lobes;
  LobeChart chart;
  chart.resize(900, 600);
  chart.applyTheme(makeTheme(ThemeKind::Light, 1.0));
  chart.setDiagram(nullptr, lobes.frame());
  const SpeedDepth here{Rpm(8800), Metres(2e-3)};
  const std::vector<MetPoint> met{{Rpm(6000), here.depth, CutState::Onset},
                                  {Rpm(7000), here.depth, CutState::Chatter},
                                  {here.speed, here.depth, CutState::Stable}};
  chart.setHandle(here);
  chart.setWork(here, met);
  chart.show();
  QCoreApplication::processEvents();
  const QImage image = chart.grab().toImage();
  const ThemeColors c = themeColors(ThemeKind::Light);
  const QPoint at = chart.place(here);
  const auto darkNear = [&](int radius) {  // to the right of the place
    int darkest = 255;
    for (int k = 0; k < 9; ++k) {
      darkest = std::min(darkest, image.pixelColor(at + QPoint(radius - 1 + k % 3, k / 3 - 1)).lightness());
    }
    return darkest;
  };
  EXPECT_LT(darkNear(5), 120) << "the point";
  EXPECT_LT(darkNear(11), 120) << "the arm";
  EXPECT_LT(darkNear(20), 120) << "the ring";
  EXPECT_EQ(image.pixelColor(chart.place({Rpm(6000), here.depth})), c.onset) << "onset is not chatter's";
  EXPECT_EQ(image.pixelColor(chart.place({Rpm(7000), here.depth})), c.chatter);
  EXPECT_FALSE(chart.clipped());
  const QRect legend(0, 0, chart.width(), plotOf(chart).top());
  EXPECT_FALSE(findColor(image, legend, c.onset).isNull()) << "what the signs mean stands above";
  EXPECT_FALSE(findColor(image, legend, c.chatter).isNull());
}

TEST_F(LobesPageTest, WithoutModesThePageSaysWhatToDo) {
  session_.forgetLobes();
  openPage();
  bool said = false;
  for (const QLabel* label : window_->findChildren<QLabel*>()) said = said || label->text().contains("not known");
  EXPECT_TRUE(said);
  EXPECT_FALSE(find<LobeChart>()->isVisible()) << "axes of nothing";
  EXPECT_TRUE(find<QDoubleSpinBox>("what-if-speed")->cleanText().isEmpty());
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
  const WhatIf quiet = whatIf(&diagram, {}, {Rpm(5250), Metres(2.5e-3)}, UnitSystem::Metric);
  EXPECT_TRUE(quiet.stable);
  EXPECT_TRUE(quiet.verdict.contains(QStringLiteral("island")));
  EXPECT_FALSE(whatIf(&diagram, {}, {Rpm(5250), Metres(1.5e-3)}, UnitSystem::Metric).stable);
}

}  // namespace
}  // namespace stillcut::ui
