// What goes wrong while our override is in force, in virtual time on the demo's machine: each script ends with the
// programmed values back (or, for the operator's own hand, with his say), with an event that a machinist understands,
// and with a flight recording that tells the story.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "tests/support/closed_loop/loop_run.h"
#include "tests/support/demo_cut.h"
#include "tests/support/scripted_parts.h"

namespace stillcut::test {
namespace {

using ::testing::HasSubstr;

// The demo's cut under Auto; the program's own detector and strategy, each with a switch that breaks it.
class FaultScript : public testing::Test {
 protected:
  FaultScript() : run_(demoCut(8.0), options()) {}

  LoopOptions options() {
    LoopOptions o;
    o.wrapDetector = [this](std::unique_ptr<detect::Detector> inner) -> std::unique_ptr<detect::Detector> {
      return std::make_unique<Breakable>(std::move(inner), detectorThrows_);
    };
    o.wrapStrategy = [this](std::unique_ptr<control::Strategy> inner) -> std::unique_ptr<control::Strategy> {
      return std::make_unique<Poisoned>(std::move(inner), strategyNaN_);
    };
    return o;
  }
  bool advance() {
    if (!run_.advance()) return false;
    const StepOutput& out = run_.last().output;
    for (int i = 0; i < out.eventCount; ++i) {
      events_.push_back(sentence(out.events[static_cast<std::size_t>(i)].reason));
    }
    safety::FlightRecording flight;
    while (run_.flights().take(flight)) flights_.push_back(safety::render(flight));
    return true;
  }
  void runFor(double seconds) {
    const double until = now() + seconds;
    while (now() < until && advance()) {
    }
  }
  double now() const { return run_.plant().time().value; }
  MachineState machine() const { return run_.plant().machineState(); }
  // Until the override is well on its way down, and events and flights so far are out of the way.
  void runMidRamp() {
    while (advance()) {
      const StepOutput& out = run_.last().output;
      if (out.hasCommand && out.command.kind == CommandKind::Set && out.command.speed.value < 0.93) break;
    }
    ASSERT_LT(machine().speedOverride.value, 1.0);
    runFor(0.05);
    events_.clear();
    flights_.clear();
  }
  bool said(const std::string& text) const {
    for (const std::string& e : events_) {
      if (e.find(text) != std::string::npos) return true;
    }
    return false;
  }
  void expectProgrammedAgain() {
    EXPECT_EQ(machine().speedOverride, Ratio(1.0));
    EXPECT_EQ(machine().feedOverride, Ratio(1.0));
  }
  // A flight whose heading names the cause and whose last lines show the override that was in force.
  void expectFlight(const std::string& cause, const std::string& inside = "| speed ") {
    for (const std::string& text : flights_) {
      if (text.find("Cause: " + cause) == std::string::npos) continue;
      EXPECT_THAT(text, HasSubstr(inside));
      EXPECT_THAT(text, HasSubstr(" rpm, knobs "));
      return;
    }
    ADD_FAILURE() << "no flight with the cause '" << cause << "' among " << flights_.size() << "\n"
                  << (flights_.empty() ? "" : flights_.front().substr(0, 300));
  }

  // Throws while told to.
  class Breakable final : public detect::Detector {
   public:
    Breakable(std::unique_ptr<detect::Detector> inner, bool& broken) : inner_(std::move(inner)), broken_(broken) {}
    detect::DetectorInfo describe() const override { return inner_->describe(); }
    void prepare(const CutSetup& s, const config::ParamSet& p) override { inner_->prepare(s, p); }
    Verdict process(const detect::ConditionedBlock& block) override {
      if (broken_) throw std::runtime_error("broken");
      return inner_->process(block);
    }
    void reset() noexcept override { inner_->reset(); }

   private:
    std::unique_ptr<detect::Detector> inner_;
    bool& broken_;
  };
  // Asks for a speed that is no number while told to.
  class Poisoned final : public control::Strategy {
   public:
    Poisoned(std::unique_ptr<control::Strategy> inner, bool& poisoned)
        : inner_(std::move(inner)), poisoned_(poisoned) {}
    control::StrategyInfo describe() const override { return inner_->describe(); }
    void prepare(const CutSetup& s, const config::ParamSet& p) override { inner_->prepare(s, p); }
    OverrideRequest decide(const control::StrategyInput& in) override {
      OverrideRequest r = inner_->decide(in);
      if (poisoned_) r.speed = Rpm(std::numeric_limits<double>::quiet_NaN());
      return r;
    }
    void reset() noexcept override { inner_->reset(); }

   private:
    std::unique_ptr<control::Strategy> inner_;
    bool& poisoned_;
  };

