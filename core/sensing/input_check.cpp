#include "core/sensing/input_check.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kDeadSeconds = 0.05;  // a live sensor's last bit moves far sooner
// In device units. A converter's counts end at 2^31, and no sensor's volts, newtons or metres a second squared come
// near that: what is greater is a broken stream, and its square fills every level for as long as the cut lasts.
constexpr float kAbsurd = 1e12F;

}  // namespace

void InputCheck::prepare(const CutSetup& setup) {
  deadRun_ = std::max(16, static_cast<int>(kDeadSeconds * setup.rate.value));
  const auto& told = setup.channels;
  const auto isSpeed = [](const ChannelInfo& c) { return c.quantity == SensorQuantity::SpindleSpeed; };
  const bool onlySpeeds = std::all_of(told.begin(), told.end(), isSpeed);
  for (std::size_t c = 0; c < told.size() && c < channels_.size(); ++c) {
    channels_[c].quantity = told[c].quantity;
    channels_[c].hears = onlySpeeds || !isSpeed(told[c]);
  }
  reset();
}

void InputCheck::reset() noexcept {
  for (InputChannel& c : channels_) {
    c.run = 0;
    c.clip = {};
    c.fault = {};
  }
  clipped_ = false;
}

Reason InputCheck::lookAt(std::span<const float> samples, int index) noexcept {
  InputChannel& c = channels_[static_cast<std::size_t>(index)];
  for (const float v : samples) {
    if (!std::isfinite(v)) return {ReasonCode::InputNotFinite, {static_cast<double>(index)}};
    if (std::abs(v) > kAbsurd) return {ReasonCode::InputAbsurd, {static_cast<double>(index)}};
    c.run = c.run > 0 && v == c.last ? c.run + 1 : 1;
    c.last = v;
  }
  if (c.run >= deadRun_ && changesOnly(c.quantity)) return {ReasonCode::InputDead, {static_cast<double>(index)}};
  // What holds a value is no converter at its limit.
  clipped_ = (c.quantity != SensorQuantity::SpindleSpeed && c.clip.see(samples)) || clipped_;
  return {};
}

bool InputCheck::allBad() const noexcept {
  return std::all_of(channels_.begin(), channels_.begin() + count_,
                     [](const InputChannel& c) { return !c.hears || c.fault.code != ReasonCode::None; });
}

void InputCheck::look(const SampleBlock& block) noexcept {
  clipped_ = block.has(kBlockClipped);
  const int channels = count_ = std::min(block.channels, kMaxChannels);
  bool still = channels > 0;
  for (int c = 0; c < channels; ++c) {
    InputChannel& of = channels_[static_cast<std::size_t>(c)];
    of.fault = lookAt(block.channel(c), c);
    still = still && (!of.hears || of.run >= deadRun_);
  }
  for (int c = 0; c < channels && still; ++c) {
    InputChannel& of = channels_[static_cast<std::size_t>(c)];
    if (of.hears) of.fault = {ReasonCode::InputDead, {static_cast<double>(c)}};
  }
}

}  // namespace stillcut::detect
