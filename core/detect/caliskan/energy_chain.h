// The numeric chain of the energy-ratio detector: residual of the rotating Kalman filter, band-pass bank, energy
// separation, energy ratio (Caliskan 2018 eq. 16-29). Nothing is judged here.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <complex>
#include <span>
#include <vector>

#include "core/detect/caliskan/energy_separation.h"
#include "core/detect/caliskan/full_harmonic_kalman.h"
#include "core/detect/turning_harmonics.h"

namespace stillcut::detect {

class EnergyChain {
 public:
  static constexpr double kUsableBand = 0.45;  // of the rate: harmonics above are left alone

  // lowestSpindle: the slowest the chain will be asked to follow. bandOrders: spindle orders to a band (the teeth).
  struct Size {
    int channels = 1;
    int harmonics = 1;
    int bands = 1;
    int bandOrders = 1;
    Hertz rate{};
    Hertz lowestSpindle{};
    bool fullCovariance = false;  // eq. 20 as it stands, instead of its settled gain
  };
  // kernels: see core/dsp/kernels/choose.h.
  void prepare(const Size& size, const dsp::kernels::Kernels& kernels);
  void reset();

  // Follows the speed; gain: of the harmonic filter (turning_harmonics.h).
  void tune(Hertz spindle, double gain);
  // Spindle angle of the next frame and turn per frame [rad].
  void align(double angle, double step);
  // Any number of frames at that turn; x[channel * stride + frame].
  void process(const double* x, std::ptrdiff_t stride, std::size_t frames);
  // Ends a hop: the estimates are the means since the last call.
  void endHop();

  // Harmonics below the end of the usable band at this speed.
  int active() const { return size_.fullCovariance ? full_.active() : harmonics_.active(); }
  // ER of eq. 28, 29 for the last hop; eta: 1 displacement, 0 velocity, sound, speed and current, -1 acceleration.
  double ratio(int channel, int eta) const;
  // Of what the harmonics left in the last hop: the part in the band that holds f. Not weighted as in ratio(): what of
  // a line passes the skirts of the lowest band is far above that band, and its estimated frequency is folded down
  // there, so that the weights of an acceleration make more of it than of the line itself.
  double bandPart(int channel, Hertz f) const;
  // Amplitude squared of every active harmonic of a channel at the last hop's end, that of harmonic n at n - 1.
  std::span<const double> harmonicPowers(int channel) const {
    return std::span(powers_).subspan(static_cast<std::size_t>(channel) * row_, static_cast<std::size_t>(active()));
  }
  // n^(2 eta) of every harmonic, and the sum of those times the powers.
  std::span<const double> orderWeights(int eta) const { return weights_[static_cast<std::size_t>(eta + 1)]; }
  double forced(int channel, int eta) const;
  // Complex amplitudes against the spindle's angle of the first harmonics, as many as `out` takes.
  void amplitudes(int channel, std::span<std::complex<double>> out) const;
  // What the harmonics left of one channel in the frames of the last process(), as far as they fit in one stretch.
  const double* rest(int channel) const { return rest_.data() + channel * kMost; }
  const EnergySeparation& bands() const { return bands_; }

 private:
  static constexpr std::ptrdiff_t kMost = EnergySeparation::kMostFrames;

  Size size_;
  Hertz spindle_{};
  RotatingHarmonicFilter harmonics_;  // one of the two is prepared
  FullHarmonicKalman full_;
  EnergySeparation bands_;
  std::array<std::vector<double>, 3> weights_;  // (n f)^(2 eta) / f^(2 eta), by eta + 1
  std::vector<double> rest_;                    // [channel * kMost + frame]
  std::size_t row_ = 0;                         // harmonics in whole lanes
  std::vector<double> powers_;                  // [channel * row + n - 1]
};

}  // namespace stillcut::detect
