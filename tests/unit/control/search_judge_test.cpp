// Which speed next, and whether an alarm is worth a move: over random cuts and verdicts.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "core/control/chatter_confirmation.h"
#include "core/control/pocket_search.h"

namespace stillcut::control {
namespace {

class Search : public testing::Test {
 protected:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  static CutSetup setupOf(int teeth) {
    CutSetup setup;
    setup.teeth = teeth;
    return setup;
  }
  std::mt19937 random_{23};
};

// Wherever it sends the spindle: within reach, and not to a speed that was heard to chatter.
TEST_F(Search, NeverGoesWhereItWasOrWhereNobodyReaches) {
  int ends = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    PocketSearch search;
    search.prepare(setupOf(1 + static_cast<int>(random_() % 6)));
    SearchView view;
    view.present = Rpm(between(3000.0, 15000.0));
    view.reach = {view.present * between(0.5, 0.9), view.present * between(1.05, 1.5)};
    const Hertz mode(between(300.0, 2500.0));
    std::vector<Rpm> heard;
    for (int step = 0; step < static_cast<int>(PocketSearch::kTried); ++step) {
      view.chatter = mode * between(0.98, 1.05);
      heard.push_back(view.present);
      const NextSpeed next = search.next(view);
      // What is said to be out of reach is, what is said to be here is.
      const std::array<double, 4>& said = next.reason.n;
      if (next.reason.code == ReasonCode::NextPocketInRange) {
        EXPECT_FALSE(view.reach.contains(Rpm(said[2])));
      }
      if (next.speed.value <= 0.0) {
        const bool here = view.reach.contains(Rpm(said[0]));
        EXPECT_EQ(next.reason.code, here ? ReasonCode::AlreadyThere : ReasonCode::TargetOutOfRange);
        ++ends;
        break;
      }
      ASSERT_TRUE(view.reach.contains(next.speed)) << next.speed.value;
      EXPECT_EQ(next.reason.n[0], next.speed.value);
      for (Rpm speed : heard) {
        ASSERT_GE(std::abs((next.speed - speed).value), 0.0099 * next.speed.value) << trial << " " << step;
      }
      view.present = next.speed;
    }
  }
  EXPECT_GT(ends, 100);
}

// The chatter frequency falls with the speed as a lobe's does; the sequence ends at the centre the sooner for it.
TEST_F(Search, TwoSpeedsTellTheCentreOfAFallingFrequency) {
  PocketSearch search;
  search.prepare(setupOf(4));
  const auto chatterAt = [](Rpm n) { return Hertz(900.0 + 0.01 * (n.value - 7000.0)); };
  // The fixed point of n = 60 f(n) / (2 * 4).
  const double centre = (900.0 - 70.0) * 7.5 / (1.0 - 0.075);
  SearchView view{chatterAt(Rpm(8000.0)), Rpm(8000.0), {Rpm(5000.0), Rpm(9000.0)}};
  const Rpm first = search.next(view).speed;
  view.present = first;
  view.chatter = chatterAt(first);
  const double before = std::abs(first.value - centre);
  const NextSpeed second = search.next(view);
  if (second.reason.code == ReasonCode::CentreOfNextPocket) {
    EXPECT_LT(std::abs(second.speed.value - centre), 0.2 * before);
  }
  EXPECT_LT(before, 0.02 * centre);
}

StableSpeeds lobesOf(const std::vector<std::pair<double, double>>& ranges) {
  StableSpeeds known;
  for (const auto& [from, to] : ranges) {
    StableSpeeds::Range range;
    range.from = Rpm(from);
    range.to = Rpm(to);
    range.best = Rpm(0.5 * (from + to));
    known.ranges.push_back(range);
  }
  known.depth = Metres(2e-3);
  known.largestStableDepth = Metres(1e-3);
  known.largestDepthSpeed = Rpm(7000.0);
  return known;
}

// Liao's first cut: chatter at 168 Hz from 949 rpm, at 158 Hz from 840 rpm; the pocket is 717 to 784 rpm wide.
TEST_F(Search, TwoSpeedsTellWhereThePocketsCentreIs) {
  PocketSearch search;
  search.prepare(setupOf(4));
  const config::SpeedRange reach{Rpm(475.0), Rpm(1000.0)};
  const NextSpeed first = search.next({Hertz(167.9), Rpm(949.0), reach});
  EXPECT_NEAR(first.speed.value, 839.5, 0.1);  // eq. 30
  const NextSpeed second = search.next({Hertz(157.8), Rpm(840.0), reach});
  // The frequency falls by 0.0927 Hz a rev/min: where 60 f / (3 Z) is the speed itself.
  EXPECT_NEAR(second.speed.value, 744.8, 1.5);
  EXPECT_EQ(second.reason.n[1], 3.0);
}

// Another mode at each side, and each points at the other: what is stable lies between them, if anything is.
TEST_F(Search, BetweenTheFrequenciesOfTwoModesItInterpolates) {
  PocketSearch search;
  search.prepare(setupOf(4));
  const config::SpeedRange reach{Rpm(475.0), Rpm(1000.0)};
  search.next({Hertz(167.9), Rpm(949.0), reach});
  const NextSpeed second = search.next({Hertz(176.0), Rpm(840.0), reach});  // rises as the speed falls
  // 109.5 rev/min down from the one, 40 up from the other.
  EXPECT_NEAR(second.speed.value, 840.0 + 109.0 * 40.0 / 149.5, 0.1);
}

// A random tool with modes at 1205 and 1288 Hz, stable at 8854 to 9373 rpm: the second step goes too far.
TEST_F(Search, AStepTooFarIsTakenBackHalfway) {
  PocketSearch search;
  search.prepare(setupOf(4));
  const config::SpeedRange reach{Rpm(6000.0), Rpm(14400.0)};
  const Rpm first = search.next({Hertz(1275.0), Rpm(11998.0), reach}).speed;
  const Rpm second = search.next({Hertz(1179.0), first, reach}).speed;
  ASSERT_LT(second, Rpm(8854.0));
  const Rpm third = search.next({Hertz(1395.0), second, reach}).speed;
  EXPECT_GT(third, Rpm(8854.0));
  EXPECT_LT(third, Rpm(9373.0));
}

// Chatter at 444 Hz from 5224 rpm wants 6660 rpm; the override ends at 6269.
TEST_F(Search, TheEdgeOfTheReachIsTakenWhereAQuarterWaveIsLeft) {
  PocketSearch search;
  search.prepare(setupOf(4));
  const config::SpeedRange reach{Rpm(2612.0), Rpm(6269.0)};
  const NextSpeed edge = search.next({Hertz(444.0), Rpm(5224.0), reach});
  EXPECT_EQ(edge.speed, Rpm(6269.0));
  EXPECT_EQ(edge.reason.code, ReasonCode::QuarterWave);  // it is no pocket's centre, and is not said to be one
  EXPECT_NEAR(edge.reason.n[1], 444.0 * 60.0 / (6269.0 * 4.0), 1e-9);
  EXPECT_EQ(search.next({Hertz(460.0), Rpm(6269.0), reach}).reason.n[1], 2.0);  // chatters there too: the next pocket
  PocketSearch other;
  other.prepare(setupOf(4));
  const config::SpeedRange narrow{Rpm(2612.0), Rpm(5600.0)};
  EXPECT_EQ(other.next({Hertz(500.0), Rpm(5224.0), narrow}).speed, Rpm(3750.0));  // a third of a wave
}

// A random tool with modes at 470 and 516 Hz, three teeth: 3.56 waves at 2855 rev/min are 3.1 of its own frequency.
TEST_F(Search, FarAboveAPocketTheNextOneUpIsTheNearer) {
  PocketSearch search;
  search.prepare(setupOf(3));
  const config::SpeedRange reach{Rpm(1427.0), Rpm(3426.0)};
  const NextSpeed first = search.next({Hertz(508.0), Rpm(2855.0), reach});
  EXPECT_EQ(first.reason.n[1], 3.0);
  EXPECT_NEAR(first.speed.value, 60.0 * 508.0 / 9.0, 0.1);
  PocketSearch other;
  other.prepare(setupOf(3));
  EXPECT_EQ(other.next({Hertz(540.0), Rpm(2855.0), reach}).reason.n[1], 4.0);  // 3.78 waves: as eq. 29 rounds
}

// Modes at 1199 and 1139 Hz, two teeth, stable at 16870 to 17436 rev/min: from above the rule's own step ends there.
TEST_F(Search, FromAboveAPocketTheRulesOwnStepIsTaken) {
  PocketSearch search;
  search.prepare(setupOf(2));
  const config::SpeedRange reach{Rpm(8245.0), Rpm(19787.0)};
  const Rpm first = search.next({Hertz(1242.0), Rpm(16489.0), reach}).speed;
  const Rpm second = search.next({Hertz(1163.5), first, reach}).speed;
  EXPECT_NEAR(second.value, 15.0 * 1163.5, 0.1);  // two waves between the teeth
}

TEST_F(Search, KnownLobesKeepItInsideAStableRange) {
  for (int trial = 0; trial < 1000; ++trial) {
    CutSetup setup = setupOf(4);
    const double from = between(4000.0, 9000.0);
    setup.stableSpeeds = lobesOf({{from, from + between(200.0, 1500.0)}});
    PocketSearch search;
    search.prepare(setup);
    const SearchView view{Hertz(between(500.0, 1500.0)), Rpm(12000.0), {Rpm(3000.0), Rpm(13000.0)}};
    const NextSpeed next = search.next(view);
    ASSERT_EQ(next.reason.code, ReasonCode::PocketByLobes);
    const auto& range = setup.stableSpeeds->ranges.front();
    const Rpm room = (range.to - range.from) * 0.19;  // a fifth is kept on either side
    EXPECT_GT(next.speed, range.from + room);
    EXPECT_LT(next.speed, range.to - room);
  }
}

TEST_F(Search, LobesWithoutAStableSpeedNameTheDepthThatWouldDo) {
  CutSetup setup = setupOf(4);
  setup.stableSpeeds = lobesOf({});
  PocketSearch search;
  search.prepare(setup);
  const NextSpeed next = search.next({Hertz(937.0), Rpm(8500.0), {Rpm(5000.0), Rpm(10000.0)}});
  EXPECT_EQ(next.speed.value, 0.0);
  EXPECT_EQ(next.reason.code, ReasonCode::NoStableSpeed);
  EXPECT_DOUBLE_EQ(next.reason.n[0], 2.0);
  EXPECT_DOUBLE_EQ(next.reason.n[1], 1.0);
  EXPECT_EQ(next.reason.n[2], 7000.0);
}

TEST_F(Search, OfTwoPocketsTheNearerOne) {
  CutSetup setup = setupOf(4);
  setup.stableSpeeds = lobesOf({{5000.0, 5600.0}, {7000.0, 7600.0}});
  PocketSearch search;
  search.prepare(setup);
  const SearchView view{Hertz(937.0), Rpm(8500.0), {Rpm(4000.0), Rpm(10000.0)}};
  EXPECT_GT(search.next(view).speed, Rpm(7000.0));
  search.forget();
  EXPECT_EQ(search.tried(), 0);
}

// Verdicts by the hundredth of a second.
class Judge : public testing::Test {
 protected:
  static Verdict alarm(Hertz f, double severity, CutState state = CutState::Chatter) {
    Verdict v;
    v.valid = true;
    v.state = state;
    v.phase = CutPhase::Steady;
    v.frequency = f;
    v.severity = Ratio(severity);
    return v;
  }
  void update(const Verdict& v, double seconds, bool moved = false, double vibration = -1.0) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 100.0)); ++i) {
      judge_.update(v, Seconds(0.01), {Hertz(140.0), 4, moved}, vibration);
    }
  }
  ChatterConfirmation judge_;
};

