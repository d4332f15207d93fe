#include "tests/support/field_cases/second_channel.h"

#include <algorithm>

#include "tests/support/field_cases/tone.h"

namespace stillcut::field {
namespace {

constexpr double kDies_s = 1.0;  // after the entry
constexpr double kMains = 50.0;  // Hz
constexpr double kHum = 0.1;     // of full scale

std::vector<double> secondOf(const FourFluteSound& s, const std::vector<double>& first, SecondChannel second) {
  std::vector<double> y(first.size(), 0.0);
  if (second == SecondChannel::Hums) addTone(y, s.rate, {kHum, kMains, 0.0});
  if (second == SecondChannel::Dies) {
    y = first;
    const auto from = static_cast<std::ptrdiff_t>((s.entry + kDies_s) * s.rate);
    std::fill(y.begin() + from, y.end(), y[static_cast<std::size_t>(from)]);
  }
  return y;
}

}  // namespace

FieldCase besideSecondChannel(const FourFluteSound& s, SecondChannel second) {
  const std::vector<double> first = fourFluteSamples(s);
  return fourFluteCase(s, {first, secondOf(s, first, second)});
}

}  // namespace stillcut::field
