#include "core/cnc/grbl/grbl_link.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/base/conversions.h"
#include "core/cnc/move_order.h"

namespace stillcut::cnc {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
constexpr Duration kConnectTime = std::chrono::seconds(1);
// Until the next question, where one is not answered; twice the round trip where that is longer. grblHAL answers after
// 30 ms; a '?' may go unanswered.
constexpr Duration kLeastPatience = std::chrono::milliseconds(150);
constexpr Seconds kPeriod{0.2};        // one that went unanswered, and the answer to the next
constexpr Seconds kSenderPeriod{0.4};  // a sender asks every 250 ms
constexpr int kMostMissed = 4;
constexpr int kReadsAtOnce = 16;  // of 512 bytes: a peer may flood
constexpr Duration kWordsEvery = std::chrono::milliseconds(500);
constexpr Duration kFresh = std::chrono::milliseconds(500);
constexpr Duration kOpenTime = std::chrono::seconds(3);
// "Ov:" comes right after a change, and every 10 to 20 reports; a step that has not shown by then was lost.
constexpr Duration kShowsWithin = std::chrono::milliseconds(700);

}  // namespace

GrblLink::GrblLink(const GrblSettings& settings, std::unique_ptr<ByteChannel> wire, const Clock& clock)
    : settings_(settings), wire_(std::move(wire)), clock_(clock), releaseBudget_(clock, kReleaseTime) {}

GrblLink::~GrblLink() {
  release(clock_.now());
}

void GrblLink::close() noexcept {
  release(clock_.now());
  drop(clock_.now());
  speed_ = feed_ = Axis();
}

LinkInfo GrblLink::describe() const {
  LinkInfo info;
  info.id = "grbl";
  info.label = "GRBL";
  info.lowestSpeed = info.lowestFeed = Ratio(kGrblLowest * 0.01);
  info.highestSpeed = info.highestFeed = Ratio(kGrblHighest * 0.01);
  info.period = settings_.sender ? kSenderPeriod : kPeriod;
  return info;
}

Status GrblLink::open() {
  const Instant began = clock_.now();
  std::optional<Instant> heard;
  while (!read(clock_.now()).valid) {
    wire_->wait(kWait);
    const Instant now = clock_.now();
    if (ever_ && !heard) heard = now;
    if (starting(now) || now - heard.value_or(began) <= kOpenTime) continue;
    const bool opened = wire_->state() == WireState::Open;
    const Error why{std::string(wire_->address()),
                    opened ? message("no GRBL status report") : message("cannot be opened"),
                    opened             ? message("is this the controller's port, and the baud rate right?")
                    : settings_.sender ? message("is the sender running there, and connected to its machine?")
                                       : message("is it there, and free?")};
    drop(now);
    return why;
  }
  wire_->handOver();  // open, as it is
  return Done{};
}

Duration GrblLink::patience() const noexcept {
  return std::max(kLeastPatience, toDuration(2.0 * roundTrip_.typical()));
}

// The operator's values were seen, by an answer that knows of all that was sent.
bool GrblLink::confirmed() const noexcept {
  return settled_ && !speed_.adrift && !feed_.adrift && speed_.baseConfirmed() && feed_.baseConfirmed();
}

// Nothing that was known is: as after a connection that broke.
void GrblLink::forget() noexcept {
  pending_.clear();
  olderAnswers_ = 0;
  speed_.lost();
  feed_.lost();
  waiting_ = ever_ = wordsKnown_ = false;
  missed_ = 0;
}

void GrblLink::drop(Instant now) noexcept {
  wire_->close();
  splitter_.clear();
  forget();
  opened_.reset();
  nextTry_ = now + kRetry;
}

void GrblLink::keepUp(Instant now) noexcept {
  const WireState wire = wire_->state();
  if (wire == WireState::Opening && now >= nextTry_ - kRetry + kConnectTime) drop(now);
  if (wire != WireState::Closed) return;
  if (ever_ || waiting_ || opened_) drop(now);
  if (now < nextTry_) return;
  nextTry_ = now + kRetry;
  opened_ = now;
  wire_->connect();
}

void GrblLink::listen(Instant now) noexcept {
  std::array<char, 512> bytes;
  for (int i = 0; i < kReadsAtOnce; ++i) {
    const std::size_t n = wire_->read(bytes);
    splitter_.feed({bytes.data(), n}, [&](std::string_view line) {
      GrblReport report;
      switch (readGrblLine(line, report, words_)) {
        case GrblLine::Report:
          takeReport(report, now);
          break;
        case GrblLine::Words:
          wordsKnown_ = true;
          toldWords_ = now;
          break;
        case GrblLine::Welcome:  // overrides are back at 100 %
          speed_.restarted();
          feed_.restarted();
          break;
        case GrblLine::AlarmNote:
          report_.state = GrblState::Alarm;
          break;
        case GrblLine::Other:
          break;
      }
    });
    if (n < bytes.size()) break;
  }
}

