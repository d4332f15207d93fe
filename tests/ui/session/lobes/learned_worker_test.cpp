// The judged cuts in a store become a map, a recommendation and the next cut, in the background.
#include "app/session/lobes/learned_worker.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/learn/evidence_store.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

using State = ui::LearnedLobes::State;

milling::CutModel model() {
  milling::CutModel m;
  m.modes = {{Hertz(950.0), 0.02, 3e6, {1.0, 0.0}}, {Hertz(1000.0), 0.02, 3e6, {0.0, 1.0}}};
  m.tool.teeth = 4;
  m.tool.diameter = Metres(10e-3);
  m.engagement.radialImmersion = 0.5;
  m.material.tangential = 6e8;
  m.material.radial = 2e8;
  return m;
}

learn::CutEvidence cutAt(Rpm speed, Metres depth, bool chatter) {
  learn::CutEvidence cut;
  cut.assembly.machine = "Mill 3";
  cut.assembly.tool = "T12";
  cut.teeth = 4;
  cut.diameter = Metres(10e-3);
  cut.speed = speed;
  cut.depth = depth;
  cut.engagement = model().engagement;
  cut.outcome = chatter ? learn::CutOutcome::Chatter : learn::CutOutcome::Stable;
  if (chatter) cut.frequency = Hertz(980.0);
  return cut;
}

class LearnedFromCuts : public testing::Test {
 protected:
  LearnedWorker::Work work() const {
    LearnedWorker::Work w;
    w.cut = cutAt({}, Metres(1e-3), false);
    w.model = model();
    w.frame.lowest = Rpm(5000);
    w.frame.highest = Rpm(15'000);
    w.frame.reachLow = Rpm(7000);
    w.frame.reachHigh = Rpm(9000);
    w.frame.maxAxialDepth = Metres(4e-3);
    w.store = store();
    return w;
  }
  std::filesystem::path store() const { return folder_ / "cuts.sqlite"; }
  void keep(const learn::CutEvidence& cut) const {
    auto opened = learn::EvidenceStore::open(store());
    ASSERT_TRUE(opened.ok()) << opened.error().line();
    ASSERT_TRUE(opened->add(cut).ok());
  }
  // What it answers when it is done.
  static std::shared_ptr<const ui::LearnedLobes> answerOf(LearnedWorker& worker) {
    worker.learn();
    worker.wait();
    return worker.newest();
  }

  record::TempFolder folder_;
};

TEST_F(LearnedFromCuts, SaysWhenNothingIsKeptAndMakesNoFile) {
  LearnedWorker worker(work());
  EXPECT_EQ(answerOf(worker)->state, State::NoCuts);
  EXPECT_FALSE(std::filesystem::exists(store()));
  LearnedWorker::Work undescribed = work();
  undescribed.cut.reset();
  LearnedWorker silent(undescribed);
  EXPECT_EQ(answerOf(silent)->state, State::NotDescribed);
}

TEST_F(LearnedFromCuts, CutsOfThisToolAsItIsClampedCountAndAdviceKeepsWithinReach) {
  keep(cutAt(Rpm(8000), Metres(1e-3), false));
  keep(cutAt(Rpm(8600), Metres(3.5e-3), true));
  learn::CutEvidence other = cutAt(Rpm(8600), Metres(1e-3), true);
  other.assembly.tool = "T13";
  keep(other);
  learn::CutEvidence longer = cutAt(Rpm(8600), Metres(1e-3), true), shrunk = longer;
  longer.assembly.stickOut = Metres(60e-3);
  keep(longer);
  shrunk.assembly.holder = "HSK63 shrink-fit";
  keep(shrunk);
  LearnedWorker worker(work());
  const auto learned = answerOf(worker);
  ASSERT_EQ(learned->state, State::Known) << learned->problem.toStdString();
  ASSERT_EQ(learned->cuts.size(), 2U);
  EXPECT_EQ(learned->probability.size(), learned->speeds.size() * learned->depths.size());
  EXPECT_GT(learned->at(learned->speeds.size() / 3, 0), 0.9) << "hardly any depth";
  EXPECT_GE(learned->best.at.speed, Rpm(7000));
  EXPECT_LE(learned->best.at.speed, Rpm(9000));
  EXPECT_GT(learned->next.at.depth, Metres{});
  EXPECT_GE(learned->best.probabilityStable, 0.85);
}

// As Set up named tools before a profile said how they are clamped.
TEST_F(LearnedFromCuts, CutsThatWereKeptUnderANameThatSaysHowItIsClampedCount) {
  LearnedWorker::Work clamped = work();
  clamped.cut->assembly.holder = "ER32";
  clamped.cut->assembly.stickOut = Metres(48e-3);
  learn::CutEvidence now = cutAt(Rpm(8000), Metres(1e-3), false), before = now, other = now, bare = now;
  now.assembly = clamped.cut->assembly;
  before.assembly.tool = "T12 ER32 stick-out 48";
  other.assembly.tool = "T12 ER32 stick-out 60";
  for (const learn::CutEvidence& cut : {now, before, other, bare}) keep(cut);
  LearnedWorker worker(clamped);
  EXPECT_EQ(answerOf(worker)->cuts.size(), 2U);
  LearnedWorker::Work said = work();  // the holder's name said it itself
  said.cut->assembly.holder = "ER32, 60.5 mm";
  said.cut->assembly.stickOut = Metres(60.5e-3);
  learn::CutEvidence long_ = bare;
  long_.assembly.tool = "T12 ER32, 60.5 mm";
  keep(long_);
  LearnedWorker found(said);
  EXPECT_EQ(answerOf(found)->cuts.size(), 1U);
}

TEST_F(LearnedFromCuts, ACutThatIsKeptLaterCountsWhenItIsAskedAgain) {
  keep(cutAt(Rpm(8000), Metres(1e-3), false));
  LearnedWorker worker(work());
  EXPECT_EQ(answerOf(worker)->cuts.size(), 1U);
  keep(cutAt(Rpm(8200), Metres(1e-3), false));
  EXPECT_EQ(answerOf(worker)->cuts.size(), 2U);
}

TEST_F(LearnedFromCuts, AFileThatIsNoStoreIsSaid) {
  std::ofstream(store()) << "no database";
  LearnedWorker worker(work());
  const auto learned = answerOf(worker);
  EXPECT_EQ(learned->state, State::Failed);
  EXPECT_FALSE(learned->problem.isEmpty());
}

}  // namespace
}  // namespace stillcut::app
