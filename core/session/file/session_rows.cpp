#include "core/session/file/session_rows.h"

#include <map>
#include <sstream>

namespace stillcut::record {
namespace {

// A field added to the model must be added to its row as well, or a replay would differ from the cut.
static_assert(sizeof(MachineState) == 152 && sizeof(Verdict) == 176 && sizeof(OverrideRequest) == 72 &&
                  sizeof(CommandRecord) == 96 && sizeof(Event) == 64 && sizeof(OperatorInput) == 24,
              "record the new field in session_rows, raise kSessionVersion, then change this line");

Reason fromRow(const ReasonRow& row) {
  return {static_cast<ReasonCode>(row.code), row.n};
}
ReasonRow toRow(const Reason& reason) {
  return {static_cast<std::uint16_t>(reason.code), reason.n};
}

constexpr std::uint8_t byte(bool b) {
  return b ? 1 : 0;
}
template <class E>
constexpr std::uint8_t byte(E value) {
  return static_cast<std::uint8_t>(value);
}

// Only enumerations whose names are looked up by index need a check.
constexpr bool known(std::uint8_t value, CutState) {
  return value <= static_cast<std::uint8_t>(CutState::Chatter);
}
constexpr bool known(std::uint8_t value, CutPhase) {
  return value <= static_cast<std::uint8_t>(CutPhase::Exit);
}
constexpr bool known(std::uint8_t value, ChatterKind) {
  return value <= static_cast<std::uint8_t>(ChatterKind::Forced);
}
constexpr bool known(std::uint8_t value, Authority) {
  return value <= static_cast<std::uint8_t>(Authority::Auto);
}

template <class E>
bool take(std::uint8_t value, E& out) {
  if (!known(value, E{})) return false;
  out = static_cast<E>(value);
  return true;
}

}  // namespace

std::string reasonIdentifiers() {
  std::string all(identifier(ReasonCode::None));
  for (std::uint16_t code = 1;; ++code) {
    const std::string_view id = identifier(static_cast<ReasonCode>(code));
    if (id == identifier(ReasonCode::None)) return all;  // the end of what there is
    all.append("\n").append(id);
  }
}

ReasonCodes::ReasonCodes(const std::string& identifiers) {
  std::map<std::string, ReasonCode> known;
  std::istringstream mine(reasonIdentifiers());
  std::string id;
  for (std::uint16_t code = 0; std::getline(mine, id); ++code) known.emplace(id, static_cast<ReasonCode>(code));
  std::istringstream stored(identifiers);
  while (std::getline(stored, id)) {
    const auto found = known.find(id);
    codes_.push_back(found != known.end() ? found->second : ReasonCode::None);
  }
}

ReasonCode ReasonCodes::fromFile(ReasonCode stored) const {
  const auto index = static_cast<std::size_t>(stored);
  return index < codes_.size() ? codes_[index] : ReasonCode::None;
}

BlockRow toRow(const SampleBlock& b, std::uint64_t offset) {
  return {b.sequence, toNs(b.firstSample), b.rate.value, b.lostFrames, offset, b.source, b.frames, b.flags};
}

void fromRow(const BlockRow& row, SampleBlock& b) {
  b.sequence = row.sequence;
  b.firstSample = instantFromNs(row.firstSample);
  b.rate = Hertz(row.rate);
  b.lostFrames = row.lostFrames;
  b.source = row.source;
  b.frames = row.frames;
  b.flags = row.flags;
}

MachineRow toRow(const MachineState& m) {
  return {toNs(m.time),           byte(m.valid),           byte(m.linkUp),           byte(m.programRunning),
          byte(m.feedHold),       byte(m.atSpeed),         byte(m.overridesEnabled), byte(m.controlOurs),
          byte(m.block),          m.programmedSpeed.value, m.programmedFeed.value,   m.operatorSpeed.value,
          m.operatorFeed.value,   m.speedOverride.value,   m.feedOverride.value,     m.actualSpeed.value,
          m.actualFeed.value,     m.endedEngagement,       toNs(m.link.commanded),   toNs(m.link.acknowledged),
          toNs(m.link.overrides), toNs(m.link.speed),      toNs(m.link.feed),        toNs(m.link.program),
          m.link.roundTrip.value, m.link.effect.value};
}

void fromRow(const MachineRow& row, MachineState& m) {
  m.time = instantFromNs(row.time);
  m.valid = row.valid != 0;
  m.linkUp = row.linkUp != 0;
  m.programRunning = row.programRunning != 0;
  m.feedHold = row.feedHold != 0;
  m.atSpeed = row.atSpeed != 0;
  m.overridesEnabled = row.overridesEnabled != 0;
  m.controlOurs = row.controlOurs != 0;
  m.block = row.block < kOverrideInhibits ? static_cast<OverrideInhibit>(row.block) : OverrideInhibit::None;
  m.programmedSpeed = Rpm(row.programmedSpeed);
  m.programmedFeed = MetresPerSecond(row.programmedFeed);
  m.operatorSpeed = Ratio(row.operatorSpeed);
  m.operatorFeed = Ratio(row.operatorFeed);
  m.speedOverride = Ratio(row.speedOverride);
  m.feedOverride = Ratio(row.feedOverride);
  m.actualSpeed = Rpm(row.actualSpeed);
  m.actualFeed = MetresPerSecond(row.actualFeed);
  m.endedEngagement = row.endedEngagement;
  m.link.commanded = instantFromNs(row.commanded);
  m.link.acknowledged = instantFromNs(row.acknowledged);
  m.link.overrides = instantFromNs(row.overridesRead);
  m.link.speed = instantFromNs(row.speedRead);
  m.link.feed = instantFromNs(row.feedRead);
  m.link.program = instantFromNs(row.programRead);
  m.link.roundTrip = Seconds(row.roundTrip);
  m.link.effect = Seconds(row.effectDelay);
}

DecisionRow toRow(const StepOutput& o) {
  const OverrideRequest& r = o.request;
  return {toNs(r.time), byte(r.kind),  byte(r.claimsSpeed), byte(r.claimsFeed), byte(o.authority),
          o.inCharge,   r.speed.value, r.feed.value,        toRow(r.reason)};
}

bool fromRow(const DecisionRow& row, StepOutput& o) {
  OverrideRequest& r = o.request;
  r.time = instantFromNs(row.time);
  r.kind = static_cast<RequestKind>(row.kind);
  r.claimsSpeed = row.claimsSpeed != 0;
  r.claimsFeed = row.claimsFeed != 0;
  r.speed = Rpm(row.speed);
  r.feed = MetresPerSecond(row.feed);
  r.reason = fromRow(row.reason);
  o.inCharge = row.inCharge;
  return take(row.authority, o.authority) && row.inCharge >= 0 && row.inCharge < kMaxDetectors;
}

InputRow toRow(const OperatorInput& i, std::uint64_t step) {
  return {step, byte(i.action), byte(i.authority), i.advice, i.parameter, i.value};
}

bool fromRow(const InputRow& row, OperatorInput& i) {
  i.action = static_cast<OperatorAction>(row.action);
  i.advice = row.advice;
  i.parameter = row.parameter;
  i.value = row.value;
  return take(row.authority, i.authority);
}

VerdictRow toRow(const Verdict& v, int detector, std::uint64_t step) {
  return {step,
          detector,
          toNs(v.time),
          v.blockSequence,
          byte(v.state),
          byte(v.phase),
          byte(v.kind),
          byte(v.valid),
          byte(v.earlyWarning),
          toRow(v.reason),
          v.frequency.value,
          v.frequencySd.value,
          v.severity.value,
          v.spindle.value,
          v.sinceOnset.value,
          v.feedSinceOnset.value,
          v.indicators};
}

bool fromRow(const VerdictRow& row, Verdict& v) {
  v.time = instantFromNs(row.time);
  v.blockSequence = row.blockSequence;
  v.valid = row.valid != 0;
  v.earlyWarning = row.earlyWarning != 0;
  v.reason = fromRow(row.reason);
  v.frequency = Hertz(row.frequency);
  v.frequencySd = Hertz(row.frequencySd);
  v.severity = Ratio(row.severity);
  v.spindle = Hertz(row.spindle);
  v.sinceOnset = Seconds(row.sinceOnset);
  v.feedSinceOnset = Metres(row.feedSinceOnset);
  v.indicators = row.indicators;
  return take(row.state, v.state) && take(row.phase, v.phase) && take(row.kind, v.kind);
}

CommandRow toRow(const CommandRecord& c, std::uint64_t step) {
  return {step,         toNs(c.time),    c.sequence,   byte(c.kind),   c.speed.value,
          c.feed.value, c.lease.count(), c.engagement, toRow(c.reason)};
}

void fromRow(const CommandRow& row, CommandRecord& c) {
  c.time = instantFromNs(row.time);
  c.sequence = row.sequence;
  c.kind = static_cast<CommandKind>(row.kind);
  c.speed = Ratio(row.speed);
  c.feed = Ratio(row.feed);
  c.lease = Duration(row.lease);
  c.engagement = row.engagement;
  c.reason = fromRow(row.reason);
}

EventRow toRow(const Event& e, std::uint64_t step) {
  return {step, toNs(e.time), e.number, byte(e.level), toRow(e.reason)};
}

void fromRow(const EventRow& row, Event& e) {
  e.time = instantFromNs(row.time);
  e.number = row.number;
  e.level = static_cast<EventLevel>(row.level);
  e.reason = fromRow(row.reason);
}

}  // namespace stillcut::record
