// The lines of a motion exp(i omega t) times a function of a period, of which Hill's determinant is made: which ones
// count at an angle on the circle, and the structure's own multipliers. Thread: const members from any thread.
#pragma once

#include <complex>
#include <vector>

#include "core/milling/stability/any_tool/circle_function.h"
#include "core/milling/stability/regenerative_system.h"

namespace stillcut::milling {

struct HarmonicLine {
  double omega = 0.0;  // [rad/s], with its sign
  double fade = 1.0;
  int number = 0;
};

class HarmonicLines {
 public:
  HarmonicLines(const std::vector<RegenerativeSystem::Oscillator>& oscillators, double period);

  std::vector<HarmonicLine> at(double angle, Fineness fineness) const;
  int count(Fineness fineness) const { return static_cast<int>(at(0.5, fineness).size()); }
  // The product of (mu - mu_i) over the multipliers of the structure alone.
  std::complex<double> structure(double angle) const;

 private:
  struct Own {
    double omega, zeta;
  };
  std::vector<Own> own_;
  double highest_ = 0.0;
  double period_;
};

}  // namespace stillcut::milling