void GrblLink::takeReport(const GrblReport& report, Instant now) noexcept {
  const Instant came = std::max(now, clock_.now());
  const std::optional<Instant> question = pending_.answered(came);
  if (question) roundTrip_.take(secondsBetween(*question, came));
  if (now - moved_ > PendingQuestions::kLongestTrip) olderAnswers_ = 0;
  const bool older = question && olderAnswers_ > 0;
  if (older) --olderAnswers_;
  // GRBL writes a report before it takes the steps that came with the question: only the answer to a later question
  // shows what was lost on the way.
  const bool sinceMove = question && !older;
  const bool sure = sinceMove && answersSinceMove_ > 0;
  if (sinceMove) ++answersSinceMove_;
  waiting_ = false;
  if (heard_ != Instant{} && now - heard_ > patience()) {
    for (Axis* axis : {&speed_, &feed_}) axis->blind(now - heard_, now);
  }
  missed_ = 0;
  ever_ = true;
  opened_.reset();
  heard_ = now;
  report_ = report;
  if (!report.speedOverride || older) return;
  if (sure) speed_.adrift = feed_.adrift = false;
  speed_.seen(*report.speedOverride, now);
  feed_.seen(*report.feedOverride, now);
  settled_ = settled_ || (speed_.settled() && feed_.settled());
  if (sure && !settled_) resynchronise();
  const bool stands = settled_ && !speed_.adrift && !feed_.adrift;
  if (!question || stands) shownAt_ = question.value_or(now);
}

void GrblLink::ask(Instant now) noexcept {
  if (waiting_ && now - asked_ <= patience()) return;
  if (waiting_ && !starting(now) && ++missed_ > kMostMissed) {
    if (!settings_.wire.host.empty()) return drop(now);
    forget();
  }
  waiting_ = true;
  asked_ = now;
  pending_.asked(std::max(now, clock_.now()));
  // A board that starts is asked by the byte that needs no line.
  const bool words = settings_.askWords && ever_ && now - askedWords_ > kWordsEvery;
  if (words) askedWords_ = now;
  if (!wire_->write(words ? "?$G\n" : "?")) drop(now);
}

// One step of a kind, then its "Ov:" is waited for: the next step is relative to where this one led.
void GrblLink::moveOverrides(Instant now) noexcept {
  if (!settled_ && now - moved_ <= kShowsWithin) return;
  if (!settled_) resynchronise();
  const bool feedGoesFirst = feedFirst(feed_.target(), feed_.shown());
  if (feedGoesFirst) move(feed_, kGrblFeedBytes, now);
  move(speed_, kGrblSpindleBytes, now);
  if (!feedGoesFirst) move(feed_, kGrblFeedBytes, now);
}

// What was sent has not shown: taken or lost, nobody knows, and a step from here could be one too many. 100 % has a
// byte of its own, which means the same however often it is taken. What shows and is nothing of ours may be a hand that
// came before the step was seen: the next reading decides, and nothing is sent over it until then.
void GrblLink::resynchronise() noexcept {
  for (Axis* axis : {&speed_, &feed_}) {
    if (axis->doubted()) continue;
    axis->adrift = axis->adrift || !axis->settled();
    axis->refused();
  }
  settled_ = true;
}

void GrblLink::move(Axis& knob, unsigned char firstByte, Instant now) noexcept {
  const auto target = knob.due();
  if (!target && !knob.adrift) return;
  // From an unknown place 100 % is the only one that can be gone to, and no way to an operator who is below it: then
  // the next "Ov:" is waited for.
  if (knob.adrift && (knob.doubted() || knob.base().value < 1.0)) return;
  GrblSteps steps = stepToward(target.value_or(100), knob.shown(), firstByte);
  if (knob.adrift) steps = {firstByte, 0, 100, 100, 100};
  std::array<char, 2> bytes{};
  std::size_t n = 0;
  for (const unsigned char byte : {steps.coarse, steps.fine}) {
    if (byte != 0) bytes[n++] = static_cast<char>(byte);
  }
  if (n == 0 || !wire_->write({bytes.data(), n})) return;
  for (const int part : {steps.coarseAlone, steps.fineAlone}) {
    if (part != steps.percent && part != knob.shown()) knob.sent(part, now);
  }
  knob.sent(steps.percent, now);
  knob.adrift = false;
  stepped(now);
}

