#include "core/detect/growth/order_pole.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace stillcut::detect {
namespace {

constexpr std::size_t kTurns = OrderPole::kTurns;
constexpr int kPassings = 6;        // tooth passings that tell the load
constexpr double kSure = 3.0;       // standard deviations
constexpr double kByLoad = 0.6;     // of s / g
constexpr double kLeastPole = 0.1;  // an e-fold and a half in the window
// What has grown out of what runout forces grows as the pole does; what beats with it does for a while.
constexpr double kAsPole = 0.75;
// By less: an e-fold in twenty turns, which takes longer to fit, or in the time in which no instability takes as long.
constexpr double kSettles = 0.05;
constexpr Seconds kSettling{0.1};
constexpr double kSettlesSure = 2.0;

using Turns = std::array<std::complex<double>, kTurns + 1>;  // newest first

struct Load {
  std::array<double, kTurns + 1> load{};   // over the newest
  std::array<double, kTurns + 1> angle{};  // by which the spindle stood elsewhere than was thought [rad]
};

// By all tooth passings but the two that the order lies between. A speed that is followed strays by a tenth of a per
// cent for some turns, and every order turns by it.
bool readTeeth(const NewLine& vibration, int channel, const OrderPole::Teeth& teeth, int order, Hertz spindle,
               Load& out) {
  std::array<Turns, kPassings> passings{};
  std::array<int, kPassings> orders{};
  std::size_t count = 0;
  for (int k = 1; k <= kPassings; ++k) {
    const int n = k * teeth.count;
    if (n > teeth.harmonics || std::abs(n - order) < teeth.count) continue;
    orders[count] = n;
    if (!vibration.turnsOf(channel, spindle * n, spindle, passings[count])) return false;
    ++count;
  }
  double now = 0.0;
  for (std::size_t i = 0; i < count; ++i) now += std::norm(passings[i].front());
  if (!(now > 0.0)) return false;
  double angle = 0.0;
  for (std::size_t k = 0; k <= kTurns; ++k) {
    double turned = 0.0;
    double weight = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::complex<double> product =
          passings[i][k] * std::conj(passings[i].front()) * std::polar(1.0, -angle * orders[i]);
      turned += orders[i] * std::abs(product) * std::arg(product);
      weight += orders[i] * static_cast<double>(orders[i]) * std::abs(product);
    }
    if (weight > 0.0) angle += turned / weight;
    double then = 0.0;
    for (std::size_t i = 0; i < count; ++i)
      then += std::real(passings[i][k] * std::conj(passings[i].front()) * std::polar(1.0, -angle * orders[i]));
    out.angle[k] = angle;
    out.load[k] = then / now;
  }
  return true;
}

// The order's amplitude, where the spindle really stood, and the load.
bool readOrder(const NewLine& vibration, int channel, const OrderPole::Teeth& teeth, int order, Hertz spindle, Turns& e,
               Load& t) {
  if (teeth.count < 1 || order < 1 || !vibration.turnsOf(channel, spindle * order, spindle, e) ||
      !readTeeth(vibration, channel, teeth, order, spindle, t))
    return false;
  for (std::size_t k = 0; k <= kTurns; ++k) e[k] *= std::polar(1.0, -t.angle[k] * order);
  return true;
}

// In a turn, over two.
double growthOf(std::complex<double> now, std::complex<double> before) {
  return 0.5 * std::log(std::abs(now) / std::abs(before));
}

template <class Values>
double powerOf(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0, [](double sum, auto v) { return sum + std::norm(v); });
}

template <class Values>
void takeMean(Values& values) {
  using Value = typename Values::value_type;
  const Value mean = std::accumulate(values.begin(), values.end(), Value{}) / static_cast<double>(values.size());
  for (Value& v : values) v -= mean;
}

}  // namespace

