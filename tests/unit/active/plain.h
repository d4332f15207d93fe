// The equations of Ford 2013 written out with lists and nothing else: what the fast versions must agree with.
#pragma once

#include <cstddef>
#include <random>
#include <vector>

namespace stillcut::active {

inline double past(const std::vector<double>& signal, std::size_t n, std::size_t back) {
  return n >= back ? signal[n - back] : 0.0;
}

// r(n) = sum a_k y(n-1-k) + sum b_k r(n-1-k), the whole signal at once.
inline std::vector<double> plainPath(const std::vector<double>& a, const std::vector<double>& b,
                                     const std::vector<double>& y) {
  std::vector<double> r(y.size(), 0.0);
  for (std::size_t n = 0; n < y.size(); ++n) {
    for (std::size_t k = 0; k < a.size(); ++k) r[n] += a[k] * past(y, n, k + 1);
    for (std::size_t k = 0; k < b.size(); ++k) r[n] += b[k] * past(r, n, k + 1);
  }
  return r;
}

// eq. 1 with e = d - y: the weights after every sample of x and d.
inline std::vector<double> plainLms(const std::vector<double>& x, const std::vector<double>& d, std::size_t taps,
                                    double mu, double leak) {
  std::vector<double> h(taps, 0.0);
  for (std::size_t n = 0; n < x.size(); ++n) {
    double e = d[n];
    for (std::size_t k = 0; k < taps; ++k) e -= h[k] * past(x, n, k);
    for (std::size_t k = 0; k < taps; ++k) h[k] = leak * h[k] + 2.0 * mu * e * past(x, n, k);
  }
  return h;
}

inline std::vector<double> whiteNoise(std::size_t count, unsigned seed, double sd = 1.0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, sd);
  std::vector<double> x(count);
  for (double& v : x) v = normal(random);
  return x;
}

}  // namespace stillcut::active
