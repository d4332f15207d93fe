// A measured frequency response function: response over force at one pair of points.
// Units: SI throughout; compliance m/N, mobility (m/s)/N, accelerance (m/s^2)/N. Plain values: any thread.
#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/milling/identify/axis.h"

namespace stillcut::identify {

enum class FrfQuantity { Compliance, Mobility, Accelerance };

struct Frf {
  std::vector<double> frequency;            // [Hz], rising, > 0 after toCompliance()
  std::vector<std::complex<double>> value;  // as many as frequency
  FrfQuantity quantity = FrfQuantity::Compliance;
  std::vector<double> coherence;  // 0..1, as many as frequency; empty when only one hit was measured
  // Where the measurement carries information, from the hammer's spectrum; 0 when not known [Hz].
  double usableTo = 0.0;
  // Decay rate an exponential window added to every mode [1/s]; the modal fit takes it off again.
  double addedDecay = 0.0;
  Axis axis = Axis::Unknown;  // of force and response
  bool unitKnown = true;      // false: nobody said the unit, the values are the file's own
  std::string source;         // file and data set, for messages
};

// The same measurement as compliance: divided by i w per step of differentiation; lines at 0 Hz are dropped.
Frf toCompliance(const Frf& frf);

}  // namespace stillcut::identify
