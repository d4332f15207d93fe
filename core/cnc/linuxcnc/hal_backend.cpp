#include "core/cnc/linuxcnc/hal_backend.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/cnc/move_order.h"

namespace stillcut::cnc {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
constexpr Duration kPatience = std::chrono::milliseconds(300);
constexpr int kReadsAtOnce = 32;                              // of 256 bytes: a peer may flood
constexpr Duration kEvery = std::chrono::milliseconds(10);    // its lease is 60 ms
constexpr Duration kRenewal = std::chrono::milliseconds(20);  // where answers take longer than that

// halui sends a percentage when it changes, once; another program's order at the same moment can push it out.
constexpr Duration kShowsWithin = std::chrono::milliseconds(500);
constexpr Duration kNudge = std::chrono::milliseconds(60);  // it looks every 20 ms

int percentOf(Ratio r) {
  return static_cast<int>(std::lround(r.value * 100.0));
}

}  // namespace

HalBackend::HalBackend(std::unique_ptr<ByteChannel> channel, bool adaptiveFeed, const Clock& clock)
    : channel_(std::move(channel)), adaptiveFeed_(adaptiveFeed), clock_(clock) {}

bool HalBackend::up() const noexcept {
  return heard_ && report_.standing != HalLeaseState::Unproven;
}

OverrideInhibit HalBackend::block(Instant) const noexcept {
  if (!heard_) return OverrideInhibit::ComponentSilent;
  if (!up()) return OverrideInhibit::ComponentDown;
  if (report_.standing == HalLeaseState::Taken) return OverrideInhibit::OtherClient;
  return report_.standing == HalLeaseState::Fallen ? OverrideInhibit::ComponentOut : OverrideInhibit::None;
}

bool HalBackend::done(const EmcOverrides& knobs) const noexcept {
  // Without a connection the machine has gone home by itself; what another client holds is its own affair.
  const bool notOurs = report_.standing == HalLeaseState::Home || report_.standing == HalLeaseState::Taken;
  return !up() || (!left(knobs.speed) && !left(knobs.feed) && !last_.hold && notOurs);
}

void HalBackend::close() noexcept {
  channel_->close();
  splitter_.clear();
  heard_ = false;
  waitingFor_ = 0;
  last_ = {};
}

bool HalBackend::keepUp(Instant now) noexcept {
  switch (channel_->state()) {
    case WireState::Closed:
      if (heard_ || waitingFor_ > 0) close();
      if (now < nextTry_) return false;
      nextTry_ = now + kRetry;
      asked_ = now;
      channel_->connect();
      return false;
    case WireState::Opening:
      if (now - asked_ > kPatience) close();
      return false;
    case WireState::Open:
      if (waitingFor_ == 0 || now - unanswered_.front().sent <= kPatience) return true;
      close();
      return false;
  }
  return false;
}

void HalBackend::listen(Instant now) noexcept {
  std::array<char, 256> bytes;
  for (int i = 0; i < kReadsAtOnce; ++i) {
    const std::size_t n = channel_->read(bytes);
    splitter_.feed({bytes.data(), n}, [&](std::string_view line) {
      const auto report = readHalReport(line);
      if (!report) return;
      report_ = *report;
      heard_ = true;
      answered(std::max(now, clock_.now()));
    });
    if (n < bytes.size()) break;
  }
}

void HalBackend::answered(Instant now) noexcept {
  if (waitingFor_ == 0) return;
  const Unanswered request = unanswered_.front();
  std::move(unanswered_.begin() + 1, unanswered_.begin() + static_cast<std::ptrdiff_t>(waitingFor_),
            unanswered_.begin());
  --waitingFor_;
  roundTrip_.take(secondsBetween(request.sent, now));
  if (request.hold) acknowledged_ = now;
}

bool HalBackend::left(const SharedOverride& knob) {
  return knob.known() && knob.shown() != percentOf(knob.base());
}

bool HalBackend::arrived(const SharedOverride& knob) {
  return knob.grabbed() || !knob.known() || knob.shown() == knob.target();
}

