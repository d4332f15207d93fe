// Every request of every strategy explains itself in one sentence with the numbers that it was made of, whatever the
// cut does: nothing heard, chatter, quiet again, chatter that no reachable speed ends, unusable inputs, unknown teeth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>
#include <string>

#include "core/control/registry.h"
#include "core/model/reason.h"

namespace stillcut::control {
namespace {

constexpr double kDt = 0.01;

class Reasons : public ::testing::TestWithParam<std::string_view> {
 protected:
  void prepare(int teeth) {
    strategy_ = std::move(makeStrategy(GetParam())).value();
    CutSetup setup;
    setup.teeth = teeth;
    strategy_->prepare(setup, {});
    in_ = {};
    in_.dt = Seconds(kDt);
    in_.machine.valid = true;
    in_.machine.programmedSpeed = in_.machine.actualSpeed = Rpm(8500.0);
    in_.machine.programmedFeed = in_.machine.actualFeed = fromMmPerMin(2000.0);
    in_.verdict.valid = true;
    in_.verdict.phase = CutPhase::Steady;
    quiet();
  }

  void quiet() { update(CutState::Stable, 0.0, 0.02, 1.0); }
  void chatter(double hertz) { update(CutState::Chatter, hertz, 0.63, 4.0); }

  void run(double seconds) {
    for (double t = 0.0; t < seconds; t += kDt) {
      in_.now += toDuration(in_.dt);
      const OverrideRequest r = strategy_->decide(in_);
      check(r);
      if (r.kind == RequestKind::Set) in_.machine.actualSpeed += 0.2 * (r.speed - in_.machine.actualSpeed);
      if (r.kind == RequestKind::Release) in_.machine.actualSpeed = in_.machine.programmedSpeed;
      last_ = r;
    }
  }

  static std::string rpm(Rpm speed) {
    char words[32];
    std::snprintf(words, sizeof words, "%.0f rpm", speed.value);
    return words;
  }

  // A number in the words, and no number that is none; the speed that is asked for, to the revolution.
  void check(const OverrideRequest& r) {
    const std::string words = sentence(r.reason);
    if (!said_.insert(words).second) return;
    EXPECT_TRUE(std::any_of(words.begin(), words.end(), [](unsigned char c) { return std::isdigit(c); }))
        << "'" << words << "'";
    EXPECT_TRUE(std::all_of(r.reason.n.begin(), r.reason.n.end(), [](double n) { return std::isfinite(n); })) << words;
    EXPECT_EQ(words.find('\n'), std::string::npos);
    if (r.kind != RequestKind::Set || r.reason.code == ReasonCode::TargetOutOfRange) return;
    EXPECT_NE(words.find(rpm(r.speed)), std::string::npos) << words << " for " << r.speed.value;
  }

  bool told(const std::string& part) const {
    return std::any_of(said_.begin(), said_.end(),
                       [&](const std::string& words) { return words.find(part) != std::string::npos; });
  }

  bool watches() const { return GetParam() == "monitor"; }
  bool fuzzy() const { return GetParam().substr(0, 5) == "fuzzy"; }

  StrategyInput in_;
  OverrideRequest last_;
  std::unique_ptr<Strategy> strategy_;
  std::set<std::string> said_;

 private:
  void update(CutState state, double hertz, double severity, double vibration) {
    in_.verdict.state = state;
    in_.verdict.frequency = Hertz(hertz);
    in_.verdict.severity = Ratio(severity);
    in_.vibration = in_.perturbation = vibration;
  }
};

TEST_P(Reasons, NameTheSpeedAndWhatWasHeardThroughAWholeCut) {
  prepare(4);
  run(2.0);
  EXPECT_TRUE(told("8500 rpm"));
  EXPECT_TRUE(told("0.02")) << "the energy ratio that asks for nothing";
  chatter(937.0);
  run(0.5);
  EXPECT_TRUE(watches() || fuzzy() || told(" Hz"));
  run(5.0);
  quiet();
  run(12.0);
  EXPECT_TRUE(watches() || told(rpm(last_.speed)));
  chatter(1310.0);
  run(10.0);
}

TEST_P(Reasons, NameTheSpeedThatStaysWhereNothingCanBeActedOn) {
  prepare(4);
  if (watches()) return run(0.1);
  run(1.0);
  in_.verdict.valid = false;
  run(0.1);
  EXPECT_TRUE(told("8500 rpm")) << "nothing asked for yet";
  in_.verdict.valid = true;
  chatter(937.0);
  run(6.0);
  ASSERT_EQ(last_.kind, RequestKind::Set);
  const std::string asked = rpm(last_.speed);
  in_.machine.valid = false;
  in_.machine.actualSpeed = Rpm(std::nan(""));
  run(0.1);
  EXPECT_EQ(last_.kind, RequestKind::Hold);
  EXPECT_NE(sentence(last_.reason).find(asked), std::string::npos) << sentence(last_.reason);
}

TEST_P(Reasons, NameTheChatterWhereThePocketIsOutOfReach) {
  prepare(1);
  chatter(200.0);  // one tooth: the nearest pocket lies at 12 000 rpm, above what the override reaches
  run(10.0);
  if (watches() || fuzzy()) return;  // they know no pockets
  EXPECT_TRUE(told("200 Hz")) << sentence(last_.reason);
}

TEST_P(Reasons, NameTheChatterWhereTheTeethAreNotKnown) {
  prepare(0);
  run(1.0);
  chatter(937.0);
  run(3.0);
  if (watches() || fuzzy()) return;  // they do not count teeth
  EXPECT_TRUE(told("937 Hz")) << sentence(last_.reason);
  EXPECT_TRUE(told("flutes"));
}

INSTANTIATE_TEST_SUITE_P(All, Reasons, ::testing::ValuesIn([] {
                           std::vector<std::string_view> ids;
                           for (const StrategyEntry& entry : strategyTable()) ids.push_back(entry.id);
                           return ids;
                         }()),
                         [](const auto& test) {
                           std::string name(test.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace stillcut::control