TEST_F(Judge, AnAlarmMustStandAtOneFrequencyForAMoment) {
  update(alarm(Hertz(937.0), 0.3), 0.04);
  EXPECT_FALSE(judge_.confirmed());
  update(alarm(Hertz(937.0), 0.3), 0.04);
  EXPECT_TRUE(judge_.confirmed());
  EXPECT_NEAR(judge_.frequency().value, 937.0, 1e-9);
}

// f + k f_sp is the same chatter: a detector that names another member is not held against it.
TEST_F(Judge, MembersOfOneFamilyCountAsOneFrequency) {
  for (int i = 0; i < 20; ++i) update(alarm(Hertz(937.0 + 140.0 * (i % 3)), 0.3), 0.01);
  EXPECT_TRUE(judge_.confirmed());
}

TEST_F(Judge, AFrequencyThatJumpsAboutIsNoChatter) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(300.0, 3000.0);
  int confirmed = 0;
  for (int i = 0; i < 500; ++i) {
    update(alarm(Hertz(anywhere(random)), 0.3), 0.01);
    confirmed += judge_.confirmed() ? 1 : 0;
  }
  EXPECT_LT(confirmed, 10);
}

TEST_F(Judge, InvalidQuietAndStandingSpindleAreNothing) {
  Verdict invalid = alarm(Hertz(937.0), 0.3);
  invalid.valid = false;
  update(invalid, 1.0);
  EXPECT_FALSE(judge_.confirmed());
  update(alarm(Hertz(937.0), 0.3, CutState::Stable), 1.0);
  EXPECT_FALSE(judge_.confirmed());
  for (int i = 0; i < 100; ++i) judge_.update(alarm(Hertz(937.0), 0.3), Seconds(0.01), {Hertz(0.0), 4, false});
  EXPECT_FALSE(judge_.confirmed());
}

