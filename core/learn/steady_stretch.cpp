#include "core/learn/steady_stretch.h"

#include <cmath>
#include <utility>

#include "core/model/judged_cut.h"

namespace stillcut::learn {

void StretchCollector::begin() {
  stretch_ = {};
  speedSum_ = 0.0;
  looks_ = 0;
}

void StretchCollector::add(const SampleBlock& block) {
  const bool follows = last_ && block.sequence == *last_ + 1 && !block.has(kBlockGap);
  if (!follows || block.rate != stretch_.rate || block.has(kBlockClipped)) begin();
  last_ = block.sequence;
  if (block.has(kBlockClipped)) return;
  stretch_.rate = block.rate;
  stretch_.channels.resize(channels_.size());
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    if (channels_[i] >= block.channels) continue;
    const auto samples = block.channel(channels_[i]);
    stretch_.channels[i].insert(stretch_.channels[i].end(), samples.begin(), samples.end());
  }
}

bool StretchCollector::look(const Verdict& verdict) {
  const double speed = 60.0 * verdict.spindle.value;
  const bool stable = judges(verdict) && verdict.state == CutState::Stable && verdict.kind != ChatterKind::Forced;
  const double mean = looks_ > 0 ? speedSum_ / looks_ : speed;
  if (!stable || !(speed > 0.0) || std::abs(speed - mean) > params_.speedChange * mean) {
    begin();
    return false;
  }
  speedSum_ += speed;
  ++looks_;
  return true;
}

std::optional<SteadyStretch> StretchCollector::take() {
  const bool any = looks_ > 0 && !stretch_.channels.empty();
  if (!any || static_cast<double>(stretch_.channels.front().size()) < params_.length.value * stretch_.rate.value) {
    return std::nullopt;
  }
  stretch_.speed = Rpm(speedSum_ / looks_);
  std::optional<SteadyStretch> taken(std::move(stretch_));
  begin();
  return taken;
}

}  // namespace stillcut::learn
