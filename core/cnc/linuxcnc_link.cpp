#include "core/cnc/linuxcnc_link.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace stillcut::cnc {
namespace {

constexpr Duration kFresh = std::chrono::milliseconds(500);
constexpr Duration kOpenTime = std::chrono::seconds(3);
// A set is in force within 0.1 s of its ACK; a speed that stays at S for this long while the read-back says otherwise
// is locked by the program.
constexpr Duration kLockedAfter = std::chrono::milliseconds(1500);
// Another client took control: it keeps it at least this long, so that two programs do not fight over a machine.
constexpr Duration kLeaveIt = std::chrono::seconds(10);
constexpr double kSpeedRounding = 0.01;

// Always with the spindle's number: without it these requests crash the server, and the machine with it.
constexpr std::array<std::string_view, 5> kWatched{"get feed_override", "get spindle_override 0", "get program_status",
                                                   "get program_codes", "get machine"};
constexpr std::array<std::string_view, 6> kPins{"get pinval spindle.0.speed-in", "get pinval spindle.0.speed-out",
                                                "get pinval spindle.0.at-speed", "get pinval motion.feed-hold",
                                                "get pinval motion.current-vel", "get pinval motion.adaptive-feed"};

// Asks each request once, as far as the answers come within `wait` each.
template <std::size_t N>
void goRound(EmcSession& session, const std::array<std::string_view, N>& requests, std::size_t& next, EmcStatus& status,
             Instant now, Duration wait) noexcept {
  const auto take = [&](std::string_view line) { status.take(line, now); };
  session.pump(now, take);
  for (std::size_t i = 0; i < N && session.idle(); ++i) {
    if (!session.ask(requests[next], now)) return;
    next = (next + 1) % N;
    session.wait(wait);
    session.pump(now, take);
  }
}

}  // namespace

LinuxCncLink::LinuxCncLink(const LinuxCncSettings& settings, Wires wires, const Clock& clock)
    : settings_(settings),
      clock_(clock),
      control_(std::move(wires.control), settings.password),
      watch_(std::move(wires.watch), settings.password),
      hal_(std::move(wires.hal), settings.password),
      speed_(settings.lowestSpeed, settings.highestSpeed),
      feed_(settings.lowestFeed, settings.highestFeed),
      enable_("set enable " + settings.controlPassword) {}

LinuxCncLink::~LinuxCncLink() {
  release(clock_.now());
}

void LinuxCncLink::close() noexcept {
  release(clock_.now());
  for (EmcSession* session : {&control_, &watch_, &hal_}) session->close();
}

LinkInfo LinuxCncLink::describe() const {
  LinkInfo info;
  info.id = "linuxcnc";
  info.label = "LinuxCNC";
  info.lowestSpeed = Ratio(settings_.lowestSpeed * 0.01);
  info.highestSpeed = Ratio(settings_.highestSpeed * 0.01);
  info.lowestFeed = Ratio(settings_.lowestFeed * 0.01);
  info.highestFeed = Ratio(settings_.highestFeed * 0.01);
  return info;
}

Status LinuxCncLink::open() {
  const Instant began = clock_.now();
  const auto deaf = [&](const EmcSession& session, std::string why) {
    return Error{std::string(session.address()), "no answer", std::move(why)};
  };
  while (true) {
    const Instant now = clock_.now();
    const MachineState seen = read(now);
    if (seen.valid) break;
    if (now - began > kOpenTime) {
      if (watch_.standing() != EmcSession::Standing::Ready) return deaf(watch_, "is linuxcncrsh running there?");
      if (hal_.standing() != EmcSession::Standing::Ready) return deaf(hal_, "is halrmt running there?");
      return Error{std::string(watch_.address()), "the machine's state is incomplete", "is spindle 0 configured?"};
    }
    hal_.wait(kWait);
  }
  close();  // the wires are taken up again by the thread that reads from now on
  return Done{};
}

