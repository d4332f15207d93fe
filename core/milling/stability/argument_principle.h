// The change of arg f along an arc of a circle about 0, by adaptive bisection; what every count of multipliers here
// rests on. Counting on |mu| = r: a function analytic outside with f ~ mu^n at infinity has
// n - (rounds of arg f along the whole circle) zeros outside. Pure: any thread; set-up, not real-time.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace stillcut::milling {

namespace detail {

// Halves until both halves of a step rotate by less than 0.8 rad; `touches` when that never happens: a zero on the arc.
template <class F>
double bisectedChange(const F& f, double a, std::complex<double> fa, double b, std::complex<double> fb, int level,
                      bool& touches) {
  if (touches) return 0.0;
  const double m = 0.5 * (a + b);
  const std::complex<double> fm = f(m);
  const double first = std::arg(fm / fa);
  const double second = std::arg(fb / fm);
  if (std::abs(first) < 0.8 && std::abs(second) < 0.8) return first + second;
  if (level > 36 || !std::isfinite(first + second)) {
    touches = true;
    return 0.0;
  }
  return bisectedChange(f, a, fa, m, fm, level + 1, touches) + bisectedChange(f, m, fm, b, fb, level + 1, touches);
}

}  // namespace detail

// f maps an angle in [a, b] to a complex value; `pieces` is how many steps to begin with. NaN when a zero lies on the
// arc to within what can be resolved.
template <class F>
double argumentChange(const F& f, double a, double b, int pieces) {
  bool touches = false;
  double change = 0.0;
  std::complex<double> before = f(a);
  for (int i = 0; i < pieces && !touches; ++i) {
    const double from = a + (b - a) * i / pieces;
    const double to = a + (b - a) * (i + 1) / pieces;
    const std::complex<double> after = f(to);
    change += detail::bisectedChange(f, from, before, to, after, 0, touches);
    before = after;
  }
  return touches ? std::numeric_limits<double>::quiet_NaN() : change;
}

}  // namespace stillcut::milling
