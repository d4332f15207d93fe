#include "core/milling/stability/any_tool/gauss_points.h"

#include <cmath>
#include <numbers>

namespace stillcut::milling {

// By Newton on the Legendre polynomial.
std::vector<GaussPoint> gaussPoints(int n) {
  std::vector<GaussPoint> points;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int round = 0; round < 20; ++round) {
      double p = 1.0, before = 0.0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k;
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1.0);
      const double step = p / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    points.push_back({0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)});
  }
  return points;
}

}  // namespace stillcut::milling
