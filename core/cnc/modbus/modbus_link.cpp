#include "core/cnc/modbus/modbus_link.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "core/cnc/modbus/plausible.h"
#include "core/cnc/move_order.h"

namespace stillcut::cnc {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
constexpr Duration kConnectTime = std::chrono::seconds(1);
constexpr Duration kOverdue = std::chrono::milliseconds(300);  // of a bus that may wait three answers' time
constexpr Duration kOpenTime = std::chrono::seconds(3);
constexpr Duration kFreshAtLeast = std::chrono::milliseconds(300);
constexpr int kMostFailures = 3;
constexpr Duration kRefusedFor = std::chrono::milliseconds(100);  // and then it is written again
constexpr double kAtSpeed = 0.02;                                 // share of the target
constexpr double kHeartbeatSpan = 32768.0;
constexpr double kReadBefore = 0.8;                           // of its period
constexpr Duration kHeartbeatGone = std::chrono::seconds(1);  // another master's, and four of its periods at least

constexpr std::array<MachineCommand, 3> kStanding{MachineCommand::Control, MachineCommand::FeedOverride,
                                                  MachineCommand::SpeedOverride};

bool isFlag(MachineCommand o) {
  return o == MachineCommand::Control;
}
std::string shortest(double value) {
  std::array<char, 32> text{};
  const int size = std::snprintf(text.data(), text.size(), "%.6g", value);
  return {text.data(), static_cast<std::size_t>(std::clamp(size, 0, 31))};
}

}  // namespace

ModbusLink::ModbusLink(RegisterMap map, std::unique_ptr<RegisterBus> bus, const Clock& clock)
    : map_(std::move(map)), plan_(map_), bus_(std::move(bus)), clock_(clock), releaseBudget_(clock, kReleaseTime) {
  order(MachineCommand::SpeedOverride).wanted = 100.0;
  order(MachineCommand::FeedOverride).wanted = 100.0;
}

ModbusLink::~ModbusLink() {
  release(clock_.now());
}

LinkInfo ModbusLink::describe() const {
  LinkInfo info;
  info.id = "modbus";
  info.label = map_.label;
  info.machineWatchdog = map_.watchdog;
  info.lowestSpeed = map_.lowestSpeed;
  info.highestSpeed = map_.highestSpeed;
  const bool feed = map_.at(MachineCommand::FeedOverride).has_value();
  info.lowestFeed = feed ? map_.lowestFeed : Ratio(1.0);
  info.highestFeed = feed ? map_.highestFeed : Ratio(1.0);
  // The register that is read least often, and its wait behind all the others.
  for (const auto& r : map_.read) {
    if (r) info.period = std::max(info.period, r->period);
  }
  info.period += toSeconds(kWait) * static_cast<double>(kMachineSignals + kMachineCommands);
  return info;
}

Status ModbusLink::open() {
  const Instant began = clock_.now();
  while (!read(clock_.now()).valid) {
    bus_->wait(kWait);
    if (clock_.now() - began <= kOpenTime) continue;
    const bool connected = bus_->state() == WireState::Open;
    if (connected && refused_) {
      return Error{std::string(bus_->address()),
                   message("'%1' reads %2, which can not be", name(refused_->which), shortest(refused_->value)),
                   message("is its entry in the register map right?")};
    }
    if (connected && isSlow()) {
      const double answer_ms = 1e3 * roundTrip_.typical().value;
      return Error{std::string(bus_->address()),
                   message("an answer takes %1 ms, and %2 of them tell all: it is too old by then", shortest(answer_ms),
                           std::to_string(plan_.questions())),
                   message("a shorter way to the machine, or registers that lie side by side")};
    }
    return Error{std::string(bus_->address()),
                 connected ? message("the registers do not answer") : message("no connection"),
                 connected ? message("are the unit, the register map and its answer_ms right?")
                           : message("is the machine on, and the address right?")};
  }
  close();  // taken up again by the thread that reads from now on
  return Done{};
}

// So that not all of it is ever fresh at once.
bool ModbusLink::isSlow() const noexcept {
  return roundTrip_.typical() * static_cast<double>(plan_.questions()) > toSeconds(kFreshAtLeast);
}

void ModbusLink::close() noexcept {
  release(clock_.now());
  bus_->close();
  broke(clock_.now());
  plan_.putTogether();
  nextTry_ = {};
}