void LinuxCncLink::watchMachine(Instant now) noexcept {
  if (!control_.waiting()) goRound(watch_, kWatched, nextWatch_, status_, now, kWait);
  goRound(hal_, kPins, nextHal_, status_, now, kWait);
  if (watch_.standing() != EmcSession::Standing::Ready) {
    speed_.lost();
    feed_.lost();
    return;
  }
  if (status_.spindleOverride.when == now) speed_.seen(status_.spindleOverride.value, now);
  if (status_.feedOverride.when == now) feed_.seen(status_.feedOverride.value, now);
}

void LinuxCncLink::askCommand(Asked what, std::string_view request, Instant now) noexcept {
  asked_ = control_.ask(request, now) ? what : Asked::Nothing;
}

void LinuxCncLink::setOverride(Asked what, SharedKnob& knob, Instant now) noexcept {
  const int percent = *knob.due();
  const std::string_view form = what == Asked::Speed ? "set spindle_override 0 " : "set feed_override ";
  std::array<char, 48> request{};
  form.copy(request.data(), form.size());
  char* const digits = request.data() + form.size();
  const auto end = std::to_chars(digits, request.data() + request.size(), percent).ptr;
  knob.sent(percent, now);
  askCommand(what, {request.data(), static_cast<std::size_t>(end - request.data())}, now);
  if (asked_ == Asked::Nothing) knob.refused();
}

void LinuxCncLink::command(Instant now) noexcept {
  const bool answering = control_.waiting();
  if (!answering && !watch_.idle()) return;
  control_.pump(now, [&](std::string_view line) { commandReply(line, now); });
  if (control_.standing() != EmcSession::Standing::Ready) {
    if (asked_ == Asked::Speed) speed_.refused();
    if (asked_ == Asked::Feed) feed_.refused();
    inControl_ = waitModeSet_ = false;
    asked_ = Asked::Nothing;
    return;
  }
  if (answering || !control_.idle()) return;  // after an answer it is the watch's turn
  const bool needed = wanted_ || !speed_.home() || !feed_.home();
  if (!needed) {
    if (inControl_) askCommand(Asked::GiveBack, "set enable off", now);
    return;
  }
  if (lostAt_ && now - *lostAt_ < kLeaveIt) return;
  lostAt_.reset();
  if (!inControl_) return askCommand(Asked::Enable, enable_, now);
  if (!waitModeSet_) return askCommand(Asked::WaitMode, "set set_wait received", now);
  const auto speed = speed_.due();
  const auto feed = feed_.due();
  // A feed that falls goes before the speed, one that rises after it: never more feed per tooth on the way.
  if (feed && (!speed || *feed < feed_.shown())) return setOverride(Asked::Feed, feed_, now);
  if (speed) return setOverride(Asked::Speed, speed_, now);
  askCommand(Asked::Standing, "get enable", now);
}

void LinuxCncLink::commandReply(std::string_view line, Instant now) noexcept {
  const bool no = line.find("NAK") != std::string_view::npos;
  switch (std::exchange(asked_, Asked::Nothing)) {
    case Asked::Enable:
      inControl_ = !no;
      if (no) lostAt_ = now;
      break;
    case Asked::WaitMode:
      waitModeSet_ = !no;
      break;
    case Asked::Speed:
    case Asked::Feed:
      if (no) {
        // Not in control, or the machine is off: "get enable" tells which before anything is sent again.
        speed_.refused();
        feed_.refused();
        askCommand(Asked::Standing, "get enable", now);
      }
      break;
    case Asked::Standing:
      if (status_.take(line, now) && !status_.inControl.value) {
        inControl_ = waitModeSet_ = false;
        lostAt_ = now;
      }
      break;
    case Asked::GiveBack:
      inControl_ = waitModeSet_ = false;
      break;
    case Asked::Nothing:
      break;
  }
}

