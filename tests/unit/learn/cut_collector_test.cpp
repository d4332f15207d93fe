// A run's verdicts as cuts: what was judged long enough counts once, the rest does not.
#include "core/learn/cut_collector.h"

#include <gtest/gtest.h>

namespace stillcut::learn {
namespace {

class Course {
 public:
  // `seconds` of one kind of verdict, looked at 30 times a second.
  void pass(double seconds, CutState state, double rpm, double frequency = 0.0, bool valid = true,
            ChatterKind kind = ChatterKind::Unknown, ReasonCode reason = ReasonCode::None) {
    Verdict v;
    v.state = state;
    v.phase = state == CutState::AirCutting ? CutPhase::AirCutting : CutPhase::Steady;
    v.valid = valid;
    v.reason.code = reason;
    v.kind = kind;
    v.spindle = Hertz(rpm / 60.0);
    v.frequency = Hertz(frequency);
    for (int i = 0; i < static_cast<int>(30.0 * seconds); ++i) {
      v.time = time_ = time_ + toDuration(Seconds(1.0 / 30.0));
      if (auto cut = collector_.look(v)) cuts_.push_back(*cut);
    }
  }
  const std::vector<CollectedCut>& end() {
    if (auto cut = collector_.end()) cuts_.push_back(*cut);
    return cuts_;
  }

 private:
  CutCollector collector_;
  Instant time_ = Instant{} + toDuration(Seconds(10.0));
  std::vector<CollectedCut> cuts_;
};

TEST(CutCollector, EndsACutInAirAndWhereTheSpeedChanges) {
  Course course;
  course.pass(1.0, CutState::AirCutting, 8000.0);
  course.pass(4.0, CutState::Stable, 8000.0);
  course.pass(1.0, CutState::AirCutting, 8000.0);
  course.pass(1.0, CutState::Stable, 8000.0);
  course.pass(0.5, CutState::Onset, 8000.0, 905.0);
  course.pass(0.5, CutState::Chatter, 8000.0, 915.0);
  course.pass(3.0, CutState::Stable, 7500.0);
  const auto& cuts = course.end();
  ASSERT_EQ(cuts.size(), 3U);
  EXPECT_EQ(cuts[0].outcome, CutOutcome::Stable);
  EXPECT_EQ(cuts[1].outcome, CutOutcome::Chatter);
  EXPECT_NEAR(cuts[1].frequency.value, 910.0, 0.5);
  EXPECT_NEAR(cuts[1].frequencySd.value, 5.0, 0.5);
  EXPECT_NEAR(cuts[1].speed.value, 8000.0, 1.0);
  EXPECT_EQ(cuts[2].outcome, CutOutcome::Stable);
  EXPECT_NEAR(cuts[2].speed.value, 7500.0, 1.0);
}

TEST(CutCollector, LearnsNothingFromWhatWasNotJudged) {
  Course course;
  course.pass(5.0, CutState::Stable, 8000.0, 0.0, false);
  course.pass(5.0, CutState::Stable, 8000.0, 0.0, true, ChatterKind::Unknown, ReasonCode::Learning);
  course.pass(1.0, CutState::AirCutting, 8000.0);
  course.pass(1.0, CutState::Stable, 8000.0);  // too short
  course.pass(1.0, CutState::AirCutting, 8000.0);
  course.pass(3.0, CutState::Stable, 8000.0);
  course.pass(0.1, CutState::Onset, 8000.0, 905.0);  // neither quiet nor chatter
  course.pass(1.0, CutState::AirCutting, 8000.0);
  course.pass(3.0, CutState::Chatter, 8000.0, 800.0, true, ChatterKind::Forced);
  course.pass(5.0, CutState::Stable, 0.0);  // at a speed that nobody knows
  EXPECT_TRUE(course.end().empty());
}

}  // namespace
}  // namespace stillcut::learn
