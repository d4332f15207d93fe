// extremum-paper and extremum-seek on a plant like van Dijk's figure 7: H is least at 33 600 rpm, Delta f is zero at
// 33 000, the cut chatters above a level of H. The spindle follows with 60 ms delay and inertia.
#include "core/control/extremum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace stillcut::control {
namespace {

class Figure7 {
 public:
  explicit Figure7(FrequencyRule& strategy, double delay = 0.06) : strategy_(strategy) {
    CutSetup setup;
    setup.teeth = 2;
    strategy_.prepare(setup, {});
    in_.dt = Seconds(kDt);
    in_.machine.valid = true;
    in_.machine.programmedSpeed = in_.machine.actualSpeed = Rpm(35000.0);
    in_.machine.programmedFeed = fromMmPerMin(14000.0);
    in_.verdict.valid = true;
    pipe_.assign(static_cast<std::size_t>(delay / kDt) + 1, 35000.0);
  }
  static double level(double rpm) { return 1.0 + std::pow((rpm - 33600.0) / 400.0, 2.0); }

  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / kDt); ++i) {
      in_.now += toDuration(in_.dt);
      const double h = level(speed());
      in_.perturbation = h;
      in_.verdict.state = h > chatterAbove ? CutState::Chatter : CutState::Stable;
      in_.verdict.frequency = Hertz(h > chatterAbove ? 2200.0 : 0.0);
      last = strategy_.decide(in_);
      if (last.kind == RequestKind::Set && (asked.empty() || asked.back() != last.speed.value)) {
        asked.push_back(last.speed.value);
      }
      pipe_.push_back(last.kind == RequestKind::Set ? last.speed.value : pipe_.back());
      in_.machine.actualSpeed += Rpm((pipe_.front() - speed()) * 0.15);
      pipe_.pop_front();
    }
  }
  double speed() const { return in_.machine.actualSpeed.value; }

  void tellDelay(double seconds) { in_.machine.link.effect = Seconds(seconds); }

  double chatterAbove = 5.0;  // above 34 400 and below 32 800 rpm
  OverrideRequest last;
  std::vector<double> asked;

 private:
  static constexpr double kDt = 0.01;
  FrequencyRule& strategy_;
  StrategyInput in_;
  std::deque<double> pipe_;
};

TEST(ExtremumPaper, GoesTheRightWay) {
  // Delta f = 2200 - 2 * 35 000 * 2 / 60 < 0: the speed must fall, which the printed minus sign would not do.
  ExtremumPaper strategy;
  Figure7 plant(strategy);
  plant.run(0.02);
  ASSERT_EQ(plant.last.kind, RequestKind::Set);
  EXPECT_LT(plant.last.speed.value, 35000.0);
  // First step: sqrt(H)/gamma = 1/lambda, so 2 * 0.7 / 0.3 units of half a percent.
  EXPECT_NEAR(plant.last.speed.value, 35000.0 * (1.0 - 2.0 * 0.7 / 0.3 * 0.005), 1e-6);
}

TEST(ExtremumPaper, StopsWhereChatterStops) {
  ExtremumPaper strategy;
  Figure7 plant(strategy);
  plant.run(5.0);
  EXPECT_LT(plant.level(plant.speed()), plant.chatterAbove);
  EXPECT_EQ(plant.last.reason.code, ReasonCode::KeepingSpeed);
}

// The cut turns quiet at 34 400 rpm. On a machine that takes 0.4 s a law with a period of 0.1 s has taken three steps
// too many by the time that shows, unless it knows how late its orders act.
TEST(ExtremumPaper, WaitsForTheEffectOnASlowMachine) {
  constexpr double kSlow = 0.4;
  const auto lowest = [](bool told) {
    ExtremumPaper strategy;
    Figure7 plant(strategy, kSlow);
    if (told) plant.tellDelay(kSlow);
    plant.run(8.0);
    return *std::min_element(plant.asked.begin(), plant.asked.end());
  };
  const double knowing = lowest(true), unknowing = lowest(false);
  EXPECT_GT(knowing - unknowing, 2.0 * 2.0 * 0.7 * 0.005 * 35000.0);  // two steps of eq. 32 at least
}

