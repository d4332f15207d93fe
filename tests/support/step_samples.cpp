#include "tests/support/step_samples.h"

#include <bit>
#include <limits>

namespace stillcut::record {
namespace {

// A small generator of its own, so that a step depends on nothing but its number.
class Numbers {
 public:
  explicit Numbers(int seed) : state_(static_cast<std::uint64_t>(seed) * 0x9E3779B97F4A7C15ULL + 1) {}
  std::uint64_t bits() {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return state_;
  }
  int below(int limit) { return static_cast<int>(bits() % static_cast<std::uint64_t>(limit)); }
  bool coin() { return below(2) == 1; }
  // Any double, the strange ones included.
  double real() {
    switch (below(8)) {
      case 0:
        return -0.0;
      case 1:
        return std::numeric_limits<double>::denorm_min() * below(1000);
      case 2:
        return std::numeric_limits<double>::infinity();
      case 3:
        return std::bit_cast<double>(0x7FF8000000000000ULL | (bits() & 0xFFFFFULL));
      default:
        return static_cast<double>(bits() >> 11U) * 1e-7 / 3.0;
    }
  }
  Instant instant() { return instantFromNs(static_cast<std::int64_t>(bits() >> 2U)); }
  Reason reason() { return {static_cast<ReasonCode>(below(30)), {real(), real(), real(), real()}}; }

 private:
  std::uint64_t state_;
};

MachineState machine(Numbers& n) {
  MachineState m;
  m.time = n.instant();
  m.valid = n.coin();
  m.linkUp = n.coin();
  m.programRunning = n.coin();
  m.feedHold = n.coin();
  m.atSpeed = n.coin();
  m.overridesEnabled = n.coin();
  m.controlOurs = n.coin();
  m.block = static_cast<OverrideInhibit>(n.below(kOverrideInhibits));
  m.programmedSpeed = Rpm(n.real());
  m.programmedFeed = MetresPerSecond(n.real());
  m.operatorSpeed = Ratio(n.real());
  m.operatorFeed = Ratio(n.real());
  m.speedOverride = Ratio(n.real());
  m.feedOverride = Ratio(n.real());
  m.actualSpeed = Rpm(n.real());
  m.actualFeed = MetresPerSecond(n.real());
  m.endedEngagement = n.bits();
  m.link = {n.instant(), n.instant(), n.instant(),       n.instant(),
            n.instant(), n.instant(), Seconds(n.real()), Seconds(n.real())};
  return m;
}

Verdict verdict(Numbers& n) {
  Verdict v;
  v.time = n.instant();
  v.blockSequence = n.bits();
  v.state = static_cast<CutState>(n.below(4));
  v.phase = static_cast<CutPhase>(n.below(5));
  v.kind = static_cast<ChatterKind>(n.below(4));
  v.valid = n.coin();
  v.earlyWarning = n.coin();
  v.reason = n.reason();
  v.frequency = Hertz(n.real());
  v.frequencySd = Hertz(n.real());
  v.severity = Ratio(n.real());
  v.spindle = Hertz(n.real());
  v.sinceOnset = Seconds(n.real());
  v.feedSinceOnset = Metres(n.real());
  for (double& i : v.indicators) i = n.real();
  return v;
}

StepOutput output(Numbers& n) {
  StepOutput o;
  o.verdictCount = n.below(kMaxDetectors + 1);
  o.inCharge = n.below(kMaxDetectors);
  for (int i = 0; i < o.verdictCount; ++i) o.verdicts[static_cast<std::size_t>(i)] = verdict(n);
  o.request = {
      n.instant(), static_cast<RequestKind>(n.below(4)), n.coin(), n.coin(), Rpm(n.real()), MetresPerSecond(n.real()),
      n.reason()};
  o.hasCommand = n.coin();
  if (o.hasCommand) {
    o.command = {n.instant(),     n.bits(),        static_cast<CommandKind>(n.below(2)),
                 Ratio(n.real()), Ratio(n.real()), Duration(static_cast<std::int64_t>(n.bits() >> 3U)),
                 n.reason(),      n.bits()};
  }
  o.authority = static_cast<Authority>(n.below(3));
  o.eventCount = n.below(kMaxEventsPerStep + 1);
  for (int i = 0; i < o.eventCount; ++i) {
    o.events[static_cast<std::size_t>(i)] = {n.instant(), n.bits(), static_cast<EventLevel>(n.below(3)), n.reason()};
  }
  return o;
}

class Bits {
 public:
  template <class Number>
  Bits& operator<<(Number value) {
    bits_.push_back(static_cast<std::uint64_t>(value));
    return *this;
  }
  Bits& operator<<(double value) {
    bits_.push_back(std::bit_cast<std::uint64_t>(value));
    return *this;
  }
  template <class Tag>
  Bits& operator<<(Quantity<Tag> value) {
    return *this << value.value;
  }
  Bits& operator<<(Instant value) { return *this << toNs(value); }
  Bits& operator<<(const Reason& value) {
    *this << value.code;
    for (const double n : value.n) *this << n;
    return *this;
  }
  std::vector<std::uint64_t> take() { return std::move(bits_); }

