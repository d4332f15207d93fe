// The gate and the person at the machine: what is asked, accepted, refused, granted.
#include <gtest/gtest.h>

#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using testing::GateHarness;
using testing::promptLimits;

TEST(GateAdvice, AdviseAsksAndAcceptExecutesThatOneAdvice) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Advise);
  h.ask(9000, 900);
  h.run(1.0);
  EXPECT_TRUE(h.commands.empty());
  EXPECT_TRUE(h.last.adviceOpen);
  h.act(OperatorAction::Accept);
  h.run(1.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
  EXPECT_FALSE(h.last.adviceOpen);
  // Another wish is another advice: the accepted one stays until that is answered, too.
  h.ask(8000, 800);
  h.run(1.0);
  EXPECT_TRUE(h.last.adviceOpen);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9);
}

// An estimate wavers, and the wish with it: what is read stands still, is what is accepted, and is not asked for anew.
TEST(GateAdvice, StandsStillWhileItIsOpen) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Advise);
  h.ask(9000, 900);
  h.run(0.5);
  const std::uint32_t number = h.last.adviceNumber;
  for (const double speed : {9030.0, 8960.0, 9070.0}) {
    h.ask(speed, 0.1 * speed);
    h.run(0.5);
    EXPECT_EQ(h.last.adviceNumber, number) << speed;
    EXPECT_DOUBLE_EQ(h.last.advice.speed.value, 9000.0) << speed;
  }
  h.act(OperatorAction::Accept);
  h.run(1.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.9, 1e-9) << "what was read, not what was wished meanwhile";
  EXPECT_FALSE(h.last.adviceOpen);
  h.ask(9200, 920);
  h.run(0.5);
  EXPECT_TRUE(h.last.adviceOpen) << "another place is another advice";
  EXPECT_NE(h.last.adviceNumber, number);
}

// Accepted while something still kept the gate from moving.
class AcceptedAdvice : public ::testing::Test {
 protected:
  void SetUp() override {
    h_.verdict.state = CutState::Chatter;
    h_.authority(Authority::Advise);
    h_.ask(9000, 900);
    h_.run(0.2);
    h_.machine.atSpeed = false;
    h_.act(OperatorAction::Accept);
    h_.run(0.5);
    ASSERT_TRUE(h_.commands.empty());
  }
  GateHarness h_;
};

TEST_F(AcceptedAdvice, WaitsForTheMachine) {
  h_.machine.atSpeed = true;
  h_.run(1.0);
  ASSERT_FALSE(h_.commands.empty());
  EXPECT_NEAR(h_.lastCommand().speed.value, 0.9, 1e-9);
}

TEST_F(AcceptedAdvice, EndsWithTheProgrammedSpeedItWasGivenFor) {
  h_.machine.programmedSpeed = h_.machine.actualSpeed = Rpm(3000.0);
  h_.request.kind = RequestKind::None;
  h_.machine.atSpeed = true;
  h_.run(1.0);
  EXPECT_TRUE(h_.commands.empty());
  EXPECT_TRUE(h_.said(ReasonCode::AdviceChanged));
}

TEST_F(AcceptedAdvice, EndsWhenNobodyAsksForItAnyMore) {
  h_.request.kind = RequestKind::None;
  h_.machine.atSpeed = true;
  h_.run(1.0);
  EXPECT_TRUE(h_.commands.empty());
}

TEST_F(AcceptedAdvice, EndsWithTrouble) {
  h_.verdict.valid = false;
  h_.step();
  h_.verdict.valid = true;
  h_.machine.atSpeed = true;
  h_.run(1.0);
  EXPECT_TRUE(h_.commands.empty());
}

TEST(GateAdvice, RefusedAdviceIsNotRepeatedAndNothingMoves) {
  GateHarness h;
  h.authority(Authority::Advise);
  h.ask(9000, 900);
  h.run(0.1);
  const GateOutput out = h.act(OperatorAction::Refuse);
  EXPECT_TRUE(out.flight);
  EXPECT_TRUE(h.said(ReasonCode::AdviceRefused));
  h.run(5.0);
  EXPECT_FALSE(h.last.adviceOpen);
  h.ask(8000, 800);  // not the like of it
  h.run(0.1);
  EXPECT_TRUE(h.last.adviceOpen);
  EXPECT_TRUE(h.commands.empty());
}

TEST(GateAdvice, AnAdviceThatChangedUnderTheFingerIsNotTakenForTheOneThatWasRead) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Advise);
  h.ask(9000, 900);
  h.run(0.5);
  const std::uint32_t read = h.last.adviceNumber;
  h.ask(9003, 900.3);  // the frequency's noise: the same advice to the eye
  h.run(0.1);
  EXPECT_EQ(h.last.adviceNumber, read);
  h.ask(7000, 700);
  h.step();  // it jumps as the finger lands
  EXPECT_NE(h.last.adviceNumber, read);
  h.flights = 0;
  h.step({{OperatorAction::Accept, Authority::Off, read}});
  EXPECT_EQ(h.flights, 1);
  EXPECT_TRUE(h.said(ReasonCode::AdviceChanged));
  h.run(1.0);
  EXPECT_TRUE(h.commands.empty()) << "nobody accepted 7000 rpm";
  EXPECT_TRUE(h.last.adviceOpen);
  h.act(OperatorAction::Accept);
  h.run(1.5);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.7, 1e-9);
}

