// extremum-paper and extremum-seek: van Dijk 2010, section 4.2.
//   Omega_new = Omega_0 (1 + theta_c)                                                                        (eq. 31)
//   theta_c(k+1) = theta_c(k) + 2 mu_c sqrt(H) / gamma * sign(Delta f) * unit                                (eq. 32)
//   gamma(k) = (1 - lambda_c) gamma(k-1) + lambda_c sqrt(H)                                                  (eq. 33)
// with Delta f = f_c - p f_tp. Departures, with their reasons, each tested:
// - Eq. 32's minus sign drives the speed away from the lobe's centre (in the paper's own example Delta f < 0 and the
//   speed must fall), so it is a plus.
// - Eq. 33 averages H where the text says sqrt(H), which alone makes the step a pure number.
// - The step is in percent of Omega_0 per control period (`unit`): a full step per sample would leave the override's
//   range at once. No step follows before the machine has shown the one before (section 4.3 leaves that to mu_c).
// - theta_c(0) is where the spindle is when chatter begins: 0, but for moves of before.
// - Nearer to Delta f = 0 than 0.1 % of f_c its sign is noise, and the speed stays; so it does while nothing is marked.
//
// sign(Delta f) alone settles where Delta f = 0 and not where H is least (figure 7: 33 000 against 33 600 rpm).
// extremum-paper stops where the mark stops, at Delta f = 0 at the latest: where the speed then passed puts the chatter
// onto a harmonic of the spindle, which no detector of one turn tells from the cut, it rests in chatter (demo.toml with
// 20 ms of delay: 7922 rev/min, 7th harmonic). By the truth it ends stable for every delay from 0 to 120 ms.
// extremum-seek goes on once the cut is quiet: first to where the law would settle for the last frequency heard,
// because the edge of the pocket is no place to stay (the speed that Delta f = 0 asks for changes with the frequency;
// near its end the law's own steps are slow). From there it compares the vibration at neighbouring speeds, brackets the
// least, and ends at the vertex of the parabola through the bracket; a speed at which chatter returns is left again and
// bounds the search, as does every other that has chattered, and nothing is judged in air. Past Delta f = 0, seen from
// where chatter was heard, it tries one speed only: the paper's least vibration lies on the hither side, and beyond
// begins the next lobe, which nobody has heard yet. On the ramp the vibration falls right up to that lobe's edge:
// searched without this bound, 7 of 10 seeds met its chatter and ended louder (0.08 to 0.25 of the cut left alone) than
// lobe-center (0.043). A fixed number of trials: it does not hunt. The vibration itself, where it is known, as figure
// 12 compares it: H of a quiet cut is that of its noise (11 to 90 within a second at one speed of the simulated ramp)
// and has its least where no chatter would come first, not where the cut is quietest. Thread: as Strategy.
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
  static double compared(const RuleView& view) noexcept;
  bool searchGoesOn(const RuleView& view) noexcept;
  Aim law(const RuleView& view) noexcept;
  Aim searching(const RuleView& view) const noexcept;

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
  double alarmedFor_ = 0.0;  // [s] since the search was last told of chatter
  int searches_ = 0;
  bool started_ = false;  // the law has run in this episode
  Rpm settles_{};         // where Delta f = 0 for the last frequency heard
  Rpm settledFrom_{};     // and where that was heard
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
