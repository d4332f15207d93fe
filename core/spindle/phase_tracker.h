// Keeps the spindle angle on the forced vibration: each turn the phases of the tooth-passing harmonics are compared
// with their own slow mean, and one angle error common to all of them is fed to a Kalman filter of three states (angle,
// speed, drift of the speed). A harmonic counts by the inverse of its own recent scatter, so chatter, which scatters
// them, takes the weight away by itself and the speed coasts: tracking is held exactly when it must be (methods.md
// section 4). When all phases turn together, and further than a spindle wanders, the machine changes its speed, and the
// filter follows. A line beside the harmonics leaks into all of them, turning each by the same, and where it is much
// louder than they are would pull the angle along until it lies on an order itself: there nothing is measured and
// nothing is learned. Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <complex>

#include "core/base/units.h"
#include "core/dsp/kernels/kernels.h"
#include "core/spindle/drift_watch.h"

namespace stillcut::detect {

class PhaseTracker {
 public:
  static constexpr int kOrders = 8;
  static constexpr int kChannels = 2;

  // Orders 1..8 times the teeth (1..8 when the teeth are unknown), as far as the rate allows.
  void prepare(int channels, Hertz rate, int teeth);
  // Is a drift to be looked for? Not where a machine tells how the speed changes.
  void mayDrift(bool may) noexcept;
  // Starts anew at a speed known to `sd`; drift: relative, per second, that it is known to have.
  void start(Hertz spindle, Hertz sd, double drift = 0.0) noexcept;
  // The cut changed and the speed did not: the references follow.
  void stay() noexcept {
    retained_ = 1.0;
    gone_ = false;
    scattered_ = kStays;
  }
  // The machine changed its speed: the references stay, the doubt grows.
  void nudge(Hertz spindle) noexcept;

  // Frames from `first` on of the first channels, the spindle at `angle` and turning by `step` [rad] from one to the
  // next.
  void accumulate(double angle, double step, const double* const* samples, int first, int frames) noexcept;
  // A turn is complete: returns the angle [rad] by which the spindle runs ahead of us, to be caught up.
  double completeTurn() noexcept;

  Hertz spindle() const noexcept { return Hertz(omega_ / kTwoPi); }
  // Relative change of the speed per second; 0 unless it is shown.
  double drift() const noexcept { return omega_ > 0.0 ? alpha_ / omega_ : 0.0; }
  Hertz sd() const noexcept;
  // Part of the tracked amplitude that does not repeat from turn to turn (0: purely forced).
  double scatter() const noexcept { return scatter_; }
  // Followed with little scatter, once, since the start; a comb that is not the spindle's never is.
  bool clean() const noexcept { return clean_; }
  int turns() const noexcept { return turns_; }
  // Next to nothing has repeated for many turns on end.
  bool scattered() const noexcept;
  // The forced vibration that was followed is no longer where it was.
  bool lost() const noexcept;

 private:
  static constexpr int kStays = -48;  // turns for which it is not asked again
  struct Angle {
    double delta = 0.0;     // rad
    double variance = 0.0;  // 0: nothing to measure
  };
  struct CommonTurn {
    Angle angle;
    double left = 1.0;  // part of the tracked power that it does not explain
  };
  static_assert(kOrders % dsp::kernels::kLanes == 0 && kChannels == 2);
  struct Row {
    std::array<double, kOrders> re{};
    std::array<double, kOrders> im{};
  };
  // e^{-j order angle} of the tracked orders.
  void fill(Row& row, double angle) const noexcept;
  Angle measure() const noexcept;
  CommonTurn commonTurn() const noexcept;
  Angle manoeuvred(Angle angle, double seconds) noexcept;
  void predict(double seconds) noexcept;
  double correct(Angle error) noexcept;
  double wander() const noexcept;
  void forgetDrift() noexcept;
  void watchDrift(double seconds, double angle) noexcept;
  void learn(double delta) noexcept;
  bool drowned() noexcept;

  int channels_ = 1;
  int orders_ = kOrders;
  int stride_ = 1;  // order of the first tracked line: the number of teeth
  double rate_ = 0.0;
  double omega_ = 0.0;  // rad/s
  double alpha_ = 0.0;  // rad/s^2
  // Covariance of angle, omega and alpha.
  double p00_ = 0.0, p01_ = 0.0, p02_ = 0.0, p11_ = 0.0, p12_ = 0.0, p22_ = 0.0;
  bool mayDrift_ = true;
  DriftWatch drift_;
  double time_ = 0.0;      // s, since the start
  double angleSum_ = 0.0;  // rad, of the frames of this turn
  long frames_ = 0;
  int turns_ = 0;
  double scatter_ = 0.0;
  std::array<double, kChannels> all_{};  // sum of squares of this turn
  double usual_ = 0.0;                   // power of a turn beside the followed lines, over a long while
  int scattered_ = 0;                    // turns on end of which next to nothing repeats; below 0: and why is known
  double retained_ = 1.0;                // part of the followed amplitude that is still in its place
  bool gone_ = false;                    // too little of it is
  int inPlace_ = 0;                      // turns on end in which it is
  bool clean_ = false;                   // it was once followed with little scatter
  dsp::kernels::Kernels kernels_;
  std::array<Row, kChannels> sums_{};  // of this turn, by channel
  Row phasor_;                         // e^{-j order angle} of the frame to come
  Row turn_;                           // e^{-j order step}
  double step_ = 0.0;
  std::array<std::complex<double>, kChannels * kOrders> now_{};
  std::array<std::complex<double>, kChannels * kOrders> reference_{};
  std::array<double, kChannels * kOrders> variance_{};
};

}  // namespace stillcut::detect