// In force by an accepted advice; then the strategy wants the programmed values back.
class AdvisedReturn : public ::testing::Test {
 protected:
  void SetUp() override {
    h_.verdict.state = CutState::Chatter;
    h_.authority(Authority::Advise);
    h_.ask(9000, 900);
    h_.run(0.2);
    h_.act(OperatorAction::Accept);
    h_.run(2.0);
    ASSERT_NEAR(h_.lastCommand().speed.value, 0.9, 1e-9);
    h_.verdict.state = CutState::Stable;
    h_.request = {};
    h_.request.kind = RequestKind::Release;
    h_.run(5.0);
  }
  GateHarness h_;
};

TEST_F(AdvisedReturn, IsAskedAndNothingMovesUntilItIsAccepted) {
  EXPECT_TRUE(h_.last.adviceOpen);
  EXPECT_NEAR(h_.lastCommand().speed.value, 0.9, 1e-9);
  EXPECT_NEAR(h_.lastCommand().feed.value, 0.9, 1e-9);
  h_.events.clear();
  h_.act(OperatorAction::Accept);
  ASSERT_FALSE(h_.events.empty());
  EXPECT_EQ(h_.events.front().reason.code, ReasonCode::AdviceAccepted);  // one line, with where it leads
  EXPECT_NEAR(h_.events.front().reason.n[0], 10000.0, 1e-9);
  EXPECT_NEAR(h_.events.front().reason.n[1], 1000.0, 1e-9);
  EXPECT_FALSE(h_.last.adviceOpen);
  h_.run(0.25);
  EXPECT_LT(h_.lastCommand().speed.value, 0.96);  // 20 % of 100 %/s: a recovery
  h_.run(1.5);
  EXPECT_FALSE(h_.last.commanding);
  EXPECT_EQ(h_.lastCommand().kind, CommandKind::Release);
}

TEST_F(AdvisedReturn, RefusedKeepsWhatIsInForce) {
  h_.act(OperatorAction::Refuse);
  h_.run(5.0);
  EXPECT_FALSE(h_.last.adviceOpen);
  EXPECT_NEAR(h_.lastCommand().speed.value, 0.9, 1e-9);
}

TEST_F(AdvisedReturn, IsNotTakenForAMoveAndAMoveNotForIt) {
  const std::uint32_t read = h_.last.adviceNumber;
  h_.ask(8000, 800);  // it jumps as the finger lands
  h_.step({{OperatorAction::Accept, Authority::Off, read}});
  h_.run(1.0);
  EXPECT_NEAR(h_.lastCommand().speed.value, 0.9, 1e-9);
}

TEST(GateAdvice, AMoveUnderWayStopsWhenAutoBecomesAdvise) {
  GateHarness h;
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.ask(8000, 800);
  h.run(0.1);
  h.authority(Authority::Advise);
  const double there = h.lastCommand().speed.value;
  ASSERT_GT(there, 0.85);
  h.run(2.0);
  EXPECT_EQ(h.lastCommand().speed.value, there);
  EXPECT_TRUE(h.last.adviceOpen);  // the rest of it
  h.act(OperatorAction::Accept);
  h.run(2.0);
  EXPECT_NEAR(h.lastCommand().speed.value, 0.8, 1e-9);
}

TEST(GateAdvice, AWayBackUnderWayStopsToo) {
  GateHarness h;
  h.settleAt(8000, 800);
  h.verdict.state = CutState::Stable;
  h.request = {};
  h.request.kind = RequestKind::Release;
  h.run(0.3);
  h.authority(Authority::Advise);
  const double there = h.lastCommand().speed.value;
  ASSERT_LT(there, 0.95);
  h.run(3.0);
  EXPECT_EQ(h.lastCommand().speed.value, there);
  EXPECT_TRUE(h.last.adviceOpen);
}

TEST(GateAdvice, AcceptWithoutOpenAdviceDoesNothing) {
  GateHarness h;
  h.authority(Authority::Advise);
  h.act(OperatorAction::Accept);
  h.ask(9000, 900);
  h.step();
  h.run(0.5);
  EXPECT_TRUE(h.commands.empty());
}

TEST(GateAdvice, AGrantOfTheSimulationIsSaidAsOne) {
  GateHarness h;
  h.act(OperatorAction::GrantBySimulation);
  EXPECT_EQ(h.last.authority, Authority::Auto);
  EXPECT_TRUE(h.said(ReasonCode::AutoGrantedBySimulation));
  GateLimits limits = promptLimits();
  limits.autoAllowed = false;
  GateHarness refused(limits);
  refused.act(OperatorAction::GrantBySimulation);
  EXPECT_EQ(refused.last.authority, Authority::Off);
  EXPECT_FALSE(refused.said(ReasonCode::AutoGrantedBySimulation));
}

}  // namespace
}  // namespace stillcut::safety
