#include "core/cnc/shared_override.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace stillcut::cnc {
namespace {

// LinuxCNC was seen to take up to 4.7 s until a set shows. What has not shown by then is lost and sent again.
constexpr Duration kLatestEcho = std::chrono::seconds(6);

}  // namespace

int SharedOverride::target() const noexcept {
  const double wanted = std::round(base_ * factor_);
  return static_cast<int>(std::clamp(wanted, static_cast<double>(lowest_), static_cast<double>(highest_)));
}

bool SharedOverride::mayBeOurs(int percent, Instant now) const noexcept {
  const std::uint64_t kept = std::min<std::uint64_t>(sentCount_, sent_.size());
  for (std::uint64_t i = 0; i < kept; ++i) {
    const Sent& s = sent_[(sentCount_ - 1 - i) % sent_.size()];
    if (now - s.when > kLatestEcho) return false;
    if (s.percent == percent) return true;
  }
  return false;
}

bool SharedOverride::everSent(int percent) const noexcept {
  const std::uint64_t kept = std::min<std::uint64_t>(sentCount_, sent_.size());
  return std::any_of(sent_.begin(), sent_.begin() + static_cast<std::ptrdiff_t>(kept),
                     [percent](const Sent& s) { return s.percent == percent; });
}

void SharedOverride::seen(int percent, Instant now) noexcept {
  const bool stoodThere = std::exchange(rejoining_, false) && everSent(percent);
  if (underway_ && (*underway_ == percent || !mayBeOurs(*underway_, now))) underway_.reset();
  if (shown_ == percent) return;
  const bool first = !shown_ && sentCount_ == 0;
  shown_ = percent;
  if (first) base_ = percent;
  if (first || percent == target() || stoodThere || mayBeOurs(percent, now)) return;
  // Nobody here sent this: the operator's hand.
  grabbed_ = factor_ != 1.0;
  base_ = percent;
  factor_ = 1.0;
  sentCount_ = 0;
  underway_.reset();
}

void SharedOverride::want(Ratio factor, std::uint64_t engagement) noexcept {
  if (!isFinite(factor) || factor.value < 0.0) return;
  if (engagement != engagement_) {
    engagement_ = engagement;
    grabbed_ = false;
  }
  if (!grabbed_) factor_ = factor.value;
}

void SharedOverride::relinquish() noexcept {
  factor_ = 1.0;
}

std::optional<int> SharedOverride::due() const noexcept {
  if (!shown_) return std::nullopt;
  const int wanted = target();
  return underway_.value_or(*shown_) == wanted ? std::nullopt : std::optional(wanted);
}

void SharedOverride::sent(int percent, Instant now) noexcept {
  sent_[sentCount_ % sent_.size()] = {percent, now};
  ++sentCount_;
  underway_ = percent;
}

void SharedOverride::refused() noexcept {
  underway_.reset();
}

void SharedOverride::lost() noexcept {
  restarted();
  rejoining_ = true;
}

void SharedOverride::restarted() noexcept {
  shown_.reset();
  underway_.reset();
  rejoining_ = false;
}

}  // namespace stillcut::cnc
