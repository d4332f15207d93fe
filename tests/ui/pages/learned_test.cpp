// What was learned from judged cuts on the Lobes page: the line under the diagram, the shading, the dots.
#include <QDoubleSpinBox>
#include <QLabel>

#include "tests/ui/support/ui_fixture.h"
#include "ui/facade/learned_lobes.h"
#include "ui/plots/lobe_chart.h"

namespace stillcut::ui {
namespace {

// Stable down to 2 mm for sure, not at all below; two judged cuts.
LearnedLobes twoCuts() {
  LearnedLobes learned;
  learned.state = LearnedLobes::State::Known;
  learned.cuts = {{{Rpm(6000), Metres(1e-3)}, false, {}, {}, 1'700'000'000},
                  {{Rpm(9000), Metres(3e-3)}, true, Hertz(912), Hertz(2), 1'700'000'100}};
  for (int i = 0; i <= 100; ++i) learned.speeds.emplace_back(4000.0 + 100.0 * i);
  for (int i = 1; i <= 40; ++i) learned.depths.emplace_back(1e-4 * i);
  for (std::size_t i = 0; i < learned.speeds.size(); ++i) {
    for (const Metres depth : learned.depths) learned.probability.push_back(depth.value < 2e-3 ? 0.97F : 0.03F);
  }
  learned.risk = 0.1;
  learned.best = {{Rpm(8400), Metres(1.9e-3)}, 0.9};
  learned.next = {{Rpm(8100), Metres(2.2e-3)}, 0.55};
  learned.gain = 0.12;
  return learned;
}

class LearnedTest : public WindowTest {
 protected:
  void openPage() {
    open();
    press("page-lobes");
    play(0.2);
    session_.fakeLobes().finish();
    play(0.2);
  }
  void learn(LearnedLobes learned) {
    session_.fakeLobes().setLearned(std::move(learned));
    play(0.2);
    QCoreApplication::processEvents();
  }
  QString line() const { return find<QLabel>("learned")->text(); }
  LobeChart& chart() const { return *window_->findChild<LobeChart*>(); }
};

TEST_F(LearnedTest, NothingIsSaidOfACutOfWhichNothingIsLearned) {
  openPage();
  EXPECT_FALSE(find<QLabel>("learned")->isVisible());
  EXPECT_GT(session_.fakeLobes().timesLearned(), 0) << "it is asked for";
}

TEST_F(LearnedTest, WithoutAJudgedCutItSaysSoAndWhatToDo) {
  openPage();
  LearnedLobes none;
  none.state = LearnedLobes::State::NoCuts;
  learn(none);
  EXPECT_TRUE(find<QLabel>("learned")->isVisible());
  EXPECT_TRUE(line().contains("nothing yet")) << line().toStdString();
  EXPECT_TRUE(line().contains("Cut with this tool")) << line().toStdString();
}

TEST_F(LearnedTest, OneLineSaysFromWhatAndWhatIsRecommendedAndTheNextCut) {
  openPage();
  learn(twoCuts());
  EXPECT_TRUE(line().contains("Learned from 2 judged cuts (1 with chatter)")) << line().toStdString();
  EXPECT_TRUE(line().contains(QStringLiteral("risk of 10"))) << line().toStdString();
  EXPECT_TRUE(line().contains(QStringLiteral("1.90"))) << line().toStdString();
  EXPECT_TRUE(line().contains("Next most useful cut")) << line().toStdString();
  EXPECT_TRUE(line().contains("because")) << line().toStdString();
}

TEST_F(LearnedTest, WhereChatterIsProbableTheDiagramIsShaded) {
  openPage();
  const QPoint shallow = chart().place({Rpm(11'000), Metres(0.5e-3)}),
               deep = chart().place({Rpm(11'000), Metres(3.6e-3)});
  const auto at = [this](const QPoint& place) { return chart().grab().toImage().pixelColor(place); };
  const QColor shallowBefore = at(shallow), deepBefore = at(deep);
  learn(twoCuts());
  EXPECT_GT(at(deep).red() - at(deep).blue(), deepBefore.red() - deepBefore.blue() + 20);
  EXPECT_NEAR(at(shallow).green(), shallowBefore.green(), 12) << "stable with 97 %: hardly shaded";
}

TEST_F(LearnedTest, ADotSaysWhatItsCutWasAndThePlaceOfTheRingHowProbable) {
  openPage();
  learn(twoCuts());
  const LearnedCut* cut = chart().cutAt(chart().place({Rpm(9000), Metres(3e-3)}));
  ASSERT_NE(cut, nullptr);
  EXPECT_TRUE(cut->chatter);
  EXPECT_EQ(chart().cutAt(chart().place({Rpm(12'000), Metres(0.4e-3)})), nullptr);
  find<QDoubleSpinBox>("what-if-speed")->setValue(12'000);
  find<QDoubleSpinBox>("what-if-depth")->setValue(0.4);
  EXPECT_TRUE(line().contains(QStringLiteral("stable here with 97"))) << line().toStdString();
  find<QDoubleSpinBox>("what-if-speed")->setValue(9000);
  find<QDoubleSpinBox>("what-if-depth")->setValue(3.0);
  EXPECT_TRUE(line().contains(QStringLiteral("Judged cut: chatter, 912"))) << line().toStdString();
}

}  // namespace
}  // namespace stillcut::ui
