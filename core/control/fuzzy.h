// fuzzy, fuzzy-learning, fuzzy-direct: Xu 2003, chapter 3. Spindle speed and feed go down in steps while coherence or
// vibration energy are above their references, and up again while they are below.
//
// - E gamma, C gamma, EE: eq. 3-19 .. 3-21, scaled by eq. 3-25 .. 3-27 and by B = (PI(EE) / eps)^alpha, PI of eq. 3-14
//   over the last 8 cycles
// - rules and inference: eq. 3-22 .. 3-24, figures 3.7 .. 3.9 (fuzzy_rules.h)
// - step per cycle: eq. 3-28, 3-29, range / cycles per second
// - overshoot: section 3.3.5.1, alpha^m while the energy rises three cycles running
// - limits and impact: table 3.1, above E_up the feed goes to its lowest within the cycle
// - learning, every 6 cycles: eq. 3-32, 3-33, k <- k - mean of w E gamma
// - direct tuning, single and double: eq. 3-34 .. 3-37
//
// Departures, with their reasons:
// - Eq. 3-30, 3-31 let feed and speed go faster by a gain on an impact. The feed goes to its lowest at once instead
//   (table 3.1), more than any gain gives. The speed has none: at twice the step a pocket 2 % wide is jumped within a
//   cycle, unheard, and 10 of 24 runs of xu-steel (seeds 1 to 8, three laws) ended in chatter; without it none does.
// - Section 3.3.5.1 lets KO grow as alpha^(1 + 2 + .. + m): here it is alpha^m and at most 2, for the same reason.
// - Eq. 3-25 .. 3-27 leave B free: it is kept within 0.5 .. 2, because a quiet cut's PI near 0 would switch the inputs
//   off, and an impact's would make an extreme of each. gamma_up is 1, gamma_low and E_low are 0.
// - Table 3.1's (f, v)_max below an E_min is not taken: it would jump back to what chattered. The rules lead back.
// - Eq. 3-33 prints +. Figures 3.17 and 3.18 show rules of high E gamma lowered and of low E gamma raised, each row by
//   its own: so minus, weighted by firing strength.
// - Eq. 3-36 and 3-37 multiply by delta; a negative one would turn every recovery round: its magnitude is taken, of the
//   normalised error.
// - The energy references are volts of the author's sensor. Here 1 V is the level of the stable cut, learned from its
//   first half second; until then energy says nothing.
// - Without gamma_max the severity of the detector in charge stands in: 0 .. 0.2 .. 1 onto 0 .. 0.8 .. 1, both
//   references being where the method says chatter.
// - (f, v) = 0 above the upper limit (table 3.1) is a feed hold: the spindle never stops in the cut. The gate stops the
//   feed where it may (gate.lowest-feed-override and gate.lowest-feed-per-tooth 0), and goes to the lowest feed where
//   not. A held feed makes air of the cut: it comes back by its rules to where it was held from, also then.
// - Nothing rises above `fuzzy.highest` of the programme, and for `fuzzy.rest` seconds after an alarm the speed does
//   not rise at all: the rules as printed would climb back to the speed that chattered.
// - The paper lets the whole range go in a second. A pocket 2 % wide is then passed in less time than chatter needs to
//   die: `fuzzy.range-time` is four, and a cycle in which the level has fallen by a tenth leaves the speed where it is.
// - gamma_max of averaged spectra stays high after chatter has died; while the level is far below what the averages
//   hold, coherence counts as at its reference.
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
  void retune(const config::ParamSet& params) noexcept override;
  OverrideRequest decide(const StrategyInput& input) noexcept override;
  void reset() noexcept override;
  void relinquish() noexcept override;
  bool readRules(RuleTables& into) const noexcept override;

 protected:
  // What learning and direct tuning add. Real-time.
  virtual void learn(const FuzzyInputs& /*in*/) noexcept {}
  virtual double tune(const FuzzyInputs& /*in*/) const noexcept { return 1.0; }

  FuzzyOptions options_;
  RuleTable speedRules_ = kSpeedRules;
  RuleTable feedRules_ = kFeedRules;
  std::uint32_t lessons_ = 0;

  // For readRules(). Real-time.
  void showRules() noexcept;

 private:
  static constexpr std::size_t kPast = 8;  // n_a of eq. 3-14

  double levelOf(const StrategyInput& input) noexcept;
  void gather(const StrategyInput& input) noexcept;
  bool ofThePast(const StrategyInput& input, double level, double dt) noexcept;
  void learnStable(const Verdict& verdict, double level, double dt) noexcept;
  void cycle(const StrategyInput& input) noexcept;
  Reason said(const StrategyInput& input, double coherence, double energy) const noexcept;
  FuzzyInputs scaled(double coherence, double energy) noexcept;
  double overshoot(double energy) noexcept;
  void feedAgain(const FuzzyInputs& in, const MachineState& machine) noexcept;
  void moveBy(double speed, double feed, double step, const MachineState& machine) noexcept;
  OverrideRequest answer(const StrategyInput& input) const noexcept;

  config::OverrideLimits limits_;
  Rpm programmed_{};
  double speed_ = 1.0, feed_ = 1.0;  // factors on programme and knob
  double heldFrom_ = 0.0;            // the feed that was held from; 0: none is held
  bool moved_ = false;

  double elapsed_ = 0.0, levelSum_ = 0.0, coherenceMax_ = 0.0, counted_ = 0.0;  // of the cycle in hand
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
  void reset() noexcept override;

 private:
  void learn(const FuzzyInputs& in) noexcept override;

  RuleTable correction_{};
  int cycles_ = 0;
};

class FuzzyDirect final : public Fuzzy {
 public:
  StrategyInfo describe() const override;

 private:
  double tune(const FuzzyInputs& in) const noexcept override;
};

}  // namespace stillcut::control
