// Physical quantities as distinct types, so that a speed in rev/min cannot be passed where a frequency is meant.
// Thread: values, no state. Real-time safe.
#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace stillcut {

// One double with a unit in its type. The unit of `value` is the type's name; everything inside the program is SI
// except Rpm, which is what people and machines call a spindle speed.
template <class Tag>
struct Quantity {
  double value = 0.0;

  constexpr Quantity() = default;
  constexpr explicit Quantity(double v) : value(v) {}

  constexpr auto operator<=>(const Quantity&) const = default;  // NOLINT(modernize-use-nullptr): the check misreads it
  constexpr Quantity operator-() const { return Quantity(-value); }
  constexpr Quantity& operator+=(Quantity o) {
    value += o.value;
    return *this;
  }
  constexpr Quantity& operator-=(Quantity o) {
    value -= o.value;
    return *this;
  }
  constexpr Quantity& operator*=(double s) {
    value *= s;
    return *this;
  }
  friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.value + b.value); }
  friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.value - b.value); }
  friend constexpr Quantity operator*(Quantity a, double s) { return Quantity(a.value * s); }
  friend constexpr Quantity operator*(double s, Quantity a) { return Quantity(a.value * s); }
  friend constexpr Quantity operator/(Quantity a, double s) { return Quantity(a.value / s); }
  // The ratio of two like quantities is a pure number.
  friend constexpr double operator/(Quantity a, Quantity b) { return a.value / b.value; }
};

using Hertz = Quantity<struct HertzTag>;
using Rpm = Quantity<struct RpmTag>;  // rev/min
using Seconds = Quantity<struct SecondsTag>;
using Metres = Quantity<struct MetresTag>;
using MetresPerSecond = Quantity<struct MetresPerSecondTag>;
using Radians = Quantity<struct RadiansTag>;
using Ratio = Quantity<struct RatioTag>;  // 1.0 is 100 %

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

constexpr Hertz toHertz(Rpm speed) {
  return Hertz(speed.value / 60.0);
}
constexpr Rpm toRpm(Hertz spindle) {
  return Rpm(spindle.value * 60.0);
}
constexpr Hertz toothPassing(Rpm speed, int teeth) {
  return Hertz(speed.value / 60.0 * teeth);
}
constexpr double toMmPerMin(MetresPerSecond v) {
  return v.value * 60e3;
}
constexpr MetresPerSecond fromMmPerMin(double v) {
  return MetresPerSecond(v / 60e3);
}

template <class Tag>
bool isFinite(Quantity<Tag> q) {
  return std::isfinite(q.value);
}

}  // namespace stillcut