TEST(ExtremumPaper, SettlesAtZeroDeltaFAndNotAtTheMinimum) {
  ExtremumPaper strategy;
  Figure7 plant(strategy);
  plant.chatterAbove = 0.0;  // chatter everywhere: the law is never let off
  plant.run(20.0);
  EXPECT_NEAR(plant.speed(), 33000.0, 0.015 * 33000.0);
  double mean = 0.0;
  for (int i = 0; i < 400; ++i) {
    plant.run(0.01);
    mean += plant.speed() / 400.0;
  }
  EXPECT_NEAR(mean, 33000.0, 250.0);
}

TEST(ExtremumSeek, FindsTheMinimumOfH) {
  ExtremumSeek strategy;
  Figure7 plant(strategy);
  plant.run(20.0);
  EXPECT_EQ(plant.last.reason.code, ReasonCode::MinimumFound);
  EXPECT_NEAR(plant.speed(), 33600.0, 60.0);
  EXPECT_LE(plant.asked.size(), static_cast<std::size_t>(MinimumSearch::kMostTrials) + 8);
}

TEST(ExtremumSeek, EndsQuieterThanThePaperLawForEveryDelay) {
  for (double delay = 0.0; delay <= 0.121; delay += 0.02) {
    ExtremumPaper paper;
    ExtremumSeek seek;
    Figure7 a(paper, delay);
    Figure7 b(seek, delay);
    a.run(20.0);
    b.run(20.0);
    EXPECT_LT(Figure7::level(b.speed()), Figure7::level(a.speed())) << delay;
    EXPECT_LT(Figure7::level(b.speed()), 1.05) << delay;
  }
}

TEST(ExtremumSeek, AfterTheSearchItStays) {
  ExtremumSeek strategy;
  Figure7 plant(strategy);
  plant.run(20.0);
  const std::size_t before = plant.asked.size();
  plant.run(20.0);
  EXPECT_EQ(plant.asked.size(), before);
}

TEST(ExtremumSeek, BeginsWhereTheLawWouldSettleAndNotAtThePocketsEdge) {
  ExtremumSeek strategy;
  Figure7 plant(strategy);
  plant.run(3.0);
  // Chatter at 2200 Hz, two teeth: Delta f = 0 at 33 000 rpm. The law itself is quiet from 34 400 on.
  EXPECT_TRUE(
      std::any_of(plant.asked.begin(), plant.asked.end(), [](double rpm) { return std::abs(rpm - 33000.0) < 20.0; }));
}

TEST(ExtremumSeek, ChatterDuringTheSearchClosesThatSide) {
  // A narrow pocket: quiet only from 33 400 to 33 800, narrower than the steps of the search.
  ExtremumSeek strategy;
  Figure7 plant(strategy);
  plant.chatterAbove = 1.3;
  plant.run(30.0);
  EXPECT_LT(Figure7::level(plant.speed()), 1.3);
  const std::size_t before = plant.asked.size();
  plant.run(20.0);
  EXPECT_EQ(plant.asked.size(), before);
}

TEST(MinimumSearch, ParabolaVertexOfUnevenNeighbours) {
  MinimumSearch search;
  MinimumSearch::Options options;
  options.wait = Seconds(0.0);
  options.dwell = Seconds(0.05);
  search.configure(options);
  search.start(Rpm(10000.0), Rpm(10000.0));
  const config::SpeedRange reach{Rpm(5000.0), Rpm(12000.0)};
  const auto level = [](Rpm n) { return 2.0 + std::pow((n.value - 9930.0) / 100.0, 2.0); };
  int steps = 0;
  while (search.state() == MinimumSearch::State::Searching && ++steps < 1000) {
    search.advance({0.01, level(search.trying()), search.trying(), reach});
  }
  EXPECT_EQ(search.state(), MinimumSearch::State::Done);
  EXPECT_NEAR(search.trying().value, 9930.0, 1e-6);
}

