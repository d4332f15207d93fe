#include "core/sensing/left_out.h"

#include <algorithm>

namespace stillcut::detect {

void LeftOut::prepare(const CutSetup& setup) noexcept {
  channels_ = {};
  count_ = std::min(static_cast<int>(setup.channels.size()), kMaxChannels);
  const auto isSpeed = [](const ChannelInfo& c) { return c.quantity == SensorQuantity::SpindleSpeed; };
  const bool onlySpeeds = std::all_of(setup.channels.begin(), setup.channels.end(), isSpeed);
  for (std::size_t c = 0; c < static_cast<std::size_t>(count_); ++c)
    channels_[c].measuresCut = onlySpeeds || !isSpeed(setup.channels[c]);
  reset();
}

void LeftOut::reset() noexcept {
  for (LeftOutChannel& c : channels_) {
    c.out = false;
    c.sound = 0.0;
    c.fault = {};
  }
  returned_ = false;
}

void LeftOut::see(int channel, const Reason& fault, Seconds length) noexcept {
  LeftOutChannel& c = channels_[static_cast<std::size_t>(channel)];
  if (fault.code != ReasonCode::None) {
    c.out = true;
    c.sound = 0.0;
    c.fault = fault;
    return;
  }
  if (!c.out) return;
  c.sound += length.value;
  const bool needed = allOut().code != ReasonCode::None && c.measuresCut;
  if (c.sound < kReturns && !needed) return;
  c.out = false;
  c.fault = {};
  returned_ = true;
}

bool LeftOut::any() const noexcept {
  return std::any_of(channels_.begin(), channels_.begin() + count_, [](const LeftOutChannel& c) { return c.out; });
}

bool LeftOut::takeReturned() noexcept {
  const bool returned = returned_;
  returned_ = false;
  return returned;
}

Reason LeftOut::allOut() const noexcept {
  Reason first;
  for (int i = 0; i < count_; ++i) {
    const LeftOutChannel& c = channels_[static_cast<std::size_t>(i)];
    if (!c.measuresCut) continue;
    if (!c.out) return {};
    if (first.code == ReasonCode::None) first = c.fault;
  }
  return first;
}

}  // namespace stillcut::detect
