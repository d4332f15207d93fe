// extremum-paper and extremum-seek: van Dijk 2010, section 4.2.
//   Omega_new = Omega_0 (1 + theta_c)                                                                        (eq. 31)
//   theta_c(k+1) = theta_c(k) + 2 mu_c sqrt(H) / gamma * sign(Delta f) * unit                                (eq. 32)
//   gamma(k) = (1 - lambda_c) gamma(k-1) + lambda_c sqrt(H)                                                  (eq. 33)
// with Delta f = f_c - p f_tp. Three departures from print, each tested: eq. 32's minus sign drives the speed away from
// the lobe's centre (in the paper's own example Delta f < 0 and the speed must fall), so it is a plus; eq. 33 averages
// H where the text says sqrt(H), which alone makes the step a pure number; and the step is in percent of Omega_0 per
// control period (`unit`), because a full step per sample would leave the override's range at once.
//
// sign(Delta f) alone settles where Delta f = 0 and not where H is least (figure 7: 33 000 against 33 600 rpm).
// extremum-paper stops where chatter stops, at Delta f = 0 at the latest. extremum-seek goes on once the cut is quiet:
// first to where the law would settle for the last frequency heard, because the edge of the pocket is no place to stay
// (the speed that Delta f = 0 asks for changes with the frequency; near its end the law's own steps are slow). From
// there it compares the vibration at neighbouring speeds, brackets the least, and ends at the vertex of the parabola
// through the bracket; a speed at which chatter returns is left again and bounds the search, as does every other that
// has chattered, and nothing is judged in air. A fixed number of trials: it does not hunt. The vibration itself, where
// it is known, as figure 12 compares it: H of a quiet cut is that of its noise (11 to 90 within a second at one speed
// of the simulated ramp) and has its least where no chatter would come first, not where the cut is quietest.
// Thread: as Strategy.
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
  void retune(const config::ParamSet& params) noexcept override;

 private:
  Aim aim(const RuleView& view) noexcept override;
  Aim whenQuiet(const RuleView& view) noexcept override;
  void forget() noexcept override;
  config::SpeedRange quietReach(const RuleView& view) const noexcept;
  bool searchGoesOn(const RuleView& view) noexcept;
  Aim law(const RuleView& view) noexcept;
  Aim searching(const RuleView& view) const noexcept;

  bool seek_;
  double mu_ = 0.7;
  double lambda_ = 0.3;
  double unit_ = 0.01;
  Seconds period_{};
  MinimumSearch search_;

  bool alarmed_ = false;
  static constexpr std::size_t kHeard = 8;
  std::array<Rpm, kHeard> heard_{};  // where alarms have begun, newest over oldest; 0: none
  std::size_t alarms_ = 0;
  double alarmedFor_ = 0.0;  // [s] since the search was last told of chatter
  int searches_ = 0;
  bool started_ = false;  // the law has run in this episode
  Rpm settles_{};         // where Delta f = 0 for the last frequency heard
  Rpm quietAt_{};         // where the cut became quiet, while the search has not left settles_; 0: no such place
  double theta_ = 0.0;
  double gamma_ = 0.0;
  double sincePeriod_ = 0.0;
  Reason reason_;
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
