#include "core/cnc/linuxcnc/rsh_backend.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <utility>

#include "core/cnc/move_order.h"

namespace stillcut::cnc {
namespace {

// Another client took control: it keeps it at least this long, so that two programs do not fight over a machine.
constexpr Duration kLeaveIt = std::chrono::seconds(10);
// A refused override is tried again after so long.
constexpr Duration kRefusedFor = std::chrono::milliseconds(500);
// Whether control is still ours is asked so often while commands are given.
constexpr Duration kStandingEvery = std::chrono::milliseconds(500);

}  // namespace

RshBackend::RshBackend(EmcSession session, const std::string& controlPassword, const Clock& clock)
    : session_(std::move(session)), enable_("set enable " + controlPassword), clock_(clock) {}

bool RshBackend::done(const EmcOverrides& knobs) const noexcept {
  const bool nothingToDo = machineOff_ || (knobs.speed.baseConfirmed() && knobs.feed.baseConfirmed());
  return nothingToDo && asked_ == Asked::Nothing && !inControl_;
}

OverrideInhibit RshBackend::block(Instant now) const noexcept {
  return lostAt_ && now - *lostAt_ < kLeaveIt ? lostTo_ : OverrideInhibit::None;
}

void RshBackend::lose(OverrideInhibit to, Instant now) noexcept {
  inControl_ = waitModeSet_ = false;
  lostAt_ = now;
  lostTo_ = to;
}

void RshBackend::ask(Asked what, std::string_view request, Instant now) noexcept {
  asked_ = session_.ask(request, now) ? what : Asked::Nothing;
}

void RshBackend::set(Asked what, SharedOverride& knob, Instant now) noexcept {
  const int percent = *knob.due();
  const std::string_view form = what == Asked::Speed ? "set spindle_override 0 " : "set feed_override ";
  std::array<char, 48> request{};
  form.copy(request.data(), form.size());
  char* const digits = request.data() + form.size();
  const auto end = std::to_chars(digits, request.data() + request.size(), percent).ptr;
  knob.sent(percent, now);
  setAt_ = std::max(now, clock_.now());
  ask(what, {request.data(), static_cast<std::size_t>(end - request.data())}, now);
  if (asked_ == Asked::Nothing) knob.refused();
}

void RshBackend::turn(EmcOverrides& knobs, bool wanted, bool maySpeak, EmcStatus& status, Instant now) noexcept {
  machineOff_ = status.machineOn.ever && !status.machineOn.value;
  const bool answering = session_.waiting();
  if (!answering && !maySpeak) return;
  session_.pump(now, [&](std::string_view line) { reply(line, knobs, status, now); });
  if (!up()) {
    if (asked_ == Asked::Speed) knobs.speed.refused();
    if (asked_ == Asked::Feed) knobs.feed.refused();
    inControl_ = waitModeSet_ = false;
    asked_ = Asked::Nothing;
    return;
  }
  if (!answering && session_.idle()) next(knobs, wanted, now);  // after an answer it is the watch's turn
}

bool RshBackend::Refusal::holds(Instant now) const {
  return at && now - *at < kRefusedFor;
}

bool RshBackend::dueNow(const SharedOverride& knob, const Refusal& refusal, Instant now) const noexcept {
  return knob.due().has_value() && !refusal.holds(now);
}

bool RshBackend::needed(const EmcOverrides& knobs, bool wanted) const noexcept {
  return !machineOff_ && (wanted || !knobs.speed.baseConfirmed() || !knobs.feed.baseConfirmed());
}

bool RshBackend::leavesIt(Instant now) const noexcept {
  return lostAt_ && now - *lostAt_ < kLeaveIt;
}

bool RshBackend::hasWord(const EmcOverrides& knobs, bool wanted, Instant now) const noexcept {
  if (!up()) return false;
  if (!needed(knobs, wanted)) return inControl_;
  const bool due = dueNow(knobs.speed, speedRefused_, now) || dueNow(knobs.feed, feedRefused_, now);
  return !leavesIt(now) && (due || (wanted && !(inControl_ && waitModeSet_)));
}

void RshBackend::next(EmcOverrides& knobs, bool wanted, Instant now) noexcept {
  if (!needed(knobs, wanted)) {
    if (inControl_) ask(Asked::GiveBack, "set enable off", now);
    return;
  }
  if (leavesIt(now)) return;
  lostAt_.reset();
  if (!inControl_) return ask(Asked::Enable, enable_, now);
  if (!waitModeSet_) return ask(Asked::WaitMode, "set set_wait received", now);
  const bool speed = dueNow(knobs.speed, speedRefused_, now);
  const bool feed = dueNow(knobs.feed, feedRefused_, now);
  if (feed && (!speed || feedFirst(*knobs.feed.due(), knobs.feed.shown()))) return set(Asked::Feed, knobs.feed, now);
  if (speed) return set(Asked::Speed, knobs.speed, now);
  if (now - standingAsked_ < kStandingEvery) return;
  standingAsked_ = now;
  ask(Asked::Standing, "get enable", now);
}

void RshBackend::reply(std::string_view line, EmcOverrides& knobs, EmcStatus& status, Instant now) noexcept {
  const bool no = line.find("NAK") != std::string_view::npos;
  const Asked answered = std::exchange(asked_, Asked::Nothing);
  switch (answered) {
    case Asked::Enable:
      inControl_ = !no;
      if (no) lose(OverrideInhibit::ControlRefused, now);
      break;
    case Asked::WaitMode:
      waitModeSet_ = !no;
      break;
    case Asked::Speed:
    case Asked::Feed:
      if (!no) {
        acknowledged_ = std::max(now, clock_.now());
        roundTrip_.take(secondsBetween(setAt_, acknowledged_));
      } else {
        // Not in control, the machine is off, or just this one is not taken: "get enable" tells before more is sent.
        (answered == Asked::Speed ? knobs.speed : knobs.feed).refused();
        (answered == Asked::Speed ? speedRefused_ : feedRefused_).at = now;
        ask(Asked::Standing, "get enable", now);
      }
      break;
    case Asked::Standing:
      if (status.take(line, now) && !status.inControl.value) lose(OverrideInhibit::OtherClient, now);
      break;
    case Asked::GiveBack:
      inControl_ = waitModeSet_ = false;
      break;
    case Asked::Nothing:
      break;
  }
}

}  // namespace stillcut::cnc