TEST_F(Judge, AGapEndsItASingleMissedVerdictDoesNot) {
  update(alarm(Hertz(937.0), 0.3), 0.1);
  update(alarm(Hertz(937.0), 0.0, CutState::Stable), 0.03);
  EXPECT_GT(judge_.frequency().value, 0.0);
  update(alarm(Hertz(937.0), 0.3), 0.02);
  EXPECT_TRUE(judge_.confirmed());
  update(alarm(Hertz(937.0), 0.0, CutState::Stable), 0.08);
  EXPECT_EQ(judge_.frequency().value, 0.0);
  EXPECT_FALSE(judge_.confirmed());
}

TEST_F(Judge, AfterAMoveWhatRingsDownIsNotChatter) {
  for (int i = 0; i < 200; ++i) update(alarm(Hertz(937.0), 0.6 * std::exp(-0.02 * i)), 0.01, true);
  EXPECT_FALSE(judge_.confirmed());
}

TEST_F(Judge, AfterAMoveWhatGrowsIs) {
  bool confirmed = false;
  for (int i = 0; i < 100; ++i) {
    update(alarm(Hertz(937.0), 0.02 * std::exp(0.04 * i), CutState::Onset), 0.01, true);
    confirmed = confirmed || judge_.confirmed();
  }
  EXPECT_TRUE(confirmed);
}

