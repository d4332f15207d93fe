#include "core/learn/lobe_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace stillcut::learn {
namespace {

using Complex = std::complex<double>;

// (a b) without the recovery of infinities, which would cost more than the product.
inline Complex times(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

// The tip's compliance at a frequency.
struct Response {
  Complex xx, xy, yy;
};

Response responseAt(const Dynamics& machine, double frequency) {
  Response g;
  for (const milling::Mode& m : machine.modes) {
    const double r = frequency / m.frequency.value;
    const double re = 1.0 - r * r;
    const double im = 2.0 * m.damping * r;
    const double scale = 1.0 / (m.stiffness * (re * re + im * im));
    const Complex h(re * scale, -im * scale);
    g.xx += h * (m.direction[0] * m.direction[0]);
    g.xy += h * (m.direction[0] * m.direction[1]);
    g.yy += h * (m.direction[1] * m.direction[1]);
  }
  return g;
}

std::array<Complex, 2> eigenvalues(const milling::Planar& h, const Response& g) {
  const Complex a = h[0] * g.xx + h[1] * g.xy;
  const Complex b = h[0] * g.xy + h[1] * g.yy;
  const Complex c = h[2] * g.xx + h[3] * g.xy;
  const Complex d = h[2] * g.xy + h[3] * g.yy;
  const Complex half = 0.5 * (a + d);
  const Complex root = std::sqrt(times(half, half) - (times(a, d) - times(b, c)));
  return {half + root, half - root};
}

// Frequencies around every mode: close at its peak, wide far from it.
std::vector<double> frequenciesFor(const Dynamics& machine) {
  constexpr int kSide = 28;
  std::vector<double> list;
  list.reserve(machine.modes.size() * (2 * kSide + 1));
  for (const milling::Mode& m : machine.modes) {
    for (int i = -kSide; i <= kSide; ++i) {
      const double offset = 0.25 * m.damping * std::sinh(5.5 * i / kSide);
      if (offset > -0.6 && offset < 1.2) list.push_back(m.frequency.value * (1.0 + offset));
    }
  }
  std::ranges::sort(list);
  return list;
}

// A point of the border: the depth, and the phase of exp(-i omega tau) there.
struct Border {
  bool on = false;
  double frequency = 0.0;
  double logDepth = 0.0;
  double phase = 0.0;
  Complex eigenvalue;
};

Border borderAt(double frequency, Complex eigenvalue) {
  Border b;
  b.frequency = frequency;
  b.eigenvalue = eigenvalue;
  const double size = std::norm(eigenvalue);
  if (!(size > 0.0) || !(eigenvalue.real() < 0.0)) return b;
  const Complex s(-eigenvalue.real() / size, eigenvalue.imag() / size);  // -1/eigenvalue
  const double depth = std::norm(s) / (2.0 * s.real());
  const Complex turn = 1.0 - s / depth;
  b.phase = std::arg(turn);
  b.logDepth = std::log(depth);
  b.on = std::isfinite(b.logDepth);
  return b;
}

class Rasterizer {
 public:
  Rasterizer(const SpeedGrid& grid, int teeth, double logDeepest, std::vector<LimitPoint>& out)
      : grid_(grid), teeth_(teeth), logDeepest_(logDeepest), out_(out) {
    logLowest_ = std::log(grid.lowest);
    perLog_ = (grid.points - 1) / std::log(grid.highest / grid.lowest);
  }

  // Two neighbours on the border are joined in every lobe that reaches the grid.
  void join(const Border& a, const Border& b) {
    if (std::min(a.logDepth, b.logDepth) > logDeepest_) return;
    const double phaseB = a.phase + std::remainder(b.phase - a.phase, kTwoPi);
    // omega tau = 2 pi p - phase, tau = 60/(teeth speed).
    const double waves = 60.0 * a.frequency / teeth_;  // per tooth times speed
    const int first = std::max(0, static_cast<int>(waves / (1.02 * grid_.highest) + a.phase / kTwoPi) - 1);
    const int last = static_cast<int>(waves / (0.98 * grid_.lowest) + a.phase / kTwoPi) + 1;
    for (int p = first; p <= last; ++p) {
      const double turnsA = p - a.phase / kTwoPi;
      const double turnsB = p - phaseB / kTwoPi;
      if (turnsA <= 0.02 || turnsB <= 0.02) continue;
      line(place(waves / turnsA), a, place(60.0 * b.frequency / teeth_ / turnsB), b);
    }
  }

 private:
  double place(double speed) const { return perLog_ * (std::log(speed) - logLowest_); }

  void line(double xa, const Border& a, double xb, const Border& b) {
    const double low = std::min(xa, xb);
    const double high = std::max(xa, xb);
    const int from = std::max(0, static_cast<int>(std::ceil(low)));
    const int to = std::min(grid_.points - 1, static_cast<int>(std::floor(high)));
    for (int i = from; i <= to; ++i) {
      const double share = xb == xa ? 0.0 : (i - xa) / (xb - xa);
      const auto depth = static_cast<float>(a.logDepth + share * (b.logDepth - a.logDepth));
      LimitPoint& point = out_[static_cast<std::size_t>(i)];
      if (depth >= point.logDepth) continue;
      point.logDepth = depth;
      point.frequency = static_cast<float>(a.frequency + share * (b.frequency - a.frequency));
    }
  }

  const SpeedGrid& grid_;
  int teeth_;
  double logDeepest_;
  double logLowest_ = 0.0;
  double perLog_ = 0.0;
  std::vector<LimitPoint>& out_;
};

}  // namespace

double SpeedGrid::at(int i) const {
  return lowest * std::pow(highest / lowest, static_cast<double>(i) / (points - 1));
}

double SpeedGrid::place(double speed) const {
  const double x = (points - 1) * std::log(speed / lowest) / std::log(highest / lowest);
  return std::clamp(x, 0.0, static_cast<double>(points - 1));
}

ForceShape meanForce(const milling::Engagement& engagement, int teeth) {
  const double from = engagement.startAngle();
  const double to = engagement.exitAngle();
  const double sineCosine = 0.25 * (std::cos(2.0 * from) - std::cos(2.0 * to));
  const double swing = 0.25 * (std::sin(2.0 * to) - std::sin(2.0 * from));
  const double sine = 0.5 * (to - from) - swing;
  const double cosine = 0.5 * (to - from) + swing;
  const double scale = teeth / kTwoPi;
  ForceShape shape;
  shape.tangential = {scale * sineCosine, scale * cosine, -scale * sine, -scale * sineCosine};
  shape.radial = {scale * sine, scale * sineCosine, scale * sineCosine, scale * cosine};
  return shape;
}

void fillLimits(const Dynamics& machine, const ForceShape& shape, int teeth, const SpeedGrid& grid, double deepest,
                std::vector<LimitPoint>& out) {
  const double logDeepest = std::log(deepest);
  out.assign(static_cast<std::size_t>(grid.points), {static_cast<float>(logDeepest), 0.0F});
  milling::Planar h{};
  for (std::size_t i = 0; i < h.size(); ++i) {
    h[i] = machine.tangential * (shape.tangential[i] + machine.radialRatio * shape.radial[i]);
  }
  Rasterizer raster(grid, teeth, logDeepest, out);
  std::array<Border, 2> before;
  for (const double frequency : frequenciesFor(machine)) {
    auto values = eigenvalues(h, responseAt(machine, frequency));
    // The square root may change its sheet between two frequencies: follow the nearer eigenvalue.
    const double straight = std::norm(values[0] - before[0].eigenvalue) + std::norm(values[1] - before[1].eigenvalue);
    const double crossed = std::norm(values[1] - before[0].eigenvalue) + std::norm(values[0] - before[1].eigenvalue);
    if (before[0].frequency > 0.0 && crossed < straight) std::swap(values[0], values[1]);
    for (std::size_t branch = 0; branch < 2; ++branch) {
      const Border now = borderAt(frequency, values[branch]);
      if (before[branch].on && now.on) raster.join(before[branch], now);
      before[branch] = now;
    }
  }
}

LimitPoint limitAt(std::span<const LimitPoint> table, const SpeedGrid& grid, double speed) {
  const double x = grid.place(speed);
  const auto i = std::min(static_cast<std::size_t>(x), table.size() - 2);
  const auto share = static_cast<float>(x - static_cast<double>(i));
  const LimitPoint& nearer = share < 0.5F ? table[i] : table[i + 1];
  return {table[i].logDepth + share * (table[i + 1].logDepth - table[i].logDepth), nearer.frequency};
}

}  // namespace stillcut::learn
