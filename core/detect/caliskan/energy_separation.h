// Band-pass bank between the tooth-passing harmonics and energy separation in each band: Caliskan 2018 eq. 23-27.
//
// Lag D as in eq. 26-27. Corrections to the print, both by derivation for x = A cos(w t): with lag D the operator is
// Psi[x] = x_k^2 - x_{k-D} x_{k+D} = A^2 sin^2(w D T), so the arc cosine is w D T, not w; and the 1/T^2 of eq. 25 drops
// out of the frequency but would stay in the amplitude, so it is left out.
// Departure: Psi is averaged over one hop before the arc cosine (the paper takes it sample by sample), because the
// quotient of two noisy numbers is biased and the quotient of their means far less. A hop whose mean Psi is not
// positive, or whose cosine leaves -1..1 by more than rounding, keeps the last estimate, marked invalid.
// The filters run in lanes of bands, the operator in lanes of time; filters and lags are shared by all channels.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <vector>

#include "core/base/units.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

struct BandEstimate {
  double power = 0.0;  // amplitude squared
  Hertz frequency{};
  bool valid = false;
};

class EnergySeparation {
 public:
  static constexpr std::size_t kMostFrames = 256;  // of one process()

  // bandWidth: lowest tooth-passing frequency the bank will be asked to follow, which sets the longest lag.
  void prepare(int channels, int bands, Hertz rate, Hertz lowestWidth, const dsp::kernels::Kernels& kernels);
  // Band m = [(m-1) B, m B] orders, B = bandOrders, the first from half an order on and none beyond topOrders: the last
  // has what there is of it, if that is a quarter. Follows the speed without allocation.
  void tune(Hertz spindle, int bandOrders, int topOrders);
  void reset();
  int bands() const { return bands_; }
  int active() const { return active_; }

  // Frames that fit before advance() must be called.
  std::size_t room() const { return kMostFrames - pending_; }
  // At most room() frames of one channel.
  void process(int channel, const double* rest, std::size_t frames);
  // After every channel has had the same frames.
  void advance(std::size_t frames);
  // Ends a hop: estimates from the means since the last call. Sums that are not finite start their channel anew.
  void estimate();

  BandEstimate band(int channel, int m) const;
  // Sum over the bands of power times frequency^(2 eta).
  double weightedPower(int channel, int eta) const;

 private:
  struct History {  // of one band, of every channel
    std::size_t offset = 0;
    std::size_t before = 0;  // frames kept for the lags
    std::size_t lag = 1;
  };
  struct BandChannel {
    std::vector<double> state, sums, power, frequency, valid;
    std::vector<double> signal;   // of every band, by History
    std::vector<double*> newest;  // where the next frames go
  };
  void accumulate();
  void compact();
  void point(BandChannel& c);
  void clear(BandChannel& c);

  dsp::kernels::Kernels kernels_;
  int bands_ = 0;
  int active_ = 0;
  std::size_t lanes_ = 0;  // bands in whole lanes
  std::size_t used_ = 0;   // active ones in whole lanes
  double rate_ = 0.0;
  double width_ = 0.0;
  int top_ = 0;               // orders
  std::size_t capacity_ = 0;  // frames after the history
  std::size_t position_ = 0;  // of the next frame
  std::size_t pending_ = 0;   // frames not yet in the sums
  std::size_t frames_ = 0;    // of this hop, in the sums
  std::vector<History> histories_;
  std::vector<double> coefficients_, low_, high_, scale_;
  std::vector<BandChannel> channels_;
};

}  // namespace stillcut::detect
