// HumCanceller: takes mains hum out of one channel. What stood on the mains in the air before the cut is the machine's
// and goes on through the cut, where it would hide the entry and read as vibration that no tooth forces.
//
// Of every such line a complex amplitude z is followed by least mean squares and its wave subtracted:
//     e = x - sum 2 Re(z r),   z += mu e conj(r),   r = e^{j 2 pi f n / F_s},   mu = 1 / (0.3 s F_s)
// which is a notch of half a hertz on either side (Widrow et al. 1975, "Adaptive noise cancelling", Proc. IEEE 63(12)).
// What a multiple of the spindle's frequency may be as well (hum_watch.h) is the cut's, and is left alone; chatter that
// grows within half a hertz of the mains has grown long before the notch has followed it. Thread: worker; everything
// but prepare() is real-time.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "core/base/units.h"
#include "core/sensing/hum_watch.h"

namespace stillcut::detect {

class HumCanceller {
 public:
  void prepare(Hertz rate);
  void reset() noexcept;
  // Conditioned samples, in place. air: no tool cuts, what is heard is the machine's.
  void process(std::span<double> x, Hertz spindle, bool air) noexcept;
  bool active() const noexcept { return count_ > 0; }

 private:
  struct Wave {
    std::size_t line = 0;  // of the watch
    std::complex<double> step, rotor, amplitude;
  };
  void choose(Hertz spindle, bool air) noexcept;

  double rate_ = 0.0;
  HumWatch watch_;
  std::array<Wave, HumWatch::kLines> waves_{};
  std::size_t count_ = 0;
};

}  // namespace stillcut::detect
