#include "core/detect/input_check.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kDeadSeconds = 0.05;  // a live sensor's last bit moves far sooner
// One flat top can be chance (a quantised slow sine); the same extreme value reached flat again and again is a limit.
constexpr int kFlatRun = 5;
constexpr int kFlatTops = 3;

}  // namespace

void InputCheck::prepare(const CutSetup& setup) {
  deadRun_ = std::max(16, static_cast<int>(kDeadSeconds * setup.rate.value));
  reset();
}

void InputCheck::reset() noexcept {
  channels_ = {};
}

Reason InputCheck::checkChannel(std::span<const float> samples, int index) noexcept {
  Channel& c = channels_[static_cast<std::size_t>(index)];
  for (const float v : samples) {
    if (!std::isfinite(v)) return {ReasonCode::InputNotFinite, {static_cast<double>(index)}};
    c.run = v == c.last ? c.run + 1 : 1;
    c.last = v;
    const float magnitude = std::abs(v);
    if (magnitude > c.extreme) {
      c.extreme = magnitude;
      c.flatTops = 0;
    } else if (magnitude == c.extreme && c.run == kFlatRun && c.extreme > 0.0F) {
      ++c.flatTops;
    }
  }
  if (c.run >= deadRun_) return {ReasonCode::InputDead, {static_cast<double>(index)}};
  const bool atLimit = std::any_of(samples.begin(), samples.end(), [&](float v) { return std::abs(v) == c.extreme; });
  if (c.flatTops >= kFlatTops && atLimit) return {ReasonCode::InputClipped, {}};
  return {};
}

Reason InputCheck::check(const SampleBlock& block) noexcept {
  Reason worst;
  const int channels = std::min(block.channels, kMaxChannels);
  for (int c = 0; c < channels; ++c) {
    const Reason reason = checkChannel(block.channel(c), c);
    if (worst.code == ReasonCode::None) worst = reason;
  }
  if (worst.code == ReasonCode::None && block.has(kBlockClipped)) return {ReasonCode::InputClipped, {}};
  return worst;
}

}  // namespace stillcut::detect
