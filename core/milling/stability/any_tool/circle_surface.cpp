#include "core/milling/stability/any_tool/circle_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace stillcut::milling {

namespace {

using Complex = std::complex<double>;

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kMostAngles = 512;
constexpr std::size_t kMostDepths = 32;
constexpr double kTail = 1e-6;  // last terms against the smallest size of f
constexpr double kRange = 1e8;  // largest against smallest: beyond, rounding reaches the small values

// Real Laurent coefficients of one depth, powers 1 - angles/2 .. angles/2; f at the angles 0 .. pi is given.
std::vector<double> laurent(const std::vector<Complex>& f) {
  const std::size_t half = f.size() - 1, count = 2 * half;
  std::vector<double> c(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto power = static_cast<long>(i) + 1 - static_cast<long>(half);
    double sum = f[0].real() + (power % 2 == 0 ? 1.0 : -1.0) * f[half].real();
    for (std::size_t j = 1; j < half; ++j) {
      const double turn = kPi * static_cast<double>(power * static_cast<long>(j) % static_cast<long>(count)) /
                          static_cast<double>(half);
      sum += 2.0 * (f[j].real() * std::cos(turn) + f[j].imag() * std::sin(turn));
    }
    c[i] = sum / static_cast<double>(count);
  }
  return c;
}

double largestOf(const std::vector<double>& c) {
  double largest = 0.0;
  for (double v : c)
    largest = std::max(largest, std::isfinite(v) ? std::abs(v) : std::numeric_limits<double>::infinity());
  return largest;
}

class Sampler {
 public:
  Sampler(const CircleFunction& f, double from, double to, WorkMeter& meter)
      : f_(f), from_(from), to_(to), meter_(meter) {
    while (angles_ < 4 * static_cast<std::size_t>(f.states())) angles_ *= 2;
  }

  // One row of Laurent coefficients per depth; false when they do not converge.
  bool run() {
    if (!settleAngles()) return false;
    for (depths_ = 8; depths_ <= kMostDepths; depths_ *= 2) {
      if (!fillRows()) return false;
      if (transform()) return true;
    }
    return false;
  }

  std::size_t angles() const { return angles_; }
  std::size_t depths() const { return depths_; }
  const std::vector<double>& series() const { return series_; }  // [power][term]
  double tolerance() const { return kTail * smallest_; }

 private:
  double depthAt(std::size_t i) const {
    const double x = std::cos(kPi * static_cast<double>(i) / static_cast<double>(depths_));
    return 0.5 * (from_ + to_) + 0.5 * (to_ - from_) * x;
  }

  // Laurent coefficients of some depths; false when stopped, or when sizes differ beyond what double precision holds.
  bool coefficients(const std::vector<double>& depths, std::vector<std::vector<double>>& c) {
    std::vector<double> angles;
    for (std::size_t j = 0; j <= angles_ / 2; ++j) {
      angles.push_back(kTwoPi * static_cast<double>(j) / static_cast<double>(angles_));
    }
    std::vector<Complex> values(angles.size());
    c.clear();
    for (const double depth : depths) {
      if (!f_.sample(depth, angles, Fineness::Rough, values, meter_)) return false;
      c.push_back(laurent(values));
      const double size = largestOf(c.back());
      largest_ = std::max(largest_, size);
      smallest_ = std::min(smallest_, size);
    }
    return std::isfinite(largest_) && largest_ <= kRange * smallest_;
  }

  // Powers far below zero are what the delays make; they end where the angles are enough.
  bool converged(const std::vector<double>& c) const {
    const double limit = 10.0 * kTail * largestOf(c);
    for (std::size_t i = 0; i < 4; ++i) {
      if (std::abs(c[i]) > limit) return false;
    }
    return true;
  }

  bool settleAngles() {
    std::vector<std::vector<double>> c;
    for (; angles_ <= kMostAngles; angles_ *= 2) {
      if (!coefficients({to_}, c)) return false;
      if (converged(c.front())) return true;
    }
    return false;
  }

  bool fillRows() {
    std::vector<std::vector<double>> rows(depths_ + 1), fresh;
    std::vector<double> depths;
    for (std::size_t i = 0; i <= depths_; ++i) {
      if (depths_ > 8 && i % 2 == 0) {
        rows[i] = std::move(rows_[i / 2]);
      } else {
        depths.push_back(depthAt(i));
      }
    }
    if (!coefficients(depths, fresh)) return false;
    std::size_t next = 0;
    for (std::vector<double>& row : rows) {
      if (row.empty()) row = std::move(fresh[next++]);
    }
    rows_ = std::move(rows);
    return true;
  }

