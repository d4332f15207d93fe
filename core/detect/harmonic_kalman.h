// Kalman filter that follows the spindle harmonics and leaves the rest: Caliskan 2018 eq. 16-22.
//
// The paper's 2N states rotate (Phi, eq. 19); here they are kept in the frame that turns with the spindle angle
// (q = a e^{j n theta}), which is the same filter and needs no small-angle state: the phasors are shared by all
// channels. Its covariance does not depend on the data (eq. 20) and settles to P = p I between sparse harmonics, with
// p^2 / (2 (N p + R)) = lambda R per step, hence one gain g = p / (N p + R) for every harmonic and channel. Departure
// from the paper: g is used from the start instead of the settling P (which only shortens the first turns). The plain
// O(N^2) recursion is the oracle in the tests.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <span>
#include <vector>

namespace stillcut::detect {

// Converged gain for a ratio lambda = Q/R and N harmonics, and back.
double harmonicGain(double lambda, int harmonics) noexcept;
double lambdaForGain(double gain, int harmonics) noexcept;

class HarmonicKalman {
 public:
  void prepare(int channels, int harmonics);
  void reset() noexcept;
  int harmonics() const { return harmonics_; }
  // Uses only the first `count` (those below the usable band at the present speed).
  void setActive(int count) noexcept;
  int active() const { return active_; }
  void setGain(double gain) noexcept { gain_ = gain; }

  // Sets the phasors to the spindle angle of the next frame and the turn per frame [rad].
  void align(double angle, double step) noexcept;
  // Predicts each channel, corrects its harmonics, writes the innovation-free rest; then turns the phasors.
  // x and rest: one value per channel.
  void process(const double* x, double* rest) noexcept;

  // Amplitude squared of harmonic n (1-based) of a channel (eq. 29).
  double power(int channel, int n) const noexcept;

 private:
  static constexpr int kLanes = 4;  // partial sums, so that the compiler may use vectors without reordering

  int channels_ = 0;
  int harmonics_ = 0;
  int active_ = 0;
  std::size_t padded_ = 0;
  std::size_t used_ = 0;
  double gain_ = 0.0;
  std::vector<double> zr_, zi_, wr_, wi_;  // phasors e^{j n theta} and their turn per frame
  std::vector<double> ar_, ai_;            // states, [channel * padded + n]
};

}  // namespace stillcut::detect
