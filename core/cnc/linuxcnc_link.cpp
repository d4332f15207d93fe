#include "core/cnc/linuxcnc_link.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/cnc/hal_hand.h"
#include "core/cnc/rsh_hand.h"

namespace stillcut::cnc {
namespace {

constexpr Duration kFresh = std::chrono::milliseconds(500);
constexpr Duration kOpenTime = std::chrono::seconds(3);
// A set is in force within 0.1 s of its ACK; a speed that stays at S for this long while the read-back says otherwise
// is locked by the program.
constexpr Duration kLockedAfter = std::chrono::milliseconds(1500);
constexpr double kSpeedRounding = 0.01;

// Always with the spindle's number: without it these requests crash the server, and the machine with it.
constexpr std::array<std::string_view, 5> kWatched{"get feed_override", "get spindle_override 0", "get program_status",
                                                   "get program_codes", "get machine"};
constexpr std::array<std::string_view, 6> kPins{"get pinval spindle.0.speed-in", "get pinval spindle.0.speed-out",
                                                "get pinval spindle.0.at-speed", "get pinval motion.feed-hold",
                                                "get pinval motion.current-vel", "get pinval motion.adaptive-feed"};

// Asks each request once, as far as the answers come within `wait` each.
template <std::size_t N, class Answered>
void goRound(EmcSession& session, const std::array<std::string_view, N>& requests, std::size_t& next, EmcStatus& status,
             Instant now, Duration wait, const Clock& clock, Answered&& answered) noexcept {
  const auto take = [&](std::string_view line) { status.take(line, now); };
  session.pump(now, take);
  for (std::size_t i = 0; i < N && session.idle(); ++i) {
    const Instant asked = clock.now();
    if (!session.ask(requests[next], now)) return;
    next = (next + 1) % N;
    session.wait(wait);
    session.pump(now, take);
    if (session.idle()) answered(secondsBetween(asked, clock.now()));
  }
}

std::unique_ptr<EmcHand> makeHand(const LinuxCncSettings& s, std::unique_ptr<ByteChannel> wire, const Clock& clock) {
  if (s.component.port > 0) return std::make_unique<HalHand>(std::move(wire), s.adaptiveFeed, clock);
  return std::make_unique<RshHand>(EmcSession(std::move(wire), s.password), s.controlPassword, clock);
}

}  // namespace

LinuxCncLink::LinuxCncLink(const LinuxCncSettings& settings, Wires wires, const Clock& clock)
    : settings_(settings),
      clock_(clock),
      hand_(makeHand(settings, std::move(wires.control), clock)),
      watch_(std::move(wires.watch), settings.password),
      hal_(std::move(wires.hal), settings.password),
      knobs_{{settings.lowestSpeed, settings.highestSpeed}, {settings.lowestFeed, settings.highestFeed}} {
  if (settings.inches) status_.machineUnit = 0.0254;
}

LinuxCncLink::~LinuxCncLink() {
  release(clock_.now());
}

void LinuxCncLink::close() noexcept {
  release(clock_.now());
  hand_->close();
  for (EmcSession* session : {&watch_, &hal_}) session->close();
}

LinkInfo LinuxCncLink::describe() const {
  LinkInfo info;
  info.id = "linuxcnc";
  info.label = "LinuxCNC";
  info.lowestSpeed = Ratio(settings_.lowestSpeed * 0.01);
  info.highestSpeed = Ratio(settings_.highestSpeed * 0.01);
  info.lowestFeed = Ratio(settings_.lowestFeed * 0.01);
  info.highestFeed = Ratio(settings_.adaptiveFeed ? 1.0 : settings_.highestFeed * 0.01);
  info.machineWatchdog = hand_->watchdog();
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
    if (seen.valid && (settings_.component.port == 0 || hand_->up())) break;
    if (now - began > kOpenTime) {
      if (watch_.standing() != EmcSession::Standing::Ready) return deaf(watch_, "is linuxcncrsh running there?");
      if (hal_.standing() != EmcSession::Standing::Ready) return deaf(hal_, "is halrmt running there?");
      if (seen.valid) return handFault();
      return Error{std::string(watch_.address()), "the machine's state is incomplete", "is spindle 0 configured?"};
    }
    hal_.wait(kWait);
  }
  close();  // the wires are taken up again by the thread that reads from now on
  return Done{};
}