// A move has just put a tooth harmonic where the chatter was: a line on a harmonic is the cut's own.
TEST_F(Judge, AfterAMoveALineOnAHarmonicIsTheCuts) {
  update(alarm(Hertz(7.0 * 140.0), 0.5), 2.0, true);
  EXPECT_FALSE(judge_.confirmed());
  judge_.forget();
  update(alarm(Hertz(7.0 * 140.0), 0.5), 2.0, false);
  EXPECT_TRUE(judge_.confirmed());
}

TEST_F(Judge, StandingStillAsLoudAsBeforeTheMoveIsChatter) {
  const Verdict calm = alarm(Hertz(0.0), 0.0, CutState::Stable);
  update(calm, 3.0, false, 1.0);
  update(alarm(Hertz(937.0), 0.5), 1.0, false, 20.0);
  update(calm, 0.2, true, 1.0);
  update(alarm(Hertz(937.0), 0.5, CutState::Onset), 1.5, true, 20.0);
  EXPECT_TRUE(judge_.confirmed());
}

// Chatter can lock on an order of the spindle that is none of the teeth's.
TEST_F(Judge, FullChatterLouderThanBeforeOnASpindleOrderIsChatter) {
  update(alarm(Hertz(0.0), 0.0, CutState::Stable), 3.0, false, 1.0);
  update(alarm(Hertz(937.0), 0.5), 1.0, false, 10.0);
  update(alarm(Hertz(8.0 * 140.0), 0.9), 2.0, true, 20.0);
  EXPECT_FALSE(judge_.confirmed());
  judge_.forget();
  update(alarm(Hertz(7.0 * 140.0), 0.9), 2.0, true, 20.0);
  EXPECT_TRUE(judge_.confirmed());
}

// A detector that has learned its floor while it chattered calls it stable; what does not repeat tells.
TEST_F(Judge, ChatterThatNobodyTellsAfterAMoveIsHeardAllTheSame) {
  update(alarm(Hertz(0.0), 0.0, CutState::Stable), 3.0, false, 1.0);
  update(alarm(Hertz(937.0), 0.5), 1.0, false, 20.0);
  update(alarm(Hertz(0.0), 0.01, CutState::Stable), 3.0, true, 20.0);
  EXPECT_FALSE(judge_.confirmed()) << "a resonance repeats, however loud";
  update(alarm(Hertz(0.0), 0.5, CutState::Stable), 0.8, true, 20.0);
  EXPECT_FALSE(judge_.confirmed()) << "it may be dying";
  update(alarm(Hertz(0.0), 0.5, CutState::Stable), 0.4, true, 20.0);
  EXPECT_TRUE(judge_.confirmed());
  EXPECT_NEAR(judge_.frequency().value, 937.0, 1e-9);
}

TEST_F(Judge, NumbersThatAreNoneChangeNothing) {
  update(alarm(Hertz(937.0), 0.3), 0.2);
  judge_.update(alarm(Hertz(937.0), std::nan("")), Seconds(std::nan("")), {Hertz(140.0), 4, false}, std::nan(""));
  EXPECT_NEAR(judge_.frequency().value, 937.0, 1e-9);
  EXPECT_TRUE(std::isfinite(judge_.level()));
}

}  // namespace
}  // namespace stillcut::control
