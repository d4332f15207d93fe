// fuzzy, fuzzy-learning, fuzzy-direct: Xu 2003, chapter 3. Spindle speed and feed go down in steps while coherence or
// vibration energy are above their references, and up again while they are below.
// Equations and departures: resources/manual/developers/laws.md#fuzzy. Thread: as Strategy.
#pragma once

#include <array>
#include <atomic>

#include "core/config/override_limits.h"
#include "core/control/fuzzy_params.h"
#include "core/control/fuzzy_rules.h"
#include "core/control/strategy.h"

namespace stillcut::control {

class Fuzzy : public Strategy {
 public:
  StrategyInfo describe() const override;
  // Throws std::runtime_error where the override limits contradict each other, or the rules or references themselves.
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  void retune(const config::ParamSet& params) override;
  OverrideRequest decide(const StrategyInput& input) override;
  void reset() override;
  void relinquish() override;
  bool readRules(RuleTables& into) const override;

 protected:
  // What learning and direct tuning add. Real-time.
  virtual void learn(const FuzzyInputs& /*in*/) {}
  virtual double tune(const FuzzyInputs& /*in*/) const { return 1.0; }

  FuzzyOptions options_;
  RuleTable speedRules_ = kSpeedRules;
  RuleTable feedRules_ = kFeedRules;
  std::uint32_t lessons_ = 0;

  // For readRules(). Real-time.
  void showRules();

 private:
  static constexpr std::size_t kPast = 8;  // n_a of eq. 3-14

  double levelOf(const StrategyInput& input);
  void gather(const StrategyInput& input);
  bool ofThePast(const StrategyInput& input, double level, double dt);
  void learnStable(const Verdict& verdict, double level, double dt);
  void cycle(const StrategyInput& input);
  Reason said(const StrategyInput& input, double coherence, double energy) const;
  FuzzyInputs scaled(double coherence, double energy);
  double overshoot(double energy);
  void feedAgain(const FuzzyInputs& in, const MachineState& machine);
  void moveBy(double speed, double feed, double step, const MachineState& machine);
  OverrideRequest answer(const StrategyInput& input) const;

  config::OverrideLimits limits_;
  Rpm programmed_{};
  double speed_ = 1.0, feed_ = 1.0;  // factors on programme and knob
  double heldFrom_ = 0.0;            // the feed that was held from; 0: none is held
  bool moved_ = false;

  double elapsed_ = 0.0, levelSum_ = 0.0, coherenceMax_ = 0.0, counted_ = 0.0;  // of the present cycle
  bool coherenceKnown_ = false;
  double stable_ = 0.0, stableSum_ = 0.0, stableTime_ = 0.0, stableBefore_ = 0.0;  // level of the stable cut
  double remembered_ = 0.0;                                                        // squared level that spectra hold
  bool hearsEnergy_ = false;
  double sinceAlarm_ = 1e9;
  double lastCoherence_ = 0.0;
  std::array<double, kPast> errors_{};  // EE of the last cycles
  std::size_t past_ = 0;
  double energy1_ = 0.0, energy2_ = 0.0;  // one and two cycles ago
  int rising_ = 0;
  Reason reason_;
  static constexpr std::size_t kCells = std::size_t{kCoherenceSets} * kCoherenceSets;
  std::array<std::atomic<float>, 2 * kCells> shownRules_{};  // speed, then feed
  std::atomic<std::uint32_t> shownLessons_{0};
  std::atomic<bool> shownRefused_{false};
};

class FuzzyLearning final : public Fuzzy {
 public:
  StrategyInfo describe() const override;
  void reset() override;

 private:
  void learn(const FuzzyInputs& in) override;

  RuleTable correction_{};
  int cycles_ = 0;
};

class FuzzyDirect final : public Fuzzy {
 public:
  StrategyInfo describe() const override;

 private:
  double tune(const FuzzyInputs& in) const override;
};

}  // namespace stillcut::control