  // Chebyshev series in the depth of every power; false when their ends are not small.
  bool transform() {
    const std::size_t terms = depths_ + 1;
    series_.assign(angles_ * terms, 0.0);
    double tail = 0.0;
    for (std::size_t l = 0; l < terms; ++l) {
      for (std::size_t i = 0; i < terms; ++i) {
        const double end = (i == 0 || i == depths_ ? 0.5 : 1.0) * (l == 0 || l == depths_ ? 0.5 : 1.0);
        const double weight = 2.0 / static_cast<double>(depths_) * end *
                              std::cos(kPi * static_cast<double>(l * i % (2 * depths_)) / static_cast<double>(depths_));
        for (std::size_t k = 0; k < angles_; ++k) series_[k * terms + l] += weight * rows_[i][k];
      }
    }
    for (std::size_t k = 0; k < angles_; ++k) {
      for (std::size_t l = terms - 2; l < terms; ++l) tail = std::max(tail, std::abs(series_[k * terms + l]));
    }
    return tail <= tolerance();
  }

  const CircleFunction& f_;
  double from_, to_;
  WorkMeter& meter_;
  std::size_t angles_ = 16, depths_ = 8;
  double largest_ = 0.0, smallest_ = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> rows_;  // [depth][power]
  std::vector<double> series_;
};

}  // namespace

std::optional<CircleSurface> CircleSurface::build(const CircleFunction& f, double from, double to, WorkMeter& meter) {
  Sampler sampler(f, from, to, meter);
  if (!sampler.run()) return std::nullopt;
  const std::size_t terms = sampler.depths() + 1, powers = sampler.angles();
  const auto small = [&](std::size_t k) {
    double size = 0.0;
    for (std::size_t l = 0; l < terms; ++l) size = std::max(size, std::abs(sampler.series()[k * terms + l]));
    return size < 0.1 * sampler.tolerance();
  };
  std::size_t first = 0, last = powers;
  while (first + 1 < last && small(first)) ++first;
  while (last > first + 1 && small(last - 1)) --last;
  std::size_t kept = terms;
  const auto endIsSmall = [&] {
    for (std::size_t k = first; k < last; ++k) {
      if (std::abs(sampler.series()[k * terms + kept - 1]) > 0.1 * sampler.tolerance()) return false;
    }
    return true;
  };
  while (kept > 2 && endIsSmall()) --kept;
  CircleSurface surface;
  surface.states_ = f.states();
  surface.lowest_ = static_cast<int>(first) + 1 - static_cast<int>(powers / 2);
  surface.middle_ = 0.5 * (from + to);
  surface.half_ = 0.5 * (to - from);
  surface.terms_ = kept;
  for (std::size_t k = first; k < last; ++k) {
    const auto begin = sampler.series().begin() + static_cast<std::ptrdiff_t>(k * terms);
    surface.series_.insert(surface.series_.end(), begin, begin + static_cast<std::ptrdiff_t>(kept));
  }
  return surface;
}

CircleValue CircleSurface::at(double angle, double depth) const {
  const double x = (depth - middle_) / half_;
  std::array<double, kMostDepths + 1> t{}, d{}, e{};  // Chebyshev polynomials, their first and second derivatives
  t[0] = 1.0;
  t[1] = x;
  d[1] = 1.0;
  for (std::size_t l = 2; l < terms_; ++l) {
    t[l] = 2.0 * x * t[l - 1] - t[l - 2];
    d[l] = 2.0 * t[l - 1] + 2.0 * x * d[l - 1] - d[l - 2];
    e[l] = 4.0 * d[l - 1] + 2.0 * x * e[l - 1] - e[l - 2];
  }
  CircleValue r{};
  const Complex i(0.0, 1.0), mu = std::polar(1.0, angle);
  Complex power = std::polar(1.0, lowest_ * angle);
  double k = lowest_;
  for (std::size_t row = 0; row < series_.size(); row += terms_, power *= mu, k += 1.0) {
    double v = 0.0, dv = 0.0, ev = 0.0;
    for (std::size_t l = 0; l < terms_; ++l) {
      const double c = series_[row + l];
      v += c * t[l];
      dv += c * d[l];
      ev += c * e[l];
    }
    r.f += v * power;
    r.fa += i * (k * v) * power;
    r.faa -= (k * k * v) * power;
    r.fw += dv * power;
    r.faw += i * (k * dv) * power;
    r.fww += ev * power;
  }
  r.fw /= half_;
  r.faw /= half_;
  r.fww /= half_ * half_;
  return r;
}

Complex CircleSurface::valueAt(double angle, double depth) const {
  const double x = (depth - middle_) / half_;
  const Complex mu = std::polar(1.0, angle);
  Complex power = std::polar(1.0, lowest_ * angle), sum = 0.0;
  for (std::size_t row = 0; row < series_.size(); row += terms_, power *= mu) {
    double before = 0.0, now = 0.0;  // Clenshaw
    for (std::size_t l = terms_; l > 1; --l) {
      const double next = series_[row + l - 1] + 2.0 * x * now - before;
      before = now;
      now = next;
    }
    sum += (series_[row] + x * now - before) * power;
  }
  return sum;
}

}  // namespace stillcut::milling