// Both sides of the equation over each turn, without what f0 and f1 take of them.
bool OrderPole::fit(const NewLine& vibration, int channel, const Teeth& teeth, int order, Hertz spindle) {
  Turns e{};
  Load t;
  if (!readOrder(vibration, channel, teeth, order, spindle, e, t)) return false;
  std::array<std::complex<double>, kTurns> grown{};
  std::array<std::complex<double>, kTurns> middle{};
  std::array<double, kTurns> loads{};
  for (std::size_t k = 0; k < kTurns; ++k) {
    grown[k] = e[k] - e[k + 1];
    middle[k] = 0.5 * (e[k] + e[k + 1]);
    loads[k] = 0.5 * (t.load[k] + t.load[k + 1]);
  }
  takeMean(grown);
  takeMean(middle);
  takeMean(loads);
  const double spread = std::inner_product(loads.begin(), loads.end(), loads.begin(), 0.0);
  const auto takeLoad = [&](auto& values) {
    std::complex<double> part = 0.0;
    for (std::size_t k = 0; k < kTurns; ++k) part += loads[k] * values[k];
    for (std::size_t k = 0; k < kTurns && spread > 0.0; ++k) values[k] -= loads[k] / spread * part;
  };
  takeLoad(grown);
  takeLoad(middle);
  std::complex<double> product = 0.0;
  double power = 0.0;
  for (std::size_t k = 0; k < kTurns; ++k) {
    product += grown[k] * std::conj(middle[k]);
    power += std::norm(middle[k]);
  }
  const double before = std::abs(e[2]);
  if (!(power > 0.0) || !(before > 0.0)) return false;
  pole = product / power;
  double rest = 0.0;
  for (std::size_t k = 0; k < kTurns; ++k) rest += std::norm(grown[k] - pole * middle[k]);
  doubt = std::sqrt(0.5 * rest / (static_cast<double>(kTurns - 3) * power));
  growth = growthOf(e[0], e[2]);
  load = 0.5 * (t.load[0] - t.load[2]);
  return true;
}

// Gram and Schmidt: of each column what those before it leave; the pole's is the last but one.
bool OrderPole::fitMoving(const NewLine& vibration, int channel, const Teeth& teeth, int order, Hertz spindle) {
  constexpr std::size_t kKnown = 4;
  Turns e{};
  Load t;
  if (!readOrder(vibration, channel, teeth, order, spindle, e, t)) return false;
  std::array<std::array<std::complex<double>, kTurns>, kKnown + 1> columns{};
  for (std::size_t k = 0; k < kTurns; ++k) {
    const std::complex<double> middle = 0.5 * (e[k] + e[k + 1]);
    const double b = 0.5 * (t.load[k] + t.load[k + 1]) - t.load[0];
    columns[0][k] = 1.0;
    columns[1][k] = b;
    columns[2][k] = b * middle;
    columns[3][k] = middle;
    columns[kKnown][k] = e[k] - e[k + 1];
  }
  double power = 0.0;
  for (std::size_t c = 0; c < kKnown; ++c) {
    power = powerOf(columns[c]);
    if (!(power > 0.0)) return false;
    for (std::size_t d = c + 1; d <= kKnown; ++d) {
      std::complex<double> part = 0.0;
      for (std::size_t k = 0; k < kTurns; ++k) part += columns[d][k] * std::conj(columns[c][k]);
      part /= power;
      for (std::size_t k = 0; k < kTurns; ++k) columns[d][k] -= part * columns[c][k];
      pole = part;
    }
  }
  doubt = std::sqrt(0.5 * powerOf(columns[kKnown]) / (static_cast<double>(kTurns - kKnown) * power));
  return true;
}

bool OrderPole::settles(Hertz spindle) const {
  return pole.real() + kSettlesSure * doubt < std::min(kSettles, 1.0 / (kSettling.value * spindle.value));
}

bool OrderPole::mayGrow(const NewLine& vibration, int channel, int order, Hertz spindle) {
  std::array<std::complex<double>, 3> e{};
  if (order < 1 || !vibration.turnsOf(channel, spindle * order, spindle, e) || !(std::abs(e[2]) > 0.0)) return false;
  return growthOf(e[0], e[2]) >= kAsPole * kLeastPole;
}

bool OrderPole::growsByItself() const {
  if (growth < kAsPole * pole.real()) return false;
  return pole.real() > std::max(kLeastPole, kSure * doubt + kByLoad * std::max(load, 0.0) / growth);
}

}  // namespace stillcut::detect
