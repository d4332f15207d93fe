#include "core/cnc/remembering_link.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace stillcut::cnc {
namespace {

// Percent that an override may have moved between its last record and the kill.
constexpr int kMovedSince = 2;

int percentOf(Ratio r) noexcept {
  return isFinite(r) ? static_cast<int>(std::lround(100.0 * r.value)) : 0;
}

bool standsAsLeft(const SentOverride& left, Ratio inForce, bool onItsWay) noexcept {
  const int percent = percentOf(inForce);
  if (left.sent == left.base || percent == left.base) return false;
  const bool between = (percent > left.sent) != (percent > left.base);
  return std::abs(percent - left.sent) <= kMovedSince || (onItsWay && between);
}

bool isHome(const SentOverride& left, Ratio inForce) noexcept {
  return left.sent == left.base || percentOf(inForce) == left.base;
}

std::optional<Ratio> homeOf(const SentOverride& left) noexcept {
  return left.sent != left.base ? std::optional(Ratio(left.base * 0.01)) : std::nullopt;
}

SentOverride sentOn(Ratio base, Ratio ours) noexcept {
  return {percentOf(base), percentOf(Ratio(base.value * ours.value))};
}

}  // namespace

RememberingLink::RememberingLink(std::unique_ptr<CncLink> link, std::unique_ptr<OverrideMemory> memory,
                                 std::shared_ptr<SentOverridesCell> offered)
    : link_(std::move(link)), memory_(std::move(memory)), offered_(std::move(offered)), left_(memory_->left()) {}

MachineState RememberingLink::read(Instant now) noexcept {
  const MachineState m = link_->read(now);
  if (!m.valid) return m;
  if (left_ && !goingHome_) compare(m);
  watchHome(m);
  baseSpeed_ = m.operatorSpeed;
  baseFeed_ = m.operatorFeed;
  return m;
}

// At the first reading, and as long as it is offered: the operator may turn a knob before he answers. An override that
// no longer stands as it was left is his, and stays his.
// Of a machine that does not give both back, one that is read tells of the other.
void RememberingLink::compare(const MachineState& m) noexcept {
  const bool onItsWay = memory_->fresh();
  const bool speed = standsAsLeft(left_->speed, m.speedOverride, onItsWay);
  const bool feed = standsAsLeft(left_->feed, m.feedOverride, onItsWay);
  const bool notBoth = m.link.overrides == Instant{};
  if (!speed && !(notBoth && feed)) left_->speed.sent = left_->speed.base;
  if (!feed && !(notBoth && speed)) left_->feed.sent = left_->feed.base;
  if (left_->speed.sent == left_->speed.base && left_->feed.sent == left_->feed.base) {
    endOffer();
    memory_->forget();
    return;
  }
  offered_->set(left_);
}

void RememberingLink::endOffer() noexcept {
  left_.reset();
  offered_->set(std::nullopt);
  goingHome_ = false;
}

// Nothing of ours stands any more when what is in force is what the operator has.
void RememberingLink::watchHome(const MachineState& m) noexcept {
  if (inForce_) return;
  if (goingHome_) {
    if (!isHome(left_->speed, m.speedOverride) || !isHome(left_->feed, m.feedOverride)) return;
    endOffer();
    memory_->forget();
    return;
  }
  const bool home = percentOf(m.speedOverride) == percentOf(m.operatorSpeed) &&
                    percentOf(m.feedOverride) == percentOf(m.operatorFeed);
  if (!onRecord_ || !home) return;
  onRecord_.reset();
  memory_->forget();
}

void RememberingLink::apply(const OverrideCommand& command, Instant now) noexcept {
  if (command.kind() != CommandKind::Set) return release(now);
  inForce_ = true;
  if (left_) endOffer();  // what stands is what the operator goes on from
  const SentOverrides next{sentOn(baseSpeed_, command.speed()), sentOn(baseFeed_, command.feed())};
  if (onRecord_ != next) {
    onRecord_ = next;
    memory_->keep(next);
  }
  link_->apply(command, now);
}

void RememberingLink::release(Instant now) noexcept {
  inForce_ = false;
  if (left_ && offered_->get()) {
    goingHome_ = true;
    link_->adopt(homeOf(left_->speed), homeOf(left_->feed));
  }
  link_->release(now);
}

}  // namespace stillcut::cnc
