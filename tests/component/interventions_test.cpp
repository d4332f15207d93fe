// Auto does not hunt: a speed that is told wrong, a sensor that comes in bursts, a tone that is none of the cut's. A
// minute and a quarter of cut, in virtual time: the machine is swung twice at the most, then there is advice only, and
// the operator reads why.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/closed_loop/rough_run.h"
#include "tests/support/demo_cut.h"

namespace stillcut::test {
namespace {

constexpr double kSeconds = 76.0;

void expectAdviceAfterTwo(const RoughRun& run) {
  EXPECT_LE(run.swings(), 2) << run.story();
  EXPECT_GE(run.swings(), 1) << "nothing was tried: " << run.story();
  EXPECT_EQ(run.events(ReasonCode::AutoWithoutHelp), 1) << run.story();
  EXPECT_EQ(run.authority(), Authority::Advise);
  EXPECT_FALSE(run.commanding());
  EXPECT_EQ(run.machine().speedOverride, Ratio(1.0));
  EXPECT_EQ(run.machine().feedOverride, Ratio(1.0));
}

TEST(Interventions, AFrozenSpeedReading) {
  Roughness rough;
  rough.speedFreezesAt = 1.0;  // at the programmed speed
  RoughRun run(demoCut(kSeconds), rough);
  run.toEnd();
  expectAdviceAfterTwo(run);
}

// Back at the programmed values the machine seems not to be at speed, and is not taken again.
TEST(Interventions, ASpeedReadingThatFreezesOnTheWay) {
  Roughness rough;
  rough.speedFreezesAt = 2.2;
  RoughRun run(demoCut(20.0), rough);
  run.toEnd();
  EXPECT_EQ(run.swings(), 1) << run.story();
  EXPECT_EQ(run.events(ReasonCode::InterventionNoHelp), 1) << run.story();
  EXPECT_FALSE(run.commanding());
  EXPECT_EQ(run.machine().speedOverride, Ratio(1.0));
}

TEST(Interventions, ASensorThatComesInBursts) {
  for (const double burst : {0.3, 0.9}) {
    Roughness rough;
    rough.burst = Seconds(burst);
    RoughRun run(demoCut(kSeconds), rough);
    run.toEnd();
    EXPECT_LE(run.swings(), 2) << burst << "\n" << run.story();
    EXPECT_EQ(run.authority(), run.swings() == 0 ? Authority::Auto : Authority::Advise) << burst << "\n" << run.story();
    EXPECT_EQ(run.machine().speedOverride, Ratio(1.0)) << burst;
  }
}

// 700 Hz that no speed of the spindle changes, far louder than the cut.
TEST(Interventions, AForeignTone) {
  Roughness rough;
  rough.spoil = [](SampleBlock& block, double t) {
    if (t < 1.0) return;
    for (int c = 0; c < block.channels; ++c) {
      for (int i = 0; i < block.frames; ++i) {
        const double phase = 2.0 * std::numbers::pi * 700.0 * (t + i / block.rate.value) + c;
        block.channel(c)[static_cast<std::size_t>(i)] += static_cast<float>(0.5 * std::sin(phase));
      }
    }
  };
  milling::Scenario cut = demoCut(kSeconds);
  cut.programme.depth = milling::constantSchedule(0.5e-3);  // stable at every speed
  RoughRun run(cut, rough);
  run.toEnd();
  expectAdviceAfterTwo(run);
}

// Finite in a float, and no sensor's.
TEST(Interventions, AbsurdSamplesMoveNothing) {
  Roughness rough;
  long n = 0;
  rough.spoil = [&n](SampleBlock& block, double t) {
    if (t < 1.2) return;
    for (int c = 0; c < block.channels; ++c) {
      for (float& v : block.channel(c)) v = (n++ & 8) != 0 ? 3e38F : -3e38F;
    }
  };
  RoughRun run(demoCut(12.0), rough);
  run.toEnd();
  EXPECT_EQ(run.swings(), 0) << run.story();
}

}  // namespace
}  // namespace stillcut::test