// From here on only answers to later questions tell where the overrides stand.
void GrblLink::stepped(Instant now) noexcept {
  settled_ = false;
  answersSinceMove_ = 0;
  olderAnswers_ = pending_.count(now);
  moved_ = now;
}

void GrblLink::tick(Instant now) noexcept {
  keepUp(now);
  if (wire_->state() != WireState::Open) return;
  listen(now);
  moveOverrides(now);
  ask(now);
  wire_->wait(kWait);
  listen(now);
}

MachineState GrblLink::read(Instant now) noexcept {
  tick(now);
  const MachineState m = state(now);
  if (m.valid) releaseBudget_.anew();
  return m;
}

MachineState GrblLink::state(Instant now) const noexcept {
  MachineState m;
  m.time = heard_;
  m.linkUp = ever_ && wire_->state() == WireState::Open;
  m.link.overrides = shownAt_;
  if (report_.measuredSpeed) m.link.speed = heard_;
  m.link.feed = heard_;
  m.link.program = settings_.askWords ? std::min(heard_, toldWords_) : heard_;
  m.link.roundTrip = roundTrip_.typical();
  const GrblReport& r = report_;
  m.valid =
      m.linkUp && now - heard_ <= kFresh && speed_.known() && r.feed && r.speed && (wordsKnown_ || !settings_.askWords);
  if (starting(now) && wire_->state() == WireState::Open) m.block = OverrideInhibit::Starting;
  if (!m.valid) return m;
  m.programRunning = r.state == GrblState::Run || r.state == GrblState::Hold;
  m.feedHold = r.state == GrblState::Hold;
  if (r.state == GrblState::Alarm) m.block = OverrideInhibit::MachineAlarm;
  if (r.state == GrblState::Idle) m.block = OverrideInhibit::NoProgram;
  m.speedOverride = Ratio(speed_.shown() * 0.01);
  m.feedOverride = Ratio(feed_.shown() * 0.01);
  m.operatorSpeed = speed_.base();
  m.operatorFeed = feed_.base();
  const double perMinute = (settings_.inches ? kInch : 1e-3) / 60.0;
  m.actualFeed = MetresPerSecond(*r.feed * perMinute);
  m.actualSpeed = Rpm(r.measuredSpeed.value_or(0.0));
  if (wordsKnown_) {
    m.programmedSpeed = Rpm(words_.speed);
    m.programmedFeed = MetresPerSecond(words_.feed * (words_.inches ? kInch : 1e-3) / 60.0);
  } else {
    m.programmedSpeed = Rpm(*r.speed / m.speedOverride.value);
    m.programmedFeed = MetresPerSecond(*r.feed * perMinute / m.feedOverride.value);
  }
  m.atSpeed = *r.speed > 0.0;
  return m;
}

void GrblLink::apply(const OverrideCommand& command, Instant now) noexcept {
  const bool set = command.kind() == CommandKind::Set;
  releaseBudget_.anew();
  speed_.want(set ? command.speed() : Ratio(1.0), command.engagement());
  feed_.want(set ? command.feed() : Ratio(1.0), command.engagement());
  if (wire_->state() == WireState::Open) moveOverrides(now);
}

void GrblLink::release(Instant now) noexcept {
  // First: what is wanted and has not been sent yet would be sent after all.
  speed_.relinquish();
  feed_.relinquish();
  if (speed_.atBase() && feed_.atBase() && !speed_.adrift && !feed_.adrift) return;
  releaseBudget_.run(
      now, kWait, [&] { return confirmed(); }, [&](Instant at) { tick(at); });
  // Without any "Ov:" to go by, the bytes that mean 100 % are all that is left; not over an operator who chose less,
  // nor over what may be his hand.
  if (wire_->state() != WireState::Open || confirmed()) return;
  const auto toProgrammed = [&](Axis& axis, unsigned char byte) {
    if ((axis.baseConfirmed() && !axis.adrift) || axis.doubted() || axis.base().value < 1.0) return false;
    const char c = static_cast<char>(byte);
    if (!wire_->write({&c, 1})) return false;
    axis.sent(100, now);
    return true;
  };
  const bool feedSent = toProgrammed(feed_, kGrblFeedBytes);
  const bool speedSent = toProgrammed(speed_, kGrblSpindleBytes);
  if (feedSent || speedSent) stepped(now);
}

}  // namespace stillcut::cnc