void ModbusLink::broke(Instant now) noexcept {
  underway_ = Underway::Nothing;
  failures_ = 0;
  nextTry_ = now + kRetry;
  for (RegisterReading& s : seen_) s = RegisterReading{};
  heartbeats_.lost();
  fastest_ = 0.0;
  for (RegisterWrite& o : orders_) {
    o.written.reset();
    o.sure = false;
  }
}

void ModbusLink::pump(Instant now) noexcept {
  switch (bus_->state()) {
    case WireState::Closed:
      if (underway_ != Underway::Nothing || seen_[0].ever()) broke(now);
      if (now < nextTry_) return;
      nextTry_ = now + kRetry;
      bus_->connect();
      return;
    case WireState::Opening:
      if (now < nextTry_ - kRetry + kConnectTime) return;
      bus_->close();
      broke(now);
      return;
    case WireState::Open:
      break;
  }
  // A request that is not even given up: Qt's client was seen to wait for ever on a port whose device had gone.
  const bool stuck =
      underway_ != Underway::Nothing && now - askedAt_ > 3 * toDuration(map_.bus.answerWithin) + kOverdue;
  if (stuck) {
    bus_->close();
    broke(now);
    return;
  }
  for (int i = 0; i < kRequests; ++i) {
    takeReply(now);
    if (bus_->busy() || bus_->state() != WireState::Open) return;
    // In command every second question at least is a reading, if one is due: with a heartbeat that is due again with
    // every answer nothing would ever be read on a slow wire. What lets go waits for no reading.
    const bool readFirst = inCommand_ && wroteLast_;
    if (!(readFirst && readNext(now)) && !writeNext(now) && !readNext(now)) return;
    bus_->wait(kWait);
  }
  takeReply(now);
}

void ModbusLink::takeReply(Instant now) noexcept {
  const auto reply = bus_->take();
  if (!reply || underway_ == Underway::Nothing) return;
  const Underway what = std::exchange(underway_, Underway::Nothing);
  if (reply->unsure) {
    if (what == Underway::Read) seen_[which_].due = now;
    return;
  }
  if (!reply->ok && what == Underway::Read && plan_.asksForSeveral(which_)) {
    plan_.takeApart();
    for (RegisterReading& s : seen_) s.due = now;
  }
  if (!reply->ok) {
    if (what == Underway::Write) orders_[which_].notBefore = now + kRefusedFor;
    // One exception is the machine's business; several in a row are a machine that cannot be believed.
    if (++failures_ < kMostFailures) return;
    bus_->close();
    broke(now);
    return;
  }
  failures_ = 0;
  const Instant answered = std::max(now, clock_.now());
  roundTrip_.take(secondsBetween(askedAt_, answered));
  if (what == Underway::Read) {
    takeReading(*reply, now);
  } else {
    orders_[which_].written = writing_;
    orders_[which_].sure = true;
    if (static_cast<MachineCommand>(which_) != MachineCommand::Heartbeat) acknowledged_ = answered;
  }
}

void ModbusLink::takeReading(const BusReply& reply, Instant now) noexcept {
  const ReadSpan& span = plan_.of(which_);
  for (std::size_t s = 0; s < kMachineSignals; ++s) {
    if (!span.has(s)) continue;
    const auto at = static_cast<std::size_t>(map_.read[s]->address - span.first);
    RegisterWords words{reply.words[at], 0};
    if (map_.read[s]->words == 2) words[1] = reply.words[at + 1];
    takeValue(static_cast<MachineSignal>(s), words, now);
  }
}

void ModbusLink::takeValue(MachineSignal s, const RegisterWords& words, Instant now) noexcept {
  const Register& r = *map_.at(s);
  RegisterReading& reading = seen_[static_cast<std::size_t>(s)];
  const double value = isFlag(s) ? (r.flag(words) ? 1.0 : 0.0) : r.decode(words);
  if (!canBe(map_, s, value, fastest_)) {
    refused_ = Refused{s, value};
    return;
  }
  if (refused_ && refused_->which == s) refused_.reset();
  if (s == MachineSignal::Heartbeat) heartbeats_.seen(value, now);
  if (!reading.take(value, jumpOf(s, number(programmedOf(s), 0.0)), now)) {
    reading.due = now;  // again, at once: the next reading decides
  } else if (s == MachineSignal::ProgrammedSpeed) {
    fastest_ = std::max(fastest_, value);
  }
}

