#include "core/cnc/modbus/rtu_bus.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace stillcut::cnc {
namespace {

constexpr double kBitsPerCharacter = 11.0;
constexpr double kSilentCharacters = 3.5;
constexpr Duration kShortestGap = std::chrono::microseconds(1750);  // from 19200 baud on
constexpr int kMostOwed = 3;                                        // a peer that has died owes nothing for ever
constexpr int kReadsAtOnce = 8;                                     // of 256 bytes: a peer may flood

Duration silence(int baud) {
  return std::max(kShortestGap, toDuration(Seconds(kSilentCharacters * kBitsPerCharacter / std::max(baud, 1))));
}

}  // namespace

RtuBus::RtuBus(const BusAddress& address, std::unique_ptr<ByteChannel> wire, const Clock& clock)
    : wire_(std::move(wire)),
      clock_(clock),
      unit_(address.unit),
      name_(std::string(wire_->address()) + " unit " + std::to_string(address.unit)),
      gap_(silence(address.wire.baud)),
      answerWithin_(toDuration(address.answerWithin)),
      receiver_(address.unit) {}

void RtuBus::connect() noexcept {
  close();
  wire_->connect();
  beQuiet(clock_.now());  // what was asked before it closed may still be answered
}

WireState RtuBus::state() noexcept {
  step();
  return wire_->state();
}

void RtuBus::close() noexcept {
  if (phase_ == Phase::Asked) owed_ = std::min(owed_ + 1, kMostOwed);
  wire_->close();
  receiver_.clear();
  question_.reset();
  held_.reset();
  reply_.reset();
  phase_ = Phase::Free;
}

bool RtuBus::ask(const RtuQuestion& question) noexcept {
  if (phase_ != Phase::Free || wire_->state() != WireState::Open) return false;
  question_ = question;
  phase_ = Phase::Due;
  since_ = clock_.now();
  step();
  return wire_->state() == WireState::Open;
}

bool RtuBus::read(RegisterTable table, int first, int count) noexcept {
  return ask(RtuQuestion::read(unit_, table, first, count));
}

bool RtuBus::write(RegisterTable table, int first, int count, const RegisterWords& words) noexcept {
  return ask(RtuQuestion::write(unit_, table, first, count, words));
}

std::optional<BusReply> RtuBus::take() noexcept {
  step();
  return std::exchange(reply_, std::nullopt);
}

void RtuBus::wait(Duration atMost) noexcept {
  const Instant end = clock_.now() + atMost;
  while (!reply_ && wire_->state() == WireState::Open) {
    const Duration left = end - clock_.now();
    if (left <= Duration::zero()) return;
    // Woken when the silence of a question is over, too: it must not wait for the next tick.
    wire_->wait(phase_ == Phase::Due ? std::min(left, gap_) : left);
    const Phase before = phase_;
    step();
    if (before == Phase::Quiet && phase_ == Phase::Free) return;
  }
  if (!reply_ && wire_->state() != WireState::Open) wire_->wait(atMost);
}

void RtuBus::step() noexcept {
  if (wire_->state() != WireState::Open) return;
  const Instant now = clock_.now();
  listen(now);
  switch (phase_) {
    case Phase::Due:
      sendWhenSilent(now);
      break;
    case Phase::Asked:
      waitForAnswer(now);
      break;
    case Phase::Quiet:
      endQuiet(now);
      break;
    case Phase::Free:
      break;
  }
}

void RtuBus::listen(Instant now) noexcept {
  std::array<char, 256> bytes;
  for (int i = 0; i < kReadsAtOnce; ++i) {
    const std::size_t n = wire_->read(bytes);
    if (n == 0) return;
    lastByte_ = now;
    receiver_.put({bytes.data(), n});
    while (const auto frame = receiver_.next()) takeFrame(*frame);
    if (n < bytes.size()) return;
  }
}

// Outside a question a frame is an answer that came too late: it is counted, and its content is not looked at.
void RtuBus::takeFrame(std::string_view frame) noexcept {
  if (phase_ != Phase::Asked || !question_->isAnsweredBy(frame)) {
    owed_ = std::max(0, owed_ - 1);
    return;
  }
  ++came_;
  held_ = question_->replyIn(frame);
}

void RtuBus::sendWhenSilent(Instant now) noexcept {
  const bool silent = now - lastByte_ >= gap_ || now - since_ >= answerWithin_;
  if (!silent) return;
  receiver_.clear();
  held_.reset();
  came_ = 0;
  phase_ = Phase::Asked;
  since_ = now;
  wire_->write(question_->bytes());  // one that fails closes the wire
}

void RtuBus::waitForAnswer(Instant now) noexcept {
  if (!held_) {
    if (now - since_ < answerWithin_) return;
    owed_ = std::min(owed_ + 1, kMostOwed);
    answer({});
    return beQuiet(now);
  }
  if (came_ > owed_) {  // all that was open has been answered, ours last
    owed_ = 0;
    return answer(*held_);
  }
  if (now - lastByte_ < answerWithin_ && now - since_ < 2 * answerWithin_) return;
  owed_ = 0;
  answer({.ok = false, .words = {}, .unsure = true});
}

void RtuBus::answer(const BusReply& reply) noexcept {
  reply_ = reply;
  question_.reset();
  held_.reset();
  phase_ = Phase::Free;
}

void RtuBus::beQuiet(Instant now) noexcept {
  phase_ = Phase::Quiet;
  since_ = now;
}

void RtuBus::endQuiet(Instant now) noexcept {
  const bool silent = now - lastByte_ >= gap_;
  const bool late = now - since_ >= answerWithin_;
  const bool flooded = now - since_ >= 2 * answerWithin_;
  if (flooded || (silent && (owed_ == 0 || late))) phase_ = Phase::Free;
}

}  // namespace stillcut::cnc