Error LinuxCncLink::handFault() const {
  const std::string where(hand_->address());
  if (!hand_->heard()) return {where, "no answer", "is stillcut-hal loaded by the machine's HAL file?"};
  return {where, "the machine's watchdog was not seen to act", "is stillcut.hal wired as it came?"};
}

void LinuxCncLink::watchMachine(Instant now) noexcept {
  if (!hand_->speaking()) {
    goRound(watch_, kWatched, nextWatch_, status_, now, kWait, clock_, [&](Seconds s) { look_.take(s); });
    handsTurn_ = true;
  }
  goRound(hal_, kPins, nextHal_, status_, now, kWait, clock_, [](Seconds) {});
  if (watch_.standing() != EmcSession::Standing::Ready) {
    knobs_.speed.lost();
    knobs_.feed.lost();
    return;
  }
  if (status_.spindleOverride.when == now) knobs_.speed.seen(status_.spindleOverride.value, now);
  if (status_.feedOverride.when == now) knobs_.feed.seen(status_.feedOverride.value, now);
}

void LinuxCncLink::command(Instant now) noexcept {
  hand_->turn(knobs_, wanted_, watch_.idle() && handsTurn_, status_, now);
  if (hand_->speaking()) handsTurn_ = false;
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
  m.link.acknowledged = hand_->acknowledged();
  m.link.overrides = std::min({s.feedOverride.when, s.spindleOverride.when, s.commandedSpeed.when});
  m.link.speed = std::min(s.actualSpeed.when, s.atSpeed.when);
  m.link.feed = s.currentFeed.when;
  m.link.program = std::min({s.program.when, s.speedWord.when, s.machineOn.when});
  m.link.roundTrip = hand_->roundTrip().value > 0.0 ? hand_->roundTrip() : look_.typical();
  m.linkUp = watch_.standing() == EmcSession::Standing::Ready && hal_.standing() == EmcSession::Standing::Ready;
  m.valid = m.linkUp && all && now - m.time <= kFresh;
  if (!m.valid) return m;
  m.programRunning = s.machineOn.value && s.program.value != EmcProgram::Idle;
  m.feedHold = s.feedHold.value || s.program.value == EmcProgram::Paused;
  m.atSpeed = s.atSpeed.value;
  m.programmedSpeed = s.speedWord.value;
  m.programmedFeed = s.feedWord.value;
  m.operatorSpeed = knobs_.speed.base();
  m.operatorFeed = knobs_.feed.base();
  m.actualSpeed = s.actualSpeed.value;
  m.actualFeed = s.currentFeed.value;
  const bool turning = s.speedWord.value.value > 0.0 && s.commandedSpeed.value.value > 0.0;
  m.speedOverride = turning ? Ratio(s.commandedSpeed.value / s.speedWord.value) : Ratio(knobs_.speed.shown() * 0.01);
  m.feedOverride =
      Ratio(knobs_.feed.shown() * 0.01 * (s.adaptiveFeed.ever ? std::max(0.0, s.adaptiveFeed.value) : 1.0));
  m.controlOurs = hand_->ours(now);
  judgeEffect(m, now);
  return m;
}

// The override that is read back and the speed that is commanded say different things: at S itself the program has
// locked the override; anything else is the spindle's own range.
void LinuxCncLink::judgeEffect(MachineState& m, Instant now) noexcept {
  const double told = knobs_.speed.shown() * 0.01;
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
  knobs_.speed.want(wanted_ ? command.speed() : Ratio(1.0), command.engagement());
  const Ratio feed = wanted_ ? command.feed() : Ratio(1.0);
  knobs_.feed.want(settings_.adaptiveFeed ? Ratio(1.0) : feed, command.engagement());
  knobs_.adaptiveFeed = settings_.adaptiveFeed ? feed : Ratio(1.0);
  this->command(now);
}

void LinuxCncLink::release(Instant now) noexcept {
  wanted_ = false;
  knobs_.speed.letGo();
  knobs_.feed.letGo();
  knobs_.adaptiveFeed = Ratio(1.0);
  // Timed and counted: neither a slow round nor a clock that stands still may hold the program's end.
  const Instant end = clock_.now() + kReleaseTime;
  for (Duration left = kReleaseTime; left > Duration::zero() && clock_.now() < end; left -= kWait) {
    if (hand_->done(knobs_)) return;
    watchMachine(now);
    command(now);
    hand_->wait(kWait);
    now = std::max(now, clock_.now());
  }
}

}  // namespace stillcut::cnc