bool ModbusLink::write(MachineCommand which, Instant now) noexcept {
  const auto& r = map_.at(which);
  RegisterWrite& o = order(which);
  const auto words = r->encode(o.wanted);
  if (!words) return false;  // outside what the register can hold: nothing is sent
  writing_ = o.wanted;
  which_ = static_cast<std::size_t>(which);
  underway_ = Underway::Write;
  wroteLast_ = true;
  o.when = now;
  askedAt_ = std::max(now, clock_.now());
  touched_ = true;
  o.sure = false;
  if (which == MachineCommand::Heartbeat) {
    heartbeats_.sent(o.wanted);
    // Read again just before the next one goes out: another master's stands there by then.
    seen_[static_cast<std::size_t>(MachineSignal::Heartbeat)].due = now + toDuration(r->period * kReadBefore);
  }
  if (bus_->write(r->table, r->address, r->words, *words)) return true;
  broke(now);
  return false;
}

bool ModbusLink::writeNext(Instant now) noexcept {
  if (!inCommand_ && !touched_) return false;
  // First: what is ordered without a heartbeat a watchdog takes back. Never twice with an order waiting.
  if (inCommand_ && !beatLast_ && beat(now)) return true;
  const bool beatLast = std::exchange(beatLast_, false);
  const RegisterWrite& feed = order(MachineCommand::FeedOverride);
  std::array<MachineCommand, 3> sequence = kStanding;
  if (!feedFirst(feed.wanted, feed.written.value_or(feed.wanted))) std::swap(sequence[1], sequence[2]);
  for (const MachineCommand o : sequence) {
    if (!map_.at(o) || stands(o, order(o).wanted) || now < order(o).notBefore) continue;
    if (isFlag(o) && !inCommand_ && !atBase()) continue;  // control is given back last
    if (write(o, now)) return true;
  }
  if (!inCommand_) {
    touched_ = !atBase() || (map_.at(MachineCommand::Control) && !stands(MachineCommand::Control, 0.0));
    return false;
  }
  return beatLast && beat(now);
}

bool ModbusLink::beat(Instant now) noexcept {
  const auto& beat = map_.at(MachineCommand::Heartbeat);
  RegisterWrite& heart = order(MachineCommand::Heartbeat);
  if (!beat || now - heart.when < toDuration(beat->period)) return false;
  // From where this computer's clock says: two programs that begin at once do not count in step.
  if (heart.when == Instant{}) heart.wanted = static_cast<double>(toNs(clock_.now()) / 1'000'000 % 32749);
  heart.wanted = std::fmod(heart.wanted + 1.0, kHeartbeatSpan);
  beatLast_ = true;
  return write(MachineCommand::Heartbeat, now);
}

bool ModbusLink::readNext(Instant now) noexcept {
  std::size_t oldest = kMachineSignals;
  for (std::size_t i = 0; i < kMachineSignals; ++i) {
    if (!map_.read[i] || seen_[i].due > now) continue;
    if (oldest == kMachineSignals || seen_[i].due < seen_[oldest].due) oldest = i;
  }
  if (oldest == kMachineSignals) return false;
  const ReadSpan& span = plan_.of(oldest);
  for (std::size_t s = 0; s < kMachineSignals; ++s) {
    if (span.has(s)) seen_[s].due = now + toDuration(map_.read[s]->period);
  }
  wroteLast_ = false;
  which_ = oldest;
  underway_ = Underway::Read;
  askedAt_ = std::max(now, clock_.now());
  if (bus_->read(span.table, span.first, span.count)) return true;
  broke(now);
  return false;
}

MachineState ModbusLink::read(Instant now) noexcept {
  pump(now);
  const MachineState m = state(now);
  if (m.valid) releaseBudget_.anew();
  return m;
}

Instant ModbusLink::readAt(std::initializer_list<MachineSignal> of) const noexcept {
  std::optional<Instant> oldest;
  for (const MachineSignal s : of) {
    if (!map_.at(s)) continue;
    const Instant when = seen(s).when();
    oldest = std::min(oldest.value_or(when), when);
  }
  return oldest.value_or(Instant{});
}

double ModbusLink::number(MachineSignal s, double otherwise) const noexcept {
  return map_.at(s) ? seen(s).value() : otherwise;
}

