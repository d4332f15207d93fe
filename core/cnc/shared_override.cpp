#include "core/cnc/shared_override.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace stillcut::cnc {
namespace {

// A reading that lies for longer is believed.
constexpr Duration kLongestLie = std::chrono::seconds(6);

}  // namespace

int SharedOverride::target() const noexcept {
  if (factor_ == 1.0) return base_;
  const int lowest = std::min(lowest_, base_), highest = std::max(std::min(highest_, cap_), base_);
  return static_cast<int>(
      std::clamp(std::round(base_ * factor_), static_cast<double>(lowest), static_cast<double>(highest)));
}

// Whether `percent` is what was sent and may show now. In order: the ones before it never will.
bool SharedOverride::takeEcho(int percent, Instant now) noexcept {
  const std::uint64_t kept = sentCount_ - std::min<std::uint64_t>(sentCount_, sent_.size());
  for (std::uint64_t i = std::max(manners_.inOrder ? unseen_ : firstOnBase_, kept); i < sentCount_; ++i) {
    const Sent& s = sent_[i % sent_.size()];
    if (s.percent != percent || now - s.when > manners_.latestEcho) continue;
    unseen_ = std::max(unseen_, i + 1);
    lateEchoShown_ = lateEchoShown_ || i < firstOnBase_;
    return true;
  }
  return false;
}

bool SharedOverride::sentOnBase(int percent) const noexcept {
  const std::uint64_t kept = sentCount_ - std::min<std::uint64_t>(sentCount_, sent_.size());
  for (std::uint64_t i = std::max(firstOnBase_, kept); i < sentCount_; ++i) {
    if (sent_[i % sent_.size()].percent == percent) return true;
  }
  return false;
}

void SharedOverride::seen(int percent, Instant now) noexcept {
  const bool stoodThere = std::exchange(rejoining_, false) && sentOnBase(percent);
  if (underway_ && (*underway_ == percent || now - sent_[(sentCount_ - 1) % sent_.size()].when > manners_.latestEcho)) {
    underway_.reset();
  }
  const bool echo = shown_ != percent && takeEcho(percent, now);  // unchanged it is no answer yet
  const bool first = !shown_ && nothingSent();
  if (first) base_ = percent;
  // A number that we want and have never sent is a hand that chose it.
  const bool wanted = percent == target() && (factor_ == 1.0 || sentOnBase(percent));
  const bool ours = first || shown_ == percent || wanted || stoodThere || echo;
  if (!ours && std::exchange(doubted_, percent) != percent) {
    timesDoubted_ = 0;
    doubtedOverOurs_ = factor_ != 1.0;
  }
  if (!ours && ++timesDoubted_ < manners_.sightings) return;
  doubted_.reset();
  timesDoubted_ = 0;
  if (ours) doubtedOverOurs_ = false;
  const int stood = shown_.value_or(percent);
  shown_ = percent;
  if (ours || undoHand(percent, now)) return;
  if (manners_.sightings > 1 && !nothingSent())
    beforeHand_ = BeforeHand{stood, base_, factor_, grabbed_, firstOnBase_, now};
  takeHand(percent);
}

bool SharedOverride::undoHand(int percent, Instant now) noexcept {
  if (!beforeHand_ || beforeHand_->shown != percent || now - beforeHand_->taken > kLongestLie) return false;
  base_ = beforeHand_->base;
  firstOnBase_ = beforeHand_->firstOnBase;
  if (grabbed_ && !beforeHand_->grabbed) factor_ = beforeHand_->factor;
  grabbed_ = beforeHand_->grabbed;
  beforeHand_.reset();
  return true;
}

// Nobody here sent this: the operator's hand. What is still on its way may show up after it; then it is sent home to
// what the hand chose.
void SharedOverride::takeHand(int percent) noexcept {
  // A hand that turns twice has not given way, nor has one that is believed as our factor passes 100 %.
  grabbed_ = grabbed_ || factor_ != 1.0 || std::exchange(doubtedOverOurs_, false);
  base_ = percent;
  factor_ = 1.0;
  firstOnBase_ = sentCount_;
  if (!underway_ || !manners_.lateAfterHand) unseen_ = sentCount_;
  lateEchoShown_ = false;
  underway_.reset();
}

void SharedOverride::want(Ratio factor, std::uint64_t engagement) noexcept {
  if (!isFinite(factor) || factor.value < 0.0) return;
  if (engagement != engagement_) {
    engagement_ = engagement;
    grabbed_ = doubtedOverOurs_ = false;
  }
  if (!grabbed_) factor_ = factor.value;
  if (beforeHand_) beforeHand_->factor = factor.value;
}

void SharedOverride::relinquish() noexcept {
  factor_ = 1.0;
  if (beforeHand_) beforeHand_->factor = 1.0;
}

std::optional<int> SharedOverride::due() const noexcept {
  if (!shown_ || doubted_) return std::nullopt;
  const int wanted = target();
  return underway_.value_or(*shown_) == wanted ? std::nullopt : std::optional(wanted);
}

void SharedOverride::sent(int percent, Instant now) noexcept {
  sent_[sentCount_ % sent_.size()] = {percent, now};
  ++sentCount_;
  underway_ = percent;
}

void SharedOverride::blind(Duration time, Instant now) noexcept {
  for (Sent& s : sent_) s.when = std::min(s.when + time, now);
}

void SharedOverride::refused() noexcept {
  underway_.reset();
}

void SharedOverride::adopt(Ratio base) noexcept {
  if (!shown_ || !nothingSent() || !isFinite(base)) return;
  base_ = static_cast<int>(std::lround(100.0 * base.value));
  sent(*shown_, Instant{});
  underway_.reset();  // it has shown long since
  unseen_ = sentCount_;
}

void SharedOverride::lost() noexcept {
  restarted();
  rejoining_ = true;
}

void SharedOverride::restarted() noexcept {
  shown_.reset();
  underway_.reset();
  doubted_.reset();
  doubtedOverOurs_ = false;
  rejoining_ = false;
  unseen_ = sentCount_;
}

}  // namespace stillcut::cnc
