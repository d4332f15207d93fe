#include "tests/support/field_cases/overloaded_sensor.h"

#include <algorithm>

namespace stillcut::field {

FieldCase overloadedSensor(const FourFluteSound& s, double gain) {
  constexpr int kMostAlarms = 2;  // where the overload begins there may be a break
  std::vector<double> x = fourFluteSamples(s);
  std::transform(x.begin(), x.end(), x.begin(), [gain](double v) { return std::clamp(gain * v, -1.0, 1.0); });
  FieldCase cut = fourFluteCase(s, {x});
  cut.truth.mostAlarms = kMostAlarms;
  return cut;
}

}  // namespace stillcut::field
