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
// An answer that takes longer than this is missing, as far as the way home goes.
constexpr Duration kNoAnswer = std::chrono::milliseconds(350);
// On the way home an order that has not shown for so long is given again: acknowledged is not obeyed.
constexpr Duration kGivenAgain = std::chrono::seconds(1);
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

RshBackend::SetOrder RshBackend::orderTo(Asked which, int percent) const noexcept {
  SetOrder order;
  char* end = order.text.data();
  const auto add = [&](std::string_view words) { end += words.copy(end, words.size()); };
  add(which == Asked::Feed ? "set feed_override "
      : percentFirst()     ? "set spindle_override "
                           : "set spindle_override 0 ");
  end = std::to_chars(end, order.text.data() + order.text.size(), percent).ptr;
  if (which == Asked::Speed && percentFirst()) add(" 0");
  order.size = static_cast<std::size_t>(end - order.text.data());
  return order;
}

void RshBackend::set(Asked what, SharedOverride& knob, Instant now) noexcept {
  const int percent = *knob.due();
  knob.sent(percent, now);
  setAt_ = std::max(now, clock_.now());
  ask(what, orderTo(what, percent).words(), now);
  if (asked_ == Asked::Nothing) knob.refused();
}

// On the way home an answer is missing. The server may hear all the same, so that what is left is said once without
// being asked back for: one override must not wait for the other's answer.
void RshBackend::lastWords(EmcOverrides& knobs, Instant now) noexcept {
  if (lastWordsSaid_ || !inControl_ || session_.waited(now) < kNoAnswer) return;
  lastWordsSaid_ = true;
  for (const auto& [which, knob] : {std::pair{Asked::Feed, &knobs.feed}, {Asked::Speed, &knobs.speed}}) {
    const auto percent = knob->due();
    if (!percent || *percent != knob->target()) continue;
    session_.add(orderTo(which, *percent).words());
    knob->sent(*percent, now);
  }
}

void RshBackend::turn(EmcOverrides& knobs, bool wanted, bool maySpeak, EmcStatus& status, Instant now) noexcept {
  machineOff_ = status.machineOn.ever && !status.machineOn.value;
  const bool answering = session_.waiting();
  if (!answering && !maySpeak) return;
  session_.pump(now, [&](std::string_view line, bool answers) {
    if (answers) reply(line, knobs, status, now);
  });
  if (status.decimals) order_ = WordOrder::PercentFirst;
  knobs.speed.cap(highestSpeed());
  if (!up()) {
    if (asked_ == Asked::Speed) knobs.speed.refused();
    if (asked_ == Asked::Feed) knobs.feed.refused();
    inControl_ = waitModeSet_ = false;
    asked_ = Asked::Nothing;
    order_ = WordOrder::Unknown;  // another one may answer next
    status.decimals = false;
    return;
  }
  if (!wanted) {
    for (SharedOverride* knob : {&knobs.speed, &knobs.feed}) {
      if (knob->unseen(now) > kGivenAgain) knob->refused();
    }
    lastWords(knobs, now);
  }
  if (!answering && session_.idle()) next(knobs, wanted, now);  // after an answer it is the watch's turn
}

bool RshBackend::Refusal::holds(Instant now) const {
  return at && now - *at < kRefusedFor;
}

bool RshBackend::dueNow(const SharedOverride& knob, const Refusal& refusal, Instant now) const noexcept {
  return knob.due().has_value() && !refusal.holds(now);
}

// Down from above 100 % it would be moved for good; and the feed does not move alone.
bool RshBackend::mayMove(const EmcOverrides& knobs) const noexcept {
  return !(percentFirst() && knobs.speed.base().value > 1.0 && knobs.speed.target() != knobs.speed.shown());
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
  const bool due = mayMove(knobs) && (dueNow(knobs.speed, speedRefused_, now) || dueNow(knobs.feed, feedRefused_, now));
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
  if (!waitModeSet_) {
    return ask(Asked::WaitMode, percentFirst() ? "set wait_mode received" : "set set_wait received", now);
  }
  if (!mayMove(knobs)) return;
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
  lastWordsSaid_ = false;
  switch (answered) {
    case Asked::Enable:
      inControl_ = !no;
      if (no) lose(OverrideInhibit::ControlRefused, now);
      break;
    case Asked::WaitMode:
      waitModeAnswered(no, line, now);
      break;
    case Asked::Speed:
      setAnswered(no, answered, knobs.speed, speedRefused_, now);
      break;
    case Asked::Feed:
      setAnswered(no, answered, knobs.feed, feedRefused_, now);
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

// A newer server warns of the old word, or does not know it. A NAK that repeats it knows it: we are not in control.
void RshBackend::waitModeAnswered(bool no, std::string_view line, Instant now) noexcept {
  const bool notKnown = no && (session_.complained() || line == "SET NAK");
  if (notKnown && percentFirst()) {
    waitModeSet_ = true;  // neither word: then each set waits until it is done
  } else if (notKnown) {
    order_ = WordOrder::PercentFirst;  // its own word next
  } else if (no) {
    ask(Asked::Standing, "get enable", now);
  } else {
    waitModeSet_ = true;
    if (order_ == WordOrder::Unknown) order_ = session_.warned() ? WordOrder::PercentFirst : WordOrder::SpindleFirst;
  }
}

void RshBackend::setAnswered(bool no, Asked which, SharedOverride& knob, Refusal& refusal, Instant now) noexcept {
  if (!no) {
    acknowledged_ = std::max(now, clock_.now());
    roundTrip_.take(secondsBetween(setAt_, acknowledged_));
    return;
  }
  knob.refused();
  // Old servers complain of nothing: this one has not understood.
  if (which == Asked::Speed && session_.complained() && !percentFirst()) {
    order_ = WordOrder::PercentFirst;
    return;
  }
  // Not in control, the machine is off, or just this one is not taken: "get enable" tells before more is sent.
  refusal.at = now;
  ask(Asked::Standing, "get enable", now);
}

}  // namespace stillcut::cnc
