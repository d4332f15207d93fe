// The motion of tool against part under a force there, as it was measured: what the zeroth order takes instead of
// modes. Thread: const members from any; set-up.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::milling {

// One response over frequency [m/N]; no lines: nothing moves that way.
struct MeasuredResponse {
  std::vector<double> frequency;  // [Hz], rising, above 0
  std::vector<std::complex<double>> value;
};

struct MeasuredReceptance {
  MeasuredResponse xx, yy, xy;  // at least one of xx and yy

  // One clear line for lines that do not rise, none at all, or ranges that do not meet.
  Status check(const std::string& where) const;
  // What all the responses cover.
  Hertz lowest() const;
  Hertz highest() const;
  // The widest step between two lines in there.
  Hertz step() const;
  // xx, xy, yx, yy at a frequency between lowest() and highest(); straight between two lines.
  std::array<std::complex<double>, 4> at(Hertz frequency) const;
};

}  // namespace stillcut::milling
