// The numeric chain of the energy-ratio detector: residual of the rotating Kalman filter, band-pass bank, energy
// separation, energy ratio (Caliskan 2018 eq. 16-29). Nothing is judged here.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include "core/detect/energy_separation.h"
#include "core/detect/harmonic_kalman.h"

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
  };
  void prepare(const Size& size);
  void reset() noexcept;

  // Follows the speed; gain: of the harmonic filter (harmonic_kalman.h).
  void tune(Hertz spindle, double gain) noexcept;
  // Spindle angle of the next frame and turn per frame [rad].
  void align(double angle, double step) noexcept { kalman_.align(angle, step); }
  // One frame, one value per channel.
  void process(const double* x) noexcept;
  // Ends a hop: the estimates are the means since the last call.
  void endHop() noexcept { bands_.estimate(); }

  // Harmonics below the end of the usable band at this speed.
  int active() const noexcept { return kalman_.active(); }
  // ER of eq. 28, 29 for the last hop; eta: 1 displacement, 0 velocity, sound, speed and current, -1 acceleration.
  double ratio(int channel, int eta) const noexcept;

 private:
  Size size_;
  Hertz spindle_{};
  HarmonicKalman kalman_;
  EnergySeparation bands_;
  std::vector<double> rest_;
};

}  // namespace stillcut::detect