MachineState ModbusLink::state(Instant now) const noexcept {
  MachineState m;
  bool fresh = true;
  bool any = false;
  m.time = now;
  for (std::size_t i = 0; i < kMachineSignals; ++i) {
    if (!map_.read[i]) continue;
    const Duration allowed = std::max(kFreshAtLeast, 4 * toDuration(map_.read[i]->period));
    fresh = fresh && seen_[i].ever() && now - seen_[i].when() <= allowed;
    any = any || seen_[i].ever();
    m.time = std::min(m.time, seen_[i].when());
  }
  m.linkUp = any;
  m.link.acknowledged = acknowledged_;
  const bool believed = (map_.at(MachineCommand::SpeedOverride) && !map_.at(MachineSignal::SpeedOverride)) ||
                        (map_.at(MachineCommand::FeedOverride) && !map_.at(MachineSignal::FeedOverride));
  if (!believed) m.link.overrides = readAt({MachineSignal::SpeedOverride, MachineSignal::FeedOverride});
  m.link.speed = readAt({MachineSignal::ActualSpeed, MachineSignal::AtSpeed});
  m.link.feed = readAt({MachineSignal::ActualFeed});
  m.link.program = readAt({MachineSignal::ProgrammedSpeed, MachineSignal::Running, MachineSignal::FeedHold});
  m.link.roundTrip = roundTrip_.typical();
  m.valid = any && fresh;
  if (!m.valid) return m;
  m.programmedSpeed = Rpm(number(MachineSignal::ProgrammedSpeed, 0.0));
  m.actualSpeed = Rpm(std::abs(number(MachineSignal::ActualSpeed, 0.0)));
  m.programmedFeed = fromMmPerMin(number(MachineSignal::ProgrammedFeed, 0.0));
  m.actualFeed = fromMmPerMin(number(MachineSignal::ActualFeed, 0.0));
  m.operatorSpeed = Ratio(number(MachineSignal::OperatorSpeed, 100.0) * 0.01);
  m.operatorFeed = Ratio(number(MachineSignal::OperatorFeed, 100.0) * 0.01);
  const double speed = order(MachineCommand::SpeedOverride).written.value_or(100.0) * m.operatorSpeed.value;
  const double feed = order(MachineCommand::FeedOverride).written.value_or(100.0) * m.operatorFeed.value;
  m.speedOverride = Ratio(number(MachineSignal::SpeedOverride, speed) * 0.01);
  m.feedOverride = Ratio(number(MachineSignal::FeedOverride, feed) * 0.01);
  m.programRunning = flag(MachineSignal::Running, m.programmedSpeed.value > 0.0);
  m.feedHold = flag(MachineSignal::FeedHold, false);
  const double target = m.targetSpeed().value;
  m.atSpeed = flag(MachineSignal::AtSpeed, std::abs(m.actualSpeed.value - target) <= kAtSpeed * target);
  m.overridesEnabled = flag(MachineSignal::OverridesEnabled, true);
  m.controlOurs = !anotherMaster(now);
  if (!m.controlOurs) m.block = OverrideInhibit::OtherClient;
  return m;
}

bool ModbusLink::anotherMaster(Instant now) const noexcept {
  if (!map_.at(MachineSignal::Heartbeat)) return false;
  return heartbeats_.anothers(now,
                              std::max(kHeartbeatGone, 4 * toDuration(map_.at(MachineCommand::Heartbeat)->period)));
}

void ModbusLink::apply(const OverrideCommand& command, Instant now) noexcept {
  inCommand_ = command.kind() == CommandKind::Set;
  releaseBudget_.anew();
  order(MachineCommand::Control).wanted = inCommand_ ? 1.0 : 0.0;
  order(MachineCommand::SpeedOverride).wanted = inCommand_ ? 100.0 * command.speed().value : 100.0;
  order(MachineCommand::FeedOverride).wanted = inCommand_ ? 100.0 * command.feed().value : 100.0;
  pump(now);
}

bool ModbusLink::stands(MachineCommand which, double value) const noexcept {
  return order(which).sure && order(which).written == value;
}

bool ModbusLink::atBase() const noexcept {
  for (const MachineCommand o : {MachineCommand::SpeedOverride, MachineCommand::FeedOverride}) {
    if (map_.at(o) && !stands(o, 100.0)) return false;
  }
  return true;
}

void ModbusLink::release(Instant now) noexcept {
  inCommand_ = false;
  order(MachineCommand::Control).wanted = 0.0;
  order(MachineCommand::SpeedOverride).wanted = order(MachineCommand::FeedOverride).wanted = 100.0;
  releaseBudget_.run(
      now, kWait, [&] { return !touched_; },
      [&](Instant at) {
        pump(at);
        bus_->wait(kWait);
      });
}

}  // namespace stillcut::cnc
