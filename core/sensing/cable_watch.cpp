#include "core/sensing/cable_watch.h"

#include <algorithm>
#include <cmath>

#include "core/sensing/abrupt_end.h"
#include "core/sensing/input_check.h"

namespace stillcut::detect {
namespace {

constexpr double kFallen = 0.01;   // 20 dB
constexpr double kReturned = 0.1;  // of what it was: no cable
constexpr double kAlive = 4.0;     // 6 dB above what was left
constexpr double kSame = 2.0;      // 3 dB either way
constexpr double kAboveAir = 4.0;  // 6 dB
constexpr double kSeconds = 0.5;

}  // namespace

void CableWatch::prepare(const CutSetup& setup) {
  channels_.assign(setup.channels.size(), {});
  hop_ = static_cast<int>(std::lround(1e-3 * setup.rate.value));
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const SensorQuantity quantity = setup.channels[c].quantity;
    const auto same = [quantity](const ChannelInfo& other) { return other.quantity == quantity; };
    channels_[c].quantity = quantity;
    channels_[c].alone =
        changesOnly(quantity) && std::count_if(setup.channels.begin(), setup.channels.end(), same) == 1;
  }
}

void CableWatch::reset() noexcept {
  for (CableChannel& c : channels_) {
    const SensorQuantity quantity = c.quantity;
    const bool alone = c.alone;
    c = {};
    c.quantity = quantity;
    c.alone = alone;
  }
}

bool CableWatch::anotherGoesOn(std::size_t channel, const CutGate& gate) const noexcept {
  const CableChannel& fallen = channels_[channel];
  for (std::size_t o = 0; o < channels_.size(); ++o) {
    const CableChannel& other = channels_[o];
    if (o == channel || other.quantity != fallen.quantity || other.left > 0.0) continue;
    const double was = fallen.beside[o];
    const double air = gate.airFloor(static_cast<int>(o));
    if (air > 0.0 && was > kAboveAir * air && other.latest < kSame * was && other.latest * kSame > was) return true;
  }
  return false;
}

void CableWatch::look(int channel, std::span<const double> window, std::span<const double> windowBefore,
                      double meanSquare, double perSecond, const CutGate& gate) noexcept {
  const auto i = static_cast<std::size_t>(channel);
  CableChannel& c = channels_[i];
  c.latest = meanSquare;
  if (c.left > 0.0) {
    ++c.windows;
    if (c.broken) {
      if (meanSquare > kAlive * c.left) c.broken = false;
    } else if (meanSquare < kReturned * c.before && c.windows < kSeconds * perSecond) {
      return;  // not yet decided
    } else {
      c.broken = meanSquare < kReturned * c.before && (c.cutOff || anotherGoesOn(i, gate));
    }
    if (c.broken) return;
    c.left = 0.0;
    c.level = meanSquare;
    return;
  }
  if (c.level > 0.0 && meanSquare < kFallen * c.level) {
    c.left = meanSquare;
    c.before = c.level;
    c.windows = 0;
    c.cutOff = c.alone && c.level > kAboveAir * gate.airFloor(channel) && endsAbruptly(windowBefore, window, hop_);
    for (std::size_t o = 0; o < channels_.size(); ++o) c.beside[o] = channels_[o].level;
    return;
  }
  c.level = c.level > 0.0 ? c.level + (meanSquare - c.level) / perSecond : meanSquare;
}

}  // namespace stillcut::detect
