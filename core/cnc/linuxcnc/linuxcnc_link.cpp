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

constexpr Seconds kPeriod{0.2};  // of what moves: overrides and speeds
constexpr Duration kFresh = std::chrono::milliseconds(750);
constexpr Duration kWordsFresh = std::chrono::milliseconds(1500);  // program, S and F, machine on
constexpr Duration kOpenTime = std::chrono::seconds(3);

// linuxcncrsh splits the words of all its clients with one shared strtok: the less is asked, the longer it lives.
constexpr double kQuestionsPerSecond = 20.0;
constexpr double kMostAtOnce = 6.0;  // all five and one
constexpr Duration kOverridesEvery = std::chrono::milliseconds(200);
constexpr Duration kOthersEvery = std::chrono::milliseconds(500);
constexpr Duration kPinsEvery = std::chrono::milliseconds(25);  // halrmt, another server

constexpr std::array<std::string_view, 6> kPins{"get pinval spindle.0.speed-in", "get pinval spindle.0.speed-out",
                                                "get pinval spindle.0.at-speed", "get pinval motion.feed-hold",
                                                "get pinval motion.current-vel", "get pinval motion.adaptive-feed"};

// Asks each request once, as far as the answers come within `wait` each; `next` is 0 after the last.
template <std::size_t N>
void goRound(EmcSession& session, const std::array<std::string_view, N>& requests, std::size_t& next, EmcStatus& status,
             Instant now, Duration wait) noexcept {
  const auto take = [&](std::string_view line, bool) { status.take(line, now); };
  session.pump(now, take);
  do {
    if (!session.idle() || !session.ask(requests[next], now)) return;
    next = (next + 1) % N;
    session.wait(wait);
    session.pump(now, take);
  } while (next != 0);
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
      overrides_{{settings.lowestSpeed, settings.highestSpeed, kEmcManners},
                 {settings.lowestFeed, settings.highestFeed, kEmcManners}},
      // Always with the spindle's number: without it these requests crash the server, and the machine with it.
      questions_{{{"get feed_override", kOverridesEvery},
                  {"get spindle_override 0", kOverridesEvery},
                  {"get program_status", kOthersEvery},
                  {"get program_codes", kOthersEvery},
                  {"get machine", kOthersEvery}}},
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
  info.highestSpeed = Ratio(std::min(settings_.highestSpeed, backend_->highestSpeed()) * 0.01);
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
    return {where, message("no answer"),
            message("is stillcut-hal loaded by the machine's HAL file, and LinuxCNC started by this user?")};
  return {where, message("the machine's watchdog was not seen to act"), message("is stillcut.hal wired as it came?")};
}

bool LinuxCncLink::mayAsk(Instant now) noexcept {
  if (tokensAt_ == Instant{}) tokens_ = kMostAtOnce;
  tokens_ = std::min(kMostAtOnce, tokens_ + kQuestionsPerSecond * secondsBetween(tokensAt_, now).value);
  tokensAt_ = now;
  return tokens_ >= 1.0;
}

// The question that has waited longest for its turn, as a part of how often it is asked.
void LinuxCncLink::askOne(Instant now) noexcept {
  const auto lateness = [&](const Question& q) {
    return q.asked ? secondsBetween(*q.asked, now).value / toSeconds(q.every).value : 1e9;
  };
  const auto next = std::max_element(questions_.begin(), questions_.end(),
                                     [&](const Question& a, const Question& b) { return lateness(a) < lateness(b); });
  if (lateness(*next) < 1.0 || !mayAsk(now)) return;
  const Instant began = clock_.now();
  if (!watch_.ask(next->text, now)) return;
  tokens_ -= 1.0;
  next->asked = now;
  watch_.wait(kWait);
  watch_.pump(now, [&](std::string_view line, bool) { status_.take(line, now); });
  if (watch_.idle()) look_.take(secondsBetween(began, clock_.now()));
}