MachineState LinuxCncLink::read(Instant now) noexcept {
  watchMachine(now);
  command(now);
  return state(now);
}

MachineState LinuxCncLink::state(Instant now) noexcept {
  MachineState m;
  const EmcStatus& s = status_;
  const std::initializer_list<Instant> told{s.feedOverride.when,   s.spindleOverride.when, s.program.when,
                                            s.speedWord.when,      s.machineOn.when,       s.actualSpeed.when,
                                            s.commandedSpeed.when, s.atSpeed.when};
  const bool all = s.feedOverride.ever && s.spindleOverride.ever && s.program.ever && s.speedWord.ever &&
                   s.machineOn.ever && s.actualSpeed.ever && s.commandedSpeed.ever && s.atSpeed.ever;
  m.time = std::min(told);
  m.linkUp = watch_.standing() == EmcSession::Standing::Ready && hal_.standing() == EmcSession::Standing::Ready;
  m.valid = m.linkUp && all && now - m.time <= kFresh;
  if (!m.valid) return m;
  m.programRunning = s.machineOn.value && s.program.value != EmcProgram::Idle;
  m.feedHold = s.feedHold.value || s.program.value == EmcProgram::Paused;
  m.atSpeed = s.atSpeed.value;
  m.programmedSpeed = s.speedWord.value;
  m.programmedFeed = s.feedWord.value;
  m.operatorSpeed = speed_.base();
  m.operatorFeed = feed_.base();
  m.actualSpeed = s.actualSpeed.value;
  m.actualFeed = s.currentFeed.value;
  const bool turning = s.speedWord.value.value > 0.0 && s.commandedSpeed.value.value > 0.0;
  m.speedOverride = turning ? Ratio(s.commandedSpeed.value / s.speedWord.value) : Ratio(speed_.shown() * 0.01);
  m.feedOverride = Ratio(feed_.shown() * 0.01 * (s.adaptiveFeed.ever ? std::max(0.0, s.adaptiveFeed.value) : 1.0));
  m.controlOurs = !lostAt_ || now - *lostAt_ >= kLeaveIt;
  judgeEffect(m, now);
  return m;
}

// The override that is read back and the speed that is commanded say different things: at S itself the program has
// locked the override; anything else is the spindle's own range.
void LinuxCncLink::judgeEffect(MachineState& m, Instant now) noexcept {
  const double told = speed_.shown() * 0.01;
  const bool differs = m.programRunning && std::abs(told - 1.0) > kSpeedRounding &&
                       std::abs(m.speedOverride.value - 1.0) < 0.5 * kSpeedRounding;
  if (!differs) mismatch_.reset();
  if (differs && !mismatch_) mismatch_ = now;
  if (mismatch_ && now - *mismatch_ > kLockedAfter) locked_ = true;
  const bool followed =
      std::abs(told - 1.0) > kSpeedRounding && std::abs(m.speedOverride.value - told) < kSpeedRounding;
  if (!m.programRunning || followed) locked_ = false;
  m.overridesEnabled = !locked_;
}

void LinuxCncLink::apply(const OverrideCommand& command, Instant now) noexcept {
  wanted_ = command.kind() == CommandKind::Set;
  speed_.want(wanted_ ? command.speed() : Ratio(1.0), command.engagement());
  feed_.want(wanted_ ? command.feed() : Ratio(1.0), command.engagement());
  this->command(now);
}

void LinuxCncLink::release(Instant now) noexcept {
  wanted_ = false;
  speed_.letGo();
  feed_.letGo();
  // Counted, not only timed: a clock that stands still must not hold the program's end.
  for (Duration left = kReleaseTime; left > Duration::zero(); left -= kWait) {
    if (speed_.home() && feed_.home() && asked_ == Asked::Nothing && !inControl_) return;
    watchMachine(now);
    command(now);
    control_.wait(kWait);
    now = std::max(now, clock_.now());
  }
}

}  // namespace stillcut::cnc