 private:
  std::vector<std::uint64_t> bits_;
};

}  // namespace

CutSetup exampleSetup(int channels, int blockFrames) {
  CutSetup setup;
  setup.machine = "Mill 3";
  setup.tool = "T12 D12 Z4, stick-out 48 mm, \xC3\xBC";
  setup.teeth = 4;
  setup.toolDiameter = Metres(0.012);
  setup.nominalSpeed = Rpm(11999.999999999998);
  setup.nominalFeed = fromMmPerMin(1234.5);
  setup.rate = Hertz(25600.0);
  setup.blockFrames = blockFrames;
  for (int c = 0; c < channels; ++c) {
    // What a data sheet tells of the first; nobody has told anything of the second.
    setup.channels.push_back({c == 0 ? "x" : "y", SensorQuantity::Acceleration, 9.80665 / (c + 3), c == 0 ? "x" : "y"});
  }
  setup.channels[0].sensitivity = 101.7;
  setup.channels[0].volts = 0.339;
  setup.channels[0].coupling = "iepe";
  setup.channels[0].place = "spindle nose, \xC3\xBC";
  return setup;
}

StepRecord exampleStep(int number, int channels, int blockFrames) {
  Numbers n(number + 1);
  StepRecord step;
  SampleBlock& block = step.input.block;
  block.allocate(channels, blockFrames);
  block.frames = n.below(5) == 0 ? n.below(blockFrames) + 1 : blockFrames;
  block.source = 7;
  block.sequence = static_cast<std::uint64_t>(number) * 3;
  block.firstSample = instantFromNs(static_cast<std::int64_t>(number) * 2'500'000 + n.below(1000));
  block.rate = Hertz(25600.0 + n.below(10) * 1e-3);
  block.flags = static_cast<std::uint32_t>(n.below(4));
  block.lostFrames = n.bits();
  for (int c = 0; c < channels; ++c) {
    for (float& sample : block.channel(c)) sample = static_cast<float>(n.below(1'000'000)) * 1e-3F / 7.0F;
  }
  block.channel(0)[0] = -0.0F;
  step.input.machine = machine(n);
  step.input.inputCount = n.below(3) == 0 ? n.below(kMaxInputsPerStep + 1) : 0;
  for (int i = 0; i < step.input.inputCount; ++i) {
    step.input.inputs[static_cast<std::size_t>(i)] = {static_cast<OperatorAction>(n.below(8)),
                                                      static_cast<Authority>(n.below(3)),
                                                      static_cast<std::uint32_t>(n.below(1000))};
  }
  step.output = output(n);
  return step;
}

std::vector<std::uint64_t> bitsOf(const StepInput& input) {
  Bits bits;
  const SampleBlock& b = input.block;
  bits << b.source << b.sequence << b.firstSample << b.rate << b.channels << b.frames << b.capacityFrames << b.flags
       << b.lostFrames;
  for (int c = 0; c < b.channels; ++c) {
    for (const float s : b.channel(c)) bits << std::bit_cast<std::uint32_t>(s);
  }
  const MachineState& m = input.machine;
  bits << m.time << m.valid << m.linkUp << m.programRunning << m.feedHold << m.atSpeed << m.overridesEnabled
       << m.controlOurs << m.block << m.programmedSpeed << m.programmedFeed << m.operatorSpeed << m.operatorFeed
       << m.speedOverride << m.feedOverride << m.actualSpeed << m.actualFeed << m.endedEngagement << m.link.commanded
       << m.link.acknowledged << m.link.overrides << m.link.speed << m.link.feed << m.link.program << m.link.roundTrip
       << m.link.effect << input.inputCount;
  for (const OperatorInput& i : input.inputs) bits << i.action << i.authority;
  return bits.take();
}

std::vector<std::uint64_t> bitsOf(const StepOutput& o) {
  Bits bits;
  bits << o.verdictCount << o.inCharge;
  for (const Verdict& v : o.verdicts) {
    bits << v.time << v.blockSequence << v.state << v.phase << v.kind << v.valid << v.earlyWarning << v.reason
         << v.frequency << v.frequencySd << v.severity << v.spindle << v.sinceOnset << v.feedSinceOnset;
    for (const double i : v.indicators) bits << i;
  }
  const OverrideRequest& r = o.request;
  bits << r.time << r.kind << r.claimsSpeed << r.claimsFeed << r.speed << r.feed << r.reason << o.hasCommand;
  const CommandRecord& c = o.command;
  bits << c.time << c.sequence << c.kind << c.speed << c.feed << c.lease.count() << c.reason << c.engagement
       << o.authority << o.eventCount;
  for (const Event& e : o.events) bits << e.time << e.number << e.level << e.reason;
  return bits.take();
}

}  // namespace stillcut::record