void LinuxCncLink::watchMachine(Instant now) noexcept {
  watch_.pump(now, [&](std::string_view line, bool) { status_.take(line, now); });
  // A hand without a connection connects in every other pause of the watch.
  yielded_ = !backend_->up() && watch_.idle() && !yielded_;
  const bool handFirst = yielded_ || (backend_->hasWord(overrides_, wanted_, now) && (!wanted_ || handsTurn_));
  if (!backend_->speaking() && !handFirst) {
    for (std::size_t i = 0; i < questions_.size() && watch_.idle(); ++i) {
      const double before = tokens_;
      askOne(now);
      if (tokens_ >= before) break;
    }
  }
  if (!halRound_ || nextHal_ != 0 || now - *halRound_ >= kPinsEvery) {
    if (nextHal_ == 0) halRound_ = now;
    goRound(hal_, kPins, nextHal_, status_, now, kWait);
  } else {
    hal_.pump(now, [&](std::string_view line, bool) { status_.take(line, now); });
  }
  if (watch_.standing() != EmcSession::ConnectionState::Ready) {
    overrides_.speed.lost();
    overrides_.feed.lost();
    for (Question& q : questions_) q.asked.reset();
    return;
  }
  const auto look = [now](SharedOverride& knob, const auto& read, Question& question) {
    if (read.when != now) return;
    knob.seen(read.value, now);
    if (knob.doubted()) question.asked.reset();  // the next reading decides, and is asked for at once
  };
  look(overrides_.feed, status_.feedOverride, questions_[0]);
  look(overrides_.speed, status_.spindleOverride, questions_[1]);
  readSinceHand_ += (status_.spindleOverride.when == now ? 1 : 0) + (status_.feedOverride.when == now ? 1 : 0);
  handsTurn_ = handsTurn_ || readSinceHand_ >= 2;
}

void LinuxCncLink::command(Instant now) noexcept {
  const bool wasSpeaking = backend_->speaking();
  backend_->turn(overrides_, wanted_, watch_.idle() && (!wanted_ || handsTurn_), status_, now);
  if (backend_->speaking()) {
    handsTurn_ = false;
    readSinceHand_ = 0;
  } else if (wasSpeaking) {  // what it did is looked at first
    questions_[0].asked.reset();
    questions_[1].asked.reset();
  }
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
  const std::initializer_list<Instant> moving{s.feedOverride.when, s.spindleOverride.when, s.actualSpeed.when,
                                              s.commandedSpeed.when, s.atSpeed.when};
  const bool all = s.feedOverride.ever && s.spindleOverride.ever && s.program.ever && s.speedWord.ever &&
                   s.machineOn.ever && s.actualSpeed.ever && s.commandedSpeed.ever && s.atSpeed.ever;
  m.time = std::min(moving);
  m.link.acknowledged = backend_->acknowledged();
  m.link.overrides = std::min({s.feedOverride.when, s.spindleOverride.when, s.commandedSpeed.when});
  m.link.speed = std::min(s.actualSpeed.when, s.atSpeed.when);
  m.link.feed = s.currentFeed.when;
  m.link.program = std::min({s.program.when, s.speedWord.when, s.machineOn.when});
  m.link.roundTrip = backend_->roundTrip().value > 0.0 ? backend_->roundTrip() : look_.typical();
  m.linkUp =
      watch_.standing() == EmcSession::ConnectionState::Ready && hal_.standing() == EmcSession::ConnectionState::Ready;
  // On a connection that is new what was read on the one before tells nothing of where they stand.
  const bool known = overrides_.speed.known() && overrides_.feed.known();
  m.valid = m.linkUp && all && known && now - m.time <= kFresh && now - m.link.program <= kWordsFresh;
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
        if (watch_.waiting()) {
          watch_.wait(kWait);
        } else {
          backend_->wait(kWait);
        }
        if (wasUp && !up()) releaseBudget_.giveUp();
      });
}

}  // namespace stillcut::cnc
