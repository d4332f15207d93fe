#include "core/detect/order_growth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace stillcut::detect {
namespace {

// Of the other orders' energy: 7 % of their amplitude where the class is known to be chatter's, 20 % elsewhere.
constexpr double kSmallest = 5e-3;
constexpr double kSmallestBeside = 0.04;
constexpr double kOtherSpeed = 5e-3;
constexpr double kDriftTurns = 6.0;     // memory of the phase
constexpr double kLeastDrift = 0.012;   // orders: what a spindle known to 0.1 % leaves at the twelfth order
constexpr double kSteady = 0.8;         // of the power, that turns as one
constexpr double kStill = 0.01;         // orders
constexpr double kNewLoadTurns = 24.0;  // grown for so long and standing still: a new load

}  // namespace

void OrderGrowth::prepare(int teeth, int eta, int harmonics) {
  teeth_ = teeth;
  eta_ = eta;
  learnedAt_ = {};
  classes_.assign(static_cast<std::size_t>(std::max(teeth, 0) / 2), {});
  orders_.assign(static_cast<std::size_t>(std::max(harmonics, 0)), {});
  relearn();
}

void OrderGrowth::setEvidence(double evidence) noexcept {
  for (Class& c : classes_) c.onset.prepare({flips(c) ? kSmallest : kSmallestBeside, evidence});
}

void OrderGrowth::relearn() noexcept {
  for (Class& c : classes_) {
    c.onset.reset();
    c.counts = false;
    c.alarmTurns = 0.0;
  }
  order_ = 0.0;
  doubling_ = false;
}

void OrderGrowth::setSpindle(Hertz spindle) noexcept {
  for (Class& c : classes_) c.onset.setSpindle(spindle);
  if (grown() || std::abs(spindle.value - learnedAt_.value) < kOtherSpeed * spindle.value) return;
  learnedAt_ = spindle;
  relearn();
}

bool OrderGrowth::flips(const Class& c) const noexcept {
  return teeth_ % 2 == 0 && &c == &classes_.back();
}

void OrderGrowth::follow(const EnergyChain& chain, int channel) noexcept {
  constexpr double kRate = 1.0 / kDriftTurns;
  const int count = std::min(chain.active(), static_cast<int>(orders_.size()));
  for (int n = 1; n <= count; ++n) {
    Order& o = orders_[static_cast<std::size_t>(n - 1)];
    const std::complex<double> now = chain.amplitude(channel, n);
    o.product += kRate * (now * std::conj(o.before) - o.product);
    o.power += kRate * (std::abs(now) * std::abs(o.before) - o.power);
    o.before = now;
  }
}

void OrderGrowth::endHop(const EnergyChain& chain, int channel) noexcept {
  if (classes_.empty()) return;
  hop_ = (hop_ + 1) % kHopsPerTurn;
  if (hop_ == 0) follow(chain, channel);
  all_ = weightedAll_ = 0.0;
  for (Class& c : classes_) c.power = c.weighted = c.strongest = 0.0;
  for (int n = 1; n <= chain.active(); ++n) {
    const double power = chain.harmonicPower(channel, n);
    const double weight = eta_ == 0 ? 1.0 : eta_ > 0 ? 1.0 * n * n : 1.0 / (1.0 * n * n);
    all_ += power;
    weightedAll_ += power * weight;
    const int rest = n % teeth_;
    if (rest == 0) continue;
    Class& c = classes_[static_cast<std::size_t>(std::min(rest, teeth_ - rest) - 1)];
    c.power += power;
    c.weighted += power * weight;
    if (power <= c.strongest) continue;
    c.strongest = power;
    c.order = n;
  }
}

double OrderGrowth::drift(int order) const noexcept {
  if (order < 1 || order > static_cast<int>(orders_.size())) return 0.0;
  return std::arg(orders_[static_cast<std::size_t>(order - 1)].product) / kTwoPi;
}

bool OrderGrowth::turns(int order) const noexcept {
  if (order < 1 || order > static_cast<int>(orders_.size())) return false;
  const Order& o = orders_[static_cast<std::size_t>(order - 1)];
  return std::abs(o.product) > kSteady * o.power && std::abs(drift(order)) > kLeastDrift;
}

void OrderGrowth::test(double turns, bool learn) noexcept {
  order_ = 0.0;
  doubling_ = false;
  double strongest = 0.0;
  for (Class& c : classes_) {
    c.onset.update(share(c), turns, learn, c.power);
    const bool grown = c.onset.alarm();
    c.counts = grown && (flips(c) || c.counts || this->turns(c.order));
    c.alarmTurns = grown && !c.counts ? c.alarmTurns + turns : 0.0;
    if (learn && c.alarmTurns > kNewLoadTurns) c.onset.reset();
    if (!c.counts || c.strongest < kLeastPurity * c.power || c.strongest <= strongest) continue;
    strongest = c.strongest;
    const double turned = drift(c.order);
    doubling_ = flips(c) && std::abs(turned) < kStill;
    order_ = c.order + (doubling_ ? 0.0 : turned);
  }
}

bool OrderGrowth::grown() const noexcept {
  return std::any_of(classes_.begin(), classes_.end(), [](const Class& c) { return c.counts; });
}

double OrderGrowth::severity() const noexcept {
  if (!(weightedAll_ > 0.0)) return 0.0;
  double sum = 0.0;
  for (const Class& c : classes_) {
    const double now = share(c);
    if (c.counts && now > 0.0) sum += c.weighted / weightedAll_ * std::max(0.0, 1.0 - c.onset.floor() / now);
  }
  return sum;
}

}  // namespace stillcut::detect
