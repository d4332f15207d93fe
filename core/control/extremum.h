// extremum-paper and extremum-seek: van Dijk 2010, section 4.2: steps toward the speed of least perturbation by the
// sign of f_c - p f_tp; the second goes on to the least vibration once the cut is quiet.
// Equations and departures: resources/manual/developers/laws.md#extremum. Thread: as Strategy.
#pragma once

#include <array>
#include <cstddef>

#include "core/control/frequency_rule.h"
#include "core/control/minimum_search.h"

namespace stillcut::control {

config::ParamTable extremumParams();

class Extremum : public FrequencyRule {
 public:
  explicit Extremum(bool seek) : seek_(seek) {}
  StrategyInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  void retune(const config::ParamSet& params) override;

 private:
  Aim aim(const RuleView& view) override;
  Aim whenQuiet(const RuleView& view) override;
  void forget() override;
  config::SpeedRange quietReach(const RuleView& view) const;
  static double compared(const RuleView& view);
  bool searchGoesOn(const RuleView& view);
  Aim law(const RuleView& view);
  Aim searching(const RuleView& view) const;

  bool seek_;
  double mu_ = 0.7;
  double lambda_ = 0.3;
  double unit_ = 0.01;
  Seconds period_{};
  double seekStep_ = 0.01;
  MinimumSearch search_;

  bool alarmed_ = false;
  static constexpr std::size_t kHeard = 8;
  std::array<Rpm, kHeard> heard_{};  // where alarms have begun, newest over oldest; 0: none
  std::size_t alarms_ = 0;
  double alarmedFor_ = 0.0;  // [s] since the search was last informed of chatter
  int searches_ = 0;
  bool started_ = false;  // the law has run in this episode
  Rpm settles_{};         // where Delta f = 0 for the last frequency measured
  Rpm settledFrom_{};     // and where that was measured
  Rpm quietAt_{};         // where the cut became quiet, while the search has not left settles_; 0: no such place
  double theta_ = 0.0;
  double gamma_ = 0.0;
  double sincePeriod_ = 0.0;
};

class ExtremumPaper final : public Extremum {
 public:
  ExtremumPaper() : Extremum(false) {}
};
class ExtremumSeek final : public Extremum {
 public:
  ExtremumSeek() : Extremum(true) {}
};

}  // namespace stillcut::control
