#include "app/hal/override_arbiter.h"

#include <algorithm>

namespace stillcut::hal {

using cnc::HalLeaseState;

void OverrideArbiter::enter(Stage stage, Instant now) noexcept {
  if (stage_ == Stage::Held) letGo_ = now;
  stage_ = stage;
  since_ = now;
  armed_ = false;
}

void OverrideArbiter::take(const cnc::HalRequest& request, int client, Instant now) noexcept {
  if (engaged() && client != holder_) return;
  if (client == lapsed_) {
    if (request.hold) return;
    lapsed_ = 0;
  }
  request_ = request;
  renewed_ = now;
  if (!request.hold) {
    end(now);
  } else if (stage_ == Stage::Home && now - since_ >= kRest) {
    holder_ = client;
    enter(Stage::Held, now);
  }
}

void OverrideArbiter::clientGone(int client, Instant now) noexcept {
  if (client == holder_) end(now);
}

void OverrideArbiter::end(Instant now) noexcept {
  if (engaged()) enter(Stage::Home, now);
}

void OverrideArbiter::prove(const ArbiterInputs& in, Instant now) noexcept {
  const Duration past = now - since_;
  switch (stage_) {
    case Stage::Resting:
      if (past >= kRetry) enter(Stage::Arming, now);
      break;
    case Stage::Arming:
      if (in.watchdogOk) {
        enter(Stage::Listening, now);
      } else if (past > kPatience) {
        enter(Stage::Resting, now);
      }
      break;
    case Stage::Listening:
      if (past > kLongestProof) {  // what is seen now may have come long after the time that is to be shown
        enter(Stage::Resting, now);
      } else if (!in.watchdogOk) {
        watchdogMs_ = std::max(1, static_cast<int>(past / std::chrono::milliseconds(1)));
        enter(Stage::Home, now);
      }
      break;
    default:
      break;
  }
}

void OverrideArbiter::hold(const ArbiterInputs& in, Instant now) noexcept {
  if (!engaged()) return;
  armed_ = armed_ || in.watchdogOk;
  const bool fell = armed_ ? !in.watchdogOk : now - since_ > kPatience;
  if (stage_ == Stage::Held && (fell || !in.permit)) {
    enter(Stage::Fallen, now);
  } else if (now - renewed_ > kLease) {
    if (stage_ == Stage::Fallen) lapsed_ = holder_;
    enter(Stage::Home, now);
  }
}

void OverrideArbiter::show(Instant now) noexcept {
  const bool held = stage_ == Stage::Held;
  pins_.active = held || stage_ == Stage::Arming || stage_ == Stage::Listening;
  if (pins_.active && stage_ != Stage::Listening && now - beat_ >= kShortestBeat) {
    pins_.heartbeat = !pins_.heartbeat;
    beat_ = now;
  }
  if (held) {
    pins_.speedEnable = request_.speed.has_value();
    pins_.feedEnable = request_.feed.has_value();
    tookSpeed_ = tookSpeed_ || pins_.speedEnable;
    tookFeed_ = tookFeed_ || pins_.feedEnable;
    pins_.speed = request_.speed.value_or(request_.restoreSpeed);
    pins_.feed = request_.feed.value_or(request_.restoreFeed);
    pins_.adaptiveFeed = request_.adaptiveFeed;
    pins_.restoreSpeed = request_.restoreSpeed;
    pins_.restoreFeed = request_.restoreFeed;
    return;
  }
  // On the way home the goal stays as it was; afterwards it follows the operator's knobs, and nobody looks.
  const bool onTheWay = (tookSpeed_ || tookFeed_) && now - letGo_ <= kRestoreTime;
  if (!onTheWay) {
    tookSpeed_ = tookFeed_ = false;
    pins_.restoreSpeed = request_.restoreSpeed;
    pins_.restoreFeed = request_.restoreFeed;
  }
  pins_.speedEnable = tookSpeed_;
  pins_.feedEnable = tookFeed_;
  pins_.speed = pins_.restoreSpeed;
  pins_.feed = pins_.restoreFeed;
  pins_.adaptiveFeed = 1.0;
}

const ArbiterPins& OverrideArbiter::tick(const ArbiterInputs& in, Instant now) noexcept {
  prove(in, now);
  hold(in, now);
  show(now);
  return pins_;
}

cnc::HalReport OverrideArbiter::report(int client) const noexcept {
  cnc::HalReport r;
  r.watchdogMs = watchdogMs_;
  r.speed = stage_ == Stage::Held ? pins_.speed : pins_.restoreSpeed;
  r.feed = stage_ == Stage::Held ? pins_.feed : pins_.restoreFeed;
  r.adaptiveFeed = stage_ == Stage::Held ? pins_.adaptiveFeed : 1.0;
  switch (stage_) {
    case Stage::Home:
      r.standing = client == lapsed_ ? HalLeaseState::Fallen : HalLeaseState::Home;
      break;
    case Stage::Held:
      r.standing = client == holder_ ? HalLeaseState::Held : HalLeaseState::Taken;
      break;
    case Stage::Fallen:
      r.standing = client == holder_ ? HalLeaseState::Fallen : HalLeaseState::Taken;
      break;
    default:
      break;
  }
  return r;
}

}  // namespace stillcut::hal
