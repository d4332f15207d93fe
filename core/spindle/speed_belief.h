// SpeedBelief: the probability of every spindle speed near the told one, as looks at the cut come in: a grid filter
// over the ratio of true to told speed.
//
//   log p_t(r) = max over d of [log p_{t-1}(r + d) - d^2 / (2 wander^2)] (1 - forget) + forget log p_0(r) + a
//   score_t(r)
//
// Looks on end that fit another speed better by far say that the spindle turns otherwise now: what was heard before is
// forgotten.
//
// p_0: half a Gaussian of a controlled spindle's doubt, half one of the doubt of what was told. a: looks overlap and
// repeat each other's chance, so that a second of them counts as one (two_series.h gives the score). A speed that is
// told anew keeps the ratio. Thread: worker; everything but prepare() is real-time.
#pragma once

#include <vector>

#include "core/base/units.h"
#include "core/spindle/two_series.h"

namespace stillcut::detect {

class SpeedBelief {
 public:
  // range: how far the true speed may be from the told one at most, as a ratio; sd: the doubt of what was told.
  void prepare(double range);
  void begin(double sd) noexcept;  // as nothing had been heard
  // A look, `since` the one before; told: now.
  void look(const TwoSeries& lines, Hertz told, Seconds since) noexcept;

  // Of true to told speed: the most likely one, and the spread of the likely ones around it. Not a speed before the
  // first look.
  double ratio() const noexcept { return ratio_; }
  double sd() const noexcept { return sd_; }
  // Probability that the speed is the most likely one, to 0.15 %.
  double certainty() const noexcept { return certainty_; }
  // The ratio that the newest look alone says, where it fits that better by far: where the spindle has just changed its
  // speed, all before is of another.
  double ofNewest() const noexcept { return newest_; }
  // ... was likely before it: the looks are of two minds, and no spindle moved.
  bool newestWasLikely() const noexcept { return newestWasLikely_; }
  // It may be further away than was looked.
  bool atEdge() const noexcept { return atEdge_; }
  // The speeds that may be: cells 0 .. cells() - 1 of the ratio.
  std::size_t cells() const noexcept { return log_.size(); }
  double ratioAt(std::size_t cell) const noexcept;
  bool plausible(std::size_t cell) const noexcept;
  double likelihood(std::size_t cell) const noexcept;  // over that of the most likely one
  bool certain() const noexcept { return heard_ && certainty_ > kCertain; }

 private:
  static constexpr double kCertain = 0.95;
  double prior(double ratio) const noexcept;
  void drift() noexcept;
  bool fitsBetter(std::size_t cell, std::size_t than) const noexcept;
  void surprise(double counts) noexcept;
  void chooseNewest(double before) noexcept;
  void judge() noexcept;

  double range_ = 0.03;
  double priorSd_ = 0.01;
  bool heard_ = false;
  double ratio_ = 1.0, sd_ = 0.01, certainty_ = 0.0;
  double newest_ = 1.0;
  bool newestWasLikely_ = false;
  bool atEdge_ = false;
  int surprised_ = 0;                        // looks on end
  std::vector<double> log_, moved_, score_;  // nepers, by cell; score_: of the newest look
};

}  // namespace stillcut::detect