// A feed that rises is given as far as the speed that shows bears it; a speed that does not show holds nothing up, nor
// does anything hold up the way home once we let go. halui itself takes a feed before a speed of the same line.
double HalBackend::feedBySpeed(const SharedOverride& speed, double wanted, double present) const noexcept {
  if (feedFirst(wanted, present) || arrived(speed) || speed_.nudging) return wanted;
  return std::max(present, std::min(wanted, wanted * speed.shown() / speed.target()));
}

// What to write. A knob that cannot be seen just now is not the operator's, and one that may be is not turned before
// the next reading has told: what was written stays (`kept`). Else the goal; and where that does not show, for a moment
// one per cent beside it, so that it changes.
std::optional<int> HalBackend::turn(SharedOverride& knob, Turned& turned, int target, std::optional<int> kept,
                                    Instant read, Instant now) noexcept {
  if (knob.grabbed()) return std::nullopt;
  if (!knob.known() || knob.doubted()) return kept;
  if (target != turned.goal || knob.shown() == target) turned = {target, turned.written, false, now};
  if (turned.nudging ? now - turned.since > kNudge : read - turned.since > kShowsWithin) {
    turned.nudging = !turned.nudging;
    turned.since = now;
  }
  const int percent = turned.nudging ? (target > 1 ? target - 1 : target + 1) : target;
  if (percent != turned.written || knob.due() == percent) knob.sent(percent, now);
  turned.written = percent;
  return percent;
}

void HalBackend::send(EmcOverrides& knobs, bool wanted, const EmcStatus& status, Instant now) noexcept {
  HalRequest r;
  // Let go of once both are seen to be home; held again where one is seen that is not.
  const bool onTheWay = report_.standing == HalLeaseState::Held && !(arrived(knobs.speed) && arrived(knobs.feed));
  const bool strayed = report_.standing == HalLeaseState::Home && (left(knobs.speed) || left(knobs.feed));
  r.hold = up() && (wanted || onTheWay || strayed);
  r.restoreSpeed = percentOf(knobs.speed.base());
  r.restoreFeed = percentOf(knobs.feed.base());
  const bool heeded = report_.standing != HalLeaseState::Fallen && report_.standing != HalLeaseState::Taken;
  if (r.hold && heeded) {  // fallen: not taken before we have let go
    r.speed = turn(knobs.speed, speed_, knobs.speed.target(), last_.speed, status.spindleOverride.when, now);
    const auto feed = [&](double goal, double present) {
      return wanted ? feedBySpeed(knobs.speed, goal, present) : goal;
    };
    if (adaptiveFeed_) {
      r.adaptiveFeed = feed(std::clamp(knobs.adaptiveFeed.value, 0.0, 1.0), last_.hold ? last_.adaptiveFeed : 1.0);
    } else {
      const double goal = feed(knobs.feed.target(), last_.feed ? feed_.goal : knobs.feed.shown());
      r.feed = turn(knobs.feed, feed_, static_cast<int>(goal), last_.feed, status.feedOverride.when, now);
    }
  }
  std::array<char, kHalLine> text{};
  wanted_ = wanted;
  asked_ = now;
  if (waitingFor_ < unanswered_.size()) unanswered_[waitingFor_++] = {std::max(now, clock_.now()), r.hold};
  if (!channel_->write(writeHalRequest(r, text))) return close();
  last_ = r;
}

void HalBackend::turn(EmcOverrides& knobs, bool wanted, bool, EmcStatus& status, Instant now) noexcept {
  if (!keepUp(now)) {
    knobs.speed.refused();
    knobs.feed.refused();
    return;
  }
  listen(now);
  const bool news = wanted != last_.hold || (wanted && (knobs.speed.due() || knobs.feed.due()));
  const bool letsGo = wanted_ && !wanted;
  const bool renews = last_.hold && now - asked_ >= kRenewal && waitingFor_ < unanswered_.size();
  if (waitingFor_ == 0 ? news || now - asked_ >= kEvery : letsGo || renews) send(knobs, wanted, status, now);
}

}  // namespace stillcut::cnc
