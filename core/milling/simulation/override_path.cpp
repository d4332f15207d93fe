#include "core/milling/simulation/override_path.h"

#include <algorithm>
#include <cmath>

namespace stillcut::milling {

namespace {
Ratio shaped(Ratio wanted, Ratio lowest, Ratio highest, Ratio resolution) {
  double v = std::clamp(wanted.value, lowest.value, highest.value);
  if (resolution.value > 0.0)
    v = std::clamp(std::round(v / resolution.value) * resolution.value, lowest.value, highest.value);
  return Ratio(v);
}
}  // namespace

OverridePath::OverridePath(const OverrideSettings& settings, std::uint64_t seed) noexcept
    : settings_(settings), noise_(seed) {}

void OverridePath::command(Ratio speed, Ratio feed, Instant when) noexcept {
  if (!isFinite(speed) || !isFinite(feed)) return;
  const Seconds spread = settings_.longestDelay - settings_.shortestDelay;
  const Instant due = when + toDuration(settings_.shortestDelay + spread * noise_.uniform());
  if (count_ == kDepth) --count_;
  // One wire: what was sent later does not arrive earlier.
  lastDue_ = std::max(due, lastDue_);
  Pending& p = queue_[(first_ + count_) % kDepth];
  p.due = lastDue_;
  p.speed = shaped(speed, settings_.lowestSpeed, settings_.highestSpeed, settings_.resolution);
  p.feed = shaped(feed, settings_.lowestFeed, settings_.highestFeed, settings_.resolution);
  ++count_;
}

void OverridePath::advance(Instant now) noexcept {
  while (count_ > 0 && queue_[first_].due <= now) {
    speed_ = queue_[first_].speed;
    feed_ = queue_[first_].feed;
    first_ = (first_ + 1) % kDepth;
    --count_;
  }
}

}  // namespace stillcut::milling
