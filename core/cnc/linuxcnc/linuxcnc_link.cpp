#include "core/cnc/linuxcnc/linuxcnc_link.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/base/conversions.h"
#include "core/cnc/linuxcnc/hal_backend.h"
#include "core/cnc/linuxcnc/rsh_backend.h"

namespace stillcut::cnc {
namespace {

// Nothing is asked while an override's ACK is waited for, which takes 100 ms; a round of questions is a few ticks.
constexpr Seconds kPeriod{0.1};
constexpr Duration kFresh = std::chrono::milliseconds(500);
constexpr Duration kOpenTime = std::chrono::seconds(3);

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

std::unique_ptr<EmcBackend> makeBackend(const LinuxCncSettings& s, std::unique_ptr<ByteChannel> wire,
                                        const Clock& clock) {
  if (s.component.port > 0) return std::make_unique<HalBackend>(std::move(wire), s.adaptiveFeed, clock);
  return std::make_unique<RshBackend>(EmcSession(std::move(wire), s.password), s.controlPassword, clock);
}

}  // namespace

LinuxCncLink::LinuxCncLink(const LinuxCncSettings& settings, Wires wires, const Clock& clock)
    : settings_(settings),
      clock_(clock),
      backend_(makeBackend(settings, std::move(wires.control), clock)),
      watch_(std::move(wires.watch), settings.password),
      hal_(std::move(wires.hal), settings.password),
      overrides_{{settings.lowestSpeed, settings.highestSpeed}, {settings.lowestFeed, settings.highestFeed}},
      releaseBudget_(clock, kReleaseTime) {
  if (settings.inches) status_.machineUnit = kInch;
}

LinuxCncLink::~LinuxCncLink() {
  release(clock_.now());
}

void LinuxCncLink::close() noexcept {
  release(clock_.now());
  backend_->close();
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
  info.machineWatchdog = backend_->watchdog();
  info.period = kPeriod;
  return info;
}

Status LinuxCncLink::open() {
  const Instant began = clock_.now();
  const auto deaf = [&](const EmcSession& session, Message why) {
    return Error{std::string(session.address()), message("no answer"), std::move(why)};
  };
  while (true) {
    const Instant now = clock_.now();
    const MachineState seen = read(now);
    if (seen.valid && (settings_.component.port == 0 || backend_->up())) break;
    if (now - began > kOpenTime) {
      if (watch_.standing() != EmcSession::ConnectionState::Ready)
        return deaf(watch_, message("is linuxcncrsh running there?"));
      if (hal_.standing() != EmcSession::ConnectionState::Ready) return deaf(hal_, message("is halrmt running there?"));
      if (seen.valid) return backendFault();
      return Error{std::string(watch_.address()), message("the machine's state is incomplete"),
                   message("is spindle 0 configured?")};
    }
    hal_.wait(kWait);
  }
  close();  // the wires are taken up again by the thread that reads from now on
  return Done{};
}

Error LinuxCncLink::backendFault() const {
  const std::string where(backend_->address());
  if (!backend_->heard())
    return {where, message("no answer"), message("is stillcut-hal loaded by the machine's HAL file?")};
  return {where, message("the machine's watchdog was not seen to act"), message("is stillcut.hal wired as it came?")};
}

void LinuxCncLink::watchMachine(Instant now) noexcept {
  if (!backend_->speaking()) {
    goRound(watch_, kWatched, nextWatch_, status_, now, kWait, clock_, [&](Seconds s) { look_.take(s); });
    handsTurn_ = true;
  }
  goRound(hal_, kPins, nextHal_, status_, now, kWait, clock_, [](Seconds) {});
  if (watch_.standing() != EmcSession::ConnectionState::Ready) {
    overrides_.speed.lost();
    overrides_.feed.lost();
    return;
  }
  if (status_.spindleOverride.when == now) overrides_.speed.seen(status_.spindleOverride.value, now);
  if (status_.feedOverride.when == now) overrides_.feed.seen(status_.feedOverride.value, now);
}

void LinuxCncLink::command(Instant now) noexcept {
  backend_->turn(overrides_, wanted_, watch_.idle() && handsTurn_, status_, now);
  if (backend_->speaking()) handsTurn_ = false;
}

MachineState LinuxCncLink::read(Instant now) noexcept {
  watchMachine(now);
  command(now);
  const MachineState m = state(now);
  if (m.valid && backend_->up()) releaseBudget_.anew();
  return m;
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
  m.link.acknowledged = backend_->acknowledged();
  m.link.overrides = std::min({s.feedOverride.when, s.spindleOverride.when, s.commandedSpeed.when});
  m.link.speed = std::min(s.actualSpeed.when, s.atSpeed.when);
  m.link.feed = s.currentFeed.when;
  m.link.program = std::min({s.program.when, s.speedWord.when, s.machineOn.when});
  m.link.roundTrip = backend_->roundTrip().value > 0.0 ? backend_->roundTrip() : look_.typical();
  m.linkUp =
      watch_.standing() == EmcSession::ConnectionState::Ready && hal_.standing() == EmcSession::ConnectionState::Ready;
  m.valid = m.linkUp && all && now - m.time <= kFresh;
  if (!m.valid) return m;
  m.programRunning = s.machineOn.value && s.program.value != EmcProgram::Idle;
  m.feedHold = s.feedHold.value || s.program.value == EmcProgram::Paused;
  m.atSpeed = s.atSpeed.value;
  m.programmedSpeed = s.speedWord.value;
  m.programmedFeed = s.feedWord.value;
  m.operatorSpeed = overrides_.speed.base();
  m.operatorFeed = overrides_.feed.base();
  m.actualSpeed = s.actualSpeed.value;
  m.actualFeed = s.currentFeed.value;
  const bool turning = s.speedWord.value.value > 0.0 && s.commandedSpeed.value.value > 0.0;
  m.speedOverride =
      turning ? Ratio(s.commandedSpeed.value / s.speedWord.value) : Ratio(overrides_.speed.shown() * 0.01);
  checkEffect(m, now);
  m.block = block(m, now);
  return m;
}

// The overrides that are read back against the speed that is commanded and the path's own velocity.
void LinuxCncLink::checkEffect(MachineState& m, Instant now) noexcept {
  const double knob = overrides_.feed.shown() * 0.01;
  const double adaptive = status_.adaptiveFeed.ever ? std::max(0.0, status_.adaptiveFeed.value) : 1.0;
  if (m.programRunning) {
    speedLock_.look(overrides_.speed.shown() * 0.01, 1.0, m.speedOverride.value, now);
    if (m.programmedFeed.value > 0.0 && !m.feedHold) {
      const double moves = m.actualFeed / m.programmedFeed;
      feedLock_.look(knob * adaptive, adaptive, moves, now);
      adaptiveLock_.look(knob * adaptive, knob, moves, now);
    }
  } else {
    for (OverrideLockDetector* judge : {&speedLock_, &feedLock_, &adaptiveLock_}) judge->reset();
  }
  m.feedOverride = Ratio((feedLock_.locked() ? 1.0 : knob) * (adaptiveLock_.locked() ? 1.0 : adaptive));
  const bool feedLocked = feedLock_.locked() || (settings_.adaptiveFeed && adaptiveLock_.locked());
  m.overridesEnabled = !speedLock_.locked() && !feedLocked;
  m.controlOurs = backend_->block(now) == OverrideInhibit::None;
}

OverrideInhibit LinuxCncLink::block(const MachineState& m, Instant now) const noexcept {
  if (!status_.machineOn.value) return OverrideInhibit::MachineOff;
  if (!m.controlOurs) return backend_->block(now);
  if (!m.programRunning) return OverrideInhibit::NoProgram;
  const bool both = speedLock_.locked() && feedLock_.locked();
  if (both && !speedLock_.orLimit() && !feedLock_.orLimit()) return OverrideInhibit::OverridesLocked;
  if (speedLock_.locked()) return OverrideInhibit::SpeedLocked;
  if (feedLock_.locked()) return OverrideInhibit::FeedLocked;
  return m.overridesEnabled ? OverrideInhibit::None : OverrideInhibit::AdaptiveLocked;
}

void LinuxCncLink::apply(const OverrideCommand& command, Instant now) noexcept {
  wanted_ = command.kind() == CommandKind::Set;
  releaseBudget_.anew();
  overrides_.speed.want(wanted_ ? command.speed() : Ratio(1.0), command.engagement());
  const Ratio feed = wanted_ ? command.feed() : Ratio(1.0);
  overrides_.feed.want(settings_.adaptiveFeed ? Ratio(1.0) : feed, command.engagement());
  overrides_.adaptiveFeed = settings_.adaptiveFeed ? feed : Ratio(1.0);
  this->command(now);
}

void LinuxCncLink::release(Instant now) noexcept {
  wanted_ = false;
  overrides_.speed.relinquish();
  overrides_.feed.relinquish();
  overrides_.adaptiveFeed = Ratio(1.0);
  const auto up = [this] { return backend_->up() && watch_.standing() == EmcSession::ConnectionState::Ready; };
  const bool wasUp = up();
  releaseBudget_.run(
      now, kWait, [&] { return backend_->done(overrides_); },
      [&](Instant at) {
        watchMachine(at);
        command(at);
        backend_->wait(kWait);
        if (wasUp && !up()) releaseBudget_.giveUp();
      });
}

}  // namespace stillcut::cnc