TEST(MinimumSearch, ALevelThatDriftsWithTheDepthDoesNotHideTheMinimum) {
  MinimumSearch search;
  search.configure({});
  search.start(Rpm(34200.0), Rpm(35000.0));
  double t = 0.0;
  for (int i = 0; i < 2000 && search.state() == MinimumSearch::State::Searching; ++i, t += 0.01) {
    const double rpm = search.trying().value;
    const double level = (1.0 + std::pow((rpm - 33000.0) / 4000.0, 2.0)) * (1.0 + 0.06 * t);  // 3 % of curve, 6 %/s
    search.advance({0.01, level, Rpm(rpm), {Rpm(17500.0), Rpm(42000.0)}});
  }
  EXPECT_EQ(search.state(), MinimumSearch::State::Done);
  EXPECT_NEAR(search.trying().value, 33000.0, 360.0);
}

TEST(MinimumSearch, EndsAStepAwayFromANeighbourThatChattered) {
  MinimumSearch search;
  search.start(Rpm(9900.0), Rpm(10000.0));
  const config::SpeedRange reach{Rpm(9000.0), Rpm(11000.0)};
  for (int i = 0; i < 5000 && search.state() != MinimumSearch::State::Done; ++i) {
    if (search.trying() < Rpm(9750.0)) {
      EXPECT_TRUE(search.chattered());
    } else {
      search.advance({0.01, search.trying().value, search.trying(), reach});  // less the slower
    }
  }
  ASSERT_EQ(search.state(), MinimumSearch::State::Done);
  EXPECT_NEAR(search.best().value, 9800.0, 1e-6);
  EXPECT_NEAR(search.trying().value, 9900.0, 1e-6);
}

// An override in whole per cents, as most machines have it, puts the spindle up to half a step beside what was asked.
TEST(MinimumSearch, EndsOnAMachineThatKnowsWholePerCentsOnly) {
  MinimumSearch search;
  search.configure({});
  const Rpm base(10000.0);
  search.start(Rpm(9645.0), base);
  Rpm present(9700.0);
  int steps = 0;
  for (; steps < 6000 && search.state() == MinimumSearch::State::Searching; ++steps) {
    const Rpm taken = base * (std::round(100.0 * (search.trying() / base)) / 100.0);
    present += 0.2 * (taken - present);
    const double level = 1.0 + std::pow((present.value - 9450.0) / 400.0, 2.0);
    search.advance({0.01, level, present, {Rpm(5000.0), Rpm(12000.0)}});
  }
  EXPECT_EQ(search.state(), MinimumSearch::State::Done);
  EXPECT_NEAR(search.trying().value, 9450.0, 60.0);
}

// One that has not begun to move is a whole step away: the speed before is not taken for the next.
TEST(MinimumSearch, WaitsForASpindleThatHasNotMoved) {
  MinimumSearch search;
  search.configure({});
  search.start(Rpm(9600.0), Rpm(10000.0));
  const config::SpeedRange reach{Rpm(5000.0), Rpm(12000.0)};
  while (search.trying() == Rpm(9600.0)) search.advance({0.01, 1.0, Rpm(9600.0), reach});
  const Rpm next = search.trying();
  for (int i = 0; i < 1000; ++i) search.advance({0.01, 1.0, Rpm(9600.0), reach});
  EXPECT_EQ(search.trying(), next);
}

TEST(MinimumSearch, StaysInReach) {
  MinimumSearch search;
  MinimumSearch::Options options;
  options.wait = Seconds(0.0);
  options.dwell = Seconds(0.05);
  search.configure(options);
  search.start(Rpm(10000.0), Rpm(10000.0));
  const config::SpeedRange reach{Rpm(9850.0), Rpm(10050.0)};
  for (int i = 0; i < 500; ++i) {
    const Rpm n = search.advance({0.01, std::pow(search.trying().value / 1e4, 10.0), search.trying(), reach});
    EXPECT_TRUE(reach.contains(n));
  }
  EXPECT_EQ(search.state(), MinimumSearch::State::Done);
  EXPECT_NEAR(search.trying().value, 9900.0, 1e-9);
}

}  // namespace
}  // namespace stillcut::control
