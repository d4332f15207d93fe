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

}  // namespace

RshBackend::RshBackend(EmcSession session, const std::string& controlPassword, const Clock& clock)
    : session_(std::move(session)), enable_("set enable " + controlPassword), clock_(clock) {}

bool RshBackend::done(const EmcOverrides& knobs) const noexcept {
  const bool nothingToDo = machineOff_ || (knobs.speed.atBase() && knobs.feed.atBase());
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

void RshBackend::next(EmcOverrides& knobs, bool wanted, Instant now) noexcept {
  const bool needed = !machineOff_ && (wanted || !knobs.speed.atBase() || !knobs.feed.atBase());
  if (!needed) {
    if (inControl_) ask(Asked::GiveBack, "set enable off", now);
    return;
  }
  if (lostAt_ && now - *lostAt_ < kLeaveIt) return;
  lostAt_.reset();
  if (!inControl_) return ask(Asked::Enable, enable_, now);
  if (!waitModeSet_) return ask(Asked::WaitMode, "set set_wait received", now);
  const auto speed = knobs.speed.due();
  const auto feed = knobs.feed.due();
  if (feed && (!speed || feedFirst(*feed, knobs.feed.shown()))) return set(Asked::Feed, knobs.feed, now);
  if (speed) return set(Asked::Speed, knobs.speed, now);
  ask(Asked::Standing, "get enable", now);
}

void RshBackend::reply(std::string_view line, EmcOverrides& knobs, EmcStatus& status, Instant now) noexcept {
  const bool no = line.find("NAK") != std::string_view::npos;
  switch (std::exchange(asked_, Asked::Nothing)) {
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
        // Not in control, or the machine is off: "get enable" tells which before anything is sent again.
        knobs.speed.refused();
        knobs.feed.refused();
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
