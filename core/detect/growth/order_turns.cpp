#include "core/detect/growth/order_turns.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace stillcut::detect {
namespace {

constexpr double kSteady = 0.8;        // of the power, that turns as one
constexpr double kLeaks = 1.0 / 12.0;  // the sum of 1 / (2 pi d)^2 over all d, up and down

}  // namespace

void OrderTurns::prepare(int orders) {
  orders_.assign(static_cast<std::size_t>(std::max(orders, 0)), {});
}

void OrderTurns::endTurn(std::span<const std::complex<double>> now) {
  constexpr double kRate = 1.0 / kMemoryTurns;
  const std::size_t count = std::min(now.size(), orders_.size());
  for (std::size_t i = 0; i < count; ++i) {
    Order& o = orders_[i];
    o.product += kRate * (now[i] * std::conj(o.before) - o.product);
    o.power += kRate * (std::sqrt(std::norm(now[i]) * std::norm(o.before)) - o.power);
    o.past += kRate * (std::norm(o.before) - o.past);
    o.before = now[i];
  }
}

const OrderTurns::Order* OrderTurns::at(int order) const {
  return order < 1 || order > static_cast<int>(orders_.size()) ? nullptr
                                                               : &orders_[static_cast<std::size_t>(order - 1)];
}

double OrderTurns::drift(int order) const {
  const Order* o = at(order);
  return o != nullptr ? std::arg(o->product) / kTwoPi : 0.0;
}

bool OrderTurns::turns(int order) const {
  const Order* o = at(order);
  return o != nullptr && std::abs(o->product) > kSteady * o->power && std::abs(drift(order)) > kLeastDrift;
}

double OrderTurns::change(int order) const {
  const Order* o = at(order);
  return o != nullptr && o->past > 0.0 ? std::abs(1.0 - o->product / o->past) : std::numeric_limits<double>::infinity();
}

// Of a line that changes by the part c from turn to turn a filter of two turns leaves c, and every order d away from it
// takes c / (2 pi d) of that line.
double OrderTurns::leak(int order, double energy) const {
  const Order* o = at(order);
  if (o == nullptr || !(o->past > 0.0) || std::abs(o->product) < kSteady * o->power) return 0.0;
  return kLeaks * std::norm(1.0 - o->product / o->past) * energy;
}

}  // namespace stillcut::detect
