// Finds a spindle frequency that nobody told, or that has moved far from what was told, on the spectrum of a window.
//
// The fundamental is the largest frequency whose comb holds nearly all of the power that any comb holds, above what a
// comb would hold by chance. Candidates are the strongest lines divided by small whole numbers, so that a range of two
// decades costs no more than a few hundred combs. A fundamental may be the spindle's or the tooth passing's: where the
// teeth are known, weak lines of runout in between tell them apart, or else a first line that outweighs all others.
// Where that is wrong, the comb is the right one all the same: every forced line lies on it.
// Thread: worker; real-time after prepare().
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/units.h"

namespace stillcut::detect {

struct FoundSpeed {
  Hertz spindle{};         // 0: nothing found
  double part = 0.0;       // of the power on its comb, above chance, 0..1
  double toothPart = 0.0;  // of the power on multiples of the teeth (0: teeth unknown)
  // Of the power on multiples of the teeth, the least that stands between every second, third or fifth of them: 0 where
  // only those are there, as of a spindle that turns so much faster.
  double everyPassing = 1.0;
};

class SpeedFinder {
 public:
  void prepare(int bins, Hertz binWidth, int lobe, int teeth);
  // power: of every bin, up to the last usable one; spindle speeds in low..high are looked for.
  FoundSpeed find(std::span<const double> power, Hertz low, Hertz high) noexcept;

 private:
  static constexpr int kPeaks = 10;
  static constexpr int kMostOrder = 40;

  void collectPeaks() noexcept;
  double lineAt(double frequency) const noexcept;
  double combPart(double fundamental, int every) const noexcept;
  double standsOut(double frequency) const noexcept;
  double everyPassing(double spindle) const noexcept;
  double refined(double fundamental) const noexcept;
  double fundamental(double low, double high, double* part) const noexcept;
  int divisor(double fundamental) const noexcept;

  double binWidth_ = 0.0;
  int lobe_ = 4;
  int teeth_ = 0;
  std::vector<double> sums_;  // running sum of the power
  std::span<const double> power_;
  double total_ = 0.0;
  int peaks_ = 0;
  struct Peak {
    double frequency = 0.0;
    double power = 0.0;
  };
  std::array<Peak, kPeaks> found_{};
};

}  // namespace stillcut::detect
