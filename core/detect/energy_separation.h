// Band-pass bank between the tooth-passing harmonics and energy separation in each band: Caliskan 2018 eq. 23-27.
//
// Lag D as in eq. 26-27. Corrections to the print, both by derivation for x = A cos(w t): with lag D the operator is
// Psi[x] = x_k^2 - x_{k-D} x_{k+D} = A^2 sin^2(w D T), so the arc cosine is w D T, not w; and the 1/T^2 of eq. 25 drops
// out of the frequency but would stay in the amplitude, so it is left out.
// Departure: Psi is averaged over one hop before the arc cosine (the paper takes it sample by sample), because the
// quotient of two noisy numbers is biased and the quotient of their means far less. A hop whose mean Psi is not
// positive, or whose cosine leaves -1..1 by more than rounding, keeps the last estimate, marked invalid.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <vector>

#include "core/base/units.h"
#include "core/dsp/butterworth.h"

namespace stillcut::detect {

struct BandEstimate {
  double power = 0.0;  // amplitude squared
  Hertz frequency{};
  bool valid = false;
};

class EnergySeparation {
 public:
  // bandWidth: lowest tooth-passing frequency the bank will be asked to follow, which sets the longest lag.
  void prepare(int channels, int bands, Hertz rate, Hertz lowestWidth);
  // Band m = [(m-1) width, m width], band 1 from `floor`; follows the speed without allocation.
  void tune(Hertz width, Hertz floor) noexcept;
  void reset() noexcept;
  int bands() const { return bands_; }
  int active() const { return active_; }

  // One frame, one value per channel.
  void process(const double* rest) noexcept;
  // Ends a hop: estimates from the means since the last call.
  void estimate() noexcept;

  const BandEstimate& band(int channel, int m) const { return estimates_[index(channel, m)]; }

 private:
  struct Sums {
    double signal = 0.0;      // Psi[s]
    double difference = 0.0;  // Psi[y_{k-D}] + Psi[y_{k-2D}]
  };
  std::size_t index(int channel, int m) const {
    return static_cast<std::size_t>(channel) * static_cast<std::size_t>(bands_) + static_cast<std::size_t>(m);
  }

  int channels_ = 0;
  int bands_ = 0;
  int active_ = 0;
  double rate_ = 0.0;
  double width_ = 0.0;
  std::size_t mask_ = 0;  // ring length - 1
  std::size_t head_ = 0;
  long frames_ = 0;
  std::vector<std::size_t> lag_;           // per band
  std::vector<dsp::Butterworth> filters_;  // per channel and band
  std::vector<double> ring_;               // per channel and band
  std::vector<Sums> sums_;                 // per channel and band
  std::vector<BandEstimate> estimates_;    // per channel and band
};

}  // namespace stillcut::detect
