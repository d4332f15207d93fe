// Mains hum in one channel: what part of the vibration lies on the mains frequency and its multiples, over one second.
// A line counts where no multiple of the spindle's frequency reads the same, and where it stands on the mains to a
// fifth of a hertz: by its phase between the halves of a second and from one second to the next. No cut holds that.
// Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/units.h"

namespace stillcut::detect {

class HumWatch {
 public:
  void prepare(Hertz rate);
  void reset() noexcept;
  // Conditioned samples.
  void push(std::span<const double> x, Hertz spindle) noexcept;

  // Of the last whole second; 0 until there were two.
  double part() const noexcept { return part_; }
  double meanSquare() const noexcept { return meanSquare_; }
  Hertz mains() const noexcept { return mains_; }  // 50 or 60

  static constexpr std::size_t kLines = 8;  // 4 multiples of 50 Hz, then of 60 Hz
  Hertz frequency(std::size_t line) const noexcept { return Hertz(lines_[line].frequency); }
  // Mean square of a line in the last whole second; 0 where it does not stand on the mains.
  double power(std::size_t line) const noexcept { return lines_[line].power; }
  // A multiple of the spindle's frequency is so near that a second does not tell them apart.
  bool nearOrder(std::size_t line, Hertz spindle) const noexcept;

 private:
  struct Line {
    double frequency = 0.0;
    std::complex<double> step, rotor, windowed, firstHalf, secondHalf, before;
    bool known = false;
    double power = 0.0;
  };
  void add(double x) noexcept;
  void finish() noexcept;
  bool onMains(const Line& line) const noexcept;

  std::array<Line, kLines> lines_{};
  std::vector<double> window_;  // Hann
  int decimation_ = 1;
  int count_ = 0;  // samples in the running mean
  double sum_ = 0.0;
  int index_ = 0;      // in the window
  int length_ = 1000;  // of it, after decimation
  double squares_ = 0.0;
  long frames_ = 0;
  Hertz spindle_{};
  double part_ = 0.0;
  double meanSquare_ = 0.0;
  Hertz mains_{};
};

}  // namespace stillcut::detect