  bool detectorThrows_ = false, strategyNaN_ = false;
  LoopRun run_;
  std::vector<std::string> events_, flights_;
};

TEST_F(FaultScript, TheDetectorThrows) {
  runMidRamp();
  detectorThrows_ = true;
  runFor(1.2);
  expectProgrammedAgain();
  EXPECT_TRUE(said("detector 0 failed"));
  expectFlight("detector 0 failed");
}

TEST_F(FaultScript, TheStrategyAsksForNoNumber) {
  runMidRamp();
  strategyNaN_ = true;
  runFor(1.2);
  expectProgrammedAgain();
  EXPECT_TRUE(said(sentence({ReasonCode::GateNotFinite, {}})));
  expectFlight(sentence({ReasonCode::GateNotFinite, {}}));
}

TEST_F(FaultScript, TheLinkDiesMidRamp) {
  runMidRamp();
  run_.machine().loseLink(true);
  runFor(1.2);
  expectProgrammedAgain();  // the machine's own watchdog
  EXPECT_TRUE(said("the machine has not answered"));
  expectFlight("the machine has not answered", "link-down");
  run_.machine().loseLink(false);
  runFor(0.3);
  EXPECT_TRUE(said(sentence({ReasonCode::LinkBack, {}})));
}

TEST_F(FaultScript, TheOperatorGrabsTheKnob) {
  runMidRamp();
  const double ours = run_.last().output.command.speed.value;
  run_.machine().turnKnobs(Ratio(0.9), Ratio(0.9));
  runFor(0.4);
  // His knob multiplies, ours stays where it was while he turns.
  EXPECT_TRUE(said("the operator turns the knobs: speed 90 %, feed 90 %"));
  EXPECT_NEAR(run_.last().output.command.speed.value, ours, 0.06);
  EXPECT_NEAR(machine().speedOverride.value, 0.9 * run_.last().output.command.speed.value, 0.01);
  EXPECT_EQ(run_.last().gate.reason.code, ReasonCode::GateOperatorOverrideMoved);
  run_.send({OperatorAction::BackToProgrammed});
  runFor(0.4);
  EXPECT_NEAR(machine().speedOverride.value, 0.9, 1e-9);
  expectFlight(sentence({ReasonCode::AuthorityChanged, {2.0, 0.0}}));
}

TEST_F(FaultScript, ATurnedKnobCountsOnceWhenTheCutIsQuietAgain) {
  runMidRamp();
  while (run_.last().gate.reason.code != ReasonCode::GateInForce && advance()) {
  }
  runFor(0.2);  // the machine has read it
  const double speed = machine().speedOverride.value, feed = machine().feedOverride.value;
  ASSERT_LT(feed, 0.9);
  run_.machine().turnKnobs(Ratio(1.0), Ratio(0.9));
  runFor(2.7);  // he has let go of it for a while
  EXPECT_EQ(run_.last().gate.reason.code, ReasonCode::GateInForce);
  EXPECT_NEAR(machine().speedOverride.value, speed, 0.005);
  EXPECT_NEAR(machine().feedOverride.value, 0.9 * feed, 0.005);
}

TEST_F(FaultScript, TheSpeedReadbackFreezes) {
  runMidRamp();
  run_.freezeSpeed();
  runFor(6.5);
  expectProgrammedAgain();
  EXPECT_TRUE(said("the spindle does not follow"));
  expectFlight("the spindle does not follow");
}

TEST_F(FaultScript, TheProgramLocksTheOverrides) {
  runMidRamp();
  run_.machine().enableOverrides(false);  // M49
  runFor(1.0);
  expectProgrammedAgain();
  EXPECT_TRUE(said("the overrides have no effect: locked by the program, or at the machine's limit"));
  EXPECT_FALSE(said("put the override back"));
  expectFlight("the overrides have no effect", "locked");
  run_.machine().enableOverrides(true);
  runFor(0.5);
  EXPECT_EQ(machine().speedOverride, Ratio(1.0)) << "it does not jump back to where it was";
}

// A tool change macro or a reset script, not M49: told apart, and left in force.
TEST_F(FaultScript, AScriptResetsTheOverrides) {
  runMidRamp();
  while (run_.last().gate.reason.code != ReasonCode::GateInForce && advance()) {
  }
  runFor(0.2);  // the machine has read it
  run_.machine().resetOverrides();
  runFor(2.3);
  expectProgrammedAgain();
  EXPECT_TRUE(said("the machine or its program put the override back to 100 %"));
  EXPECT_FALSE(said("locked by the program"));
  expectFlight("the machine or its program put the override back to 100 %");
}

}  // namespace
}  // namespace stillcut::test
