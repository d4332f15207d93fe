// Which samples of a run are a stable steady cut, long enough to be listened to.
#include "core/learn/steady_stretch.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace stillcut::learn {
namespace {

class Stretch : public testing::Test {
 protected:
  Stretch() {
    block_.allocate(3, 100);
    block_.rate = Hertz(1000.0);
    block_.frames = 100;
    stable_.valid = true;
    stable_.state = CutState::Stable;
    stable_.phase = CutPhase::Steady;
    stable_.spindle = Hertz(140.0);
  }
  // A tenth of a second, and what is said of it.
  bool add(const Verdict& verdict) {
    ++block_.sequence;
    for (float& x : block_.channel(2)) x = static_cast<float>(block_.sequence);
    collector_.add(block_);
    return collector_.look(verdict);
  }
  // Whether a stretch comes of one second.
  bool second(const Verdict& verdict) {
    for (int k = 0; k < 10; ++k) add(verdict);
    return collector_.take().has_value();
  }

  SampleBlock block_;
  Verdict stable_;
  StretchCollector collector_{{0, 2}, {Seconds(1.0), 0.002}};
};

TEST_F(Stretch, ComesOfTheChosenChannelsOfOneLongStableCut) {
  for (int k = 0; k < 9; ++k) EXPECT_TRUE(add(stable_));
  EXPECT_FALSE(collector_.take());
  stable_.spindle = Hertz(140.1);
  EXPECT_TRUE(add(stable_));
  const auto stretch = collector_.take();
  ASSERT_TRUE(stretch);
  EXPECT_EQ(stretch->rate, Hertz(1000.0));
  EXPECT_NEAR(stretch->speed.value, 60.0 * 140.01, 1e-6);
  ASSERT_EQ(stretch->channels.size(), 2U);
  ASSERT_EQ(stretch->channels[1].size(), 1000U);
  EXPECT_EQ(stretch->channels[1].front(), 1.0);
  EXPECT_EQ(stretch->channels[1].back(), 10.0);
  EXPECT_FALSE(collector_.take()) << "once";
}

TEST_F(Stretch, EndsWithWhatIsNotJudgedStableAtThatSpeed) {
  EXPECT_TRUE(second(stable_));
  for (const auto& spoil : std::vector<std::function<void(Verdict&)>>{
           [](Verdict& v) { v.valid = false; }, [](Verdict& v) { v.phase = CutPhase::Entry; },
           [](Verdict& v) { v.state = CutState::Onset; }, [](Verdict& v) { v.kind = ChatterKind::Forced; },
           [](Verdict& v) { v.reason.code = ReasonCode::Learning; }, [](Verdict& v) { v.spindle = Hertz(); },
           [](Verdict& v) { v.spindle = Hertz(141.0); }}) {
    add(stable_);
    Verdict spoilt = stable_;
    spoil(spoilt);
    EXPECT_FALSE(add(spoilt));
    for (int k = 0; k < 9; ++k) EXPECT_TRUE(add(stable_));
    EXPECT_FALSE(collector_.take()) << "nine tenths of a second are left";
  }
}

TEST_F(Stretch, HasNoGap) {
  for (int k = 0; k < 5; ++k) add(stable_);
  ++block_.sequence;
  for (int k = 0; k < 9; ++k) add(stable_);
  EXPECT_FALSE(collector_.take()) << "begins after what was lost";
  add(stable_);
  EXPECT_TRUE(collector_.take());
  for (int k = 0; k < 5; ++k) add(stable_);
  block_.flags = kBlockGap;
  add(stable_);
  block_.flags = 0;
  for (int k = 0; k < 8; ++k) add(stable_);
  EXPECT_FALSE(collector_.take());
  add(stable_);
  EXPECT_TRUE(collector_.take());
}

}  // namespace
}  // namespace stillcut::learn
