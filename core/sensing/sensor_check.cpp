#include "core/sensing/sensor_check.h"

#include <algorithm>
#include <cmath>

#include "core/model/device_flags.h"
#include "core/sensing/input_check.h"

namespace stillcut::detect {
namespace {

constexpr double kWindow = 0.1;  // s
constexpr std::size_t kFewest = 256;
constexpr double kLastBits = 4.0;  // steps of the converter: its last bit flips in silence
constexpr int kFewestKnocks = 3;   // knocks in a window: one is a chip that hit the sensor
constexpr double kKnockPart = 0.05;
constexpr int kKnocksStay = 3;       // windows, however long: a machine gets a bump now and then
constexpr double kKnocksGone = 1.0;  // s
// Part of the power that no predictor foretells: white noise 1, and 0.85 through an audio converter's filter, which
// ends at 0.9 of half the rate; loud cuts a few percent, a weak one in a slow sensor two thirds.
constexpr double kNoiseLeft = 0.8;
constexpr double kGaussian = 4.0;  // kurtosis; an edge's impacts are white too, but not Gaussian
constexpr double kLoud = 4.0;      // 6 dB above air
constexpr double kNoiseStays = 0.5;
constexpr double kPlaceMemory = 10.0;     // s: drift is no fault
constexpr double kLearnPlace = 1.0;       // s
constexpr double kOffset = 3.0;           // times the largest magnitude shown
constexpr double kGravityTurned = 19.62;  // m/s2: a sensor turned upside down
constexpr double kOffsetStays = 0.5;
constexpr double kHumPart = 0.5;
constexpr double kHumInAir = 1.0;  // m/s2 rms: in air, less is the hum of a sensor that hears nothing else
constexpr double kStillStays = 0.5;

}  // namespace

void SensorCheck::prepare(const CutSetup& setup) {
  window_ = std::max(kFewest, static_cast<std::size_t>(kWindow * setup.rate.value));
  windowSeconds_ = static_cast<double>(window_) / setup.rate.value;
  channels_.assign(setup.channels.size(), {});
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    SensorChannel& c = channels_[i];
    c.quantity = setup.channels[i].quantity;
    c.scale = setup.channels[i].scale;
    c.samples.assign(window_, 0.0);
    c.before.assign(window_, 0.0);
    c.angles.assign(window_, KnockFinder::kNoAngle);
    c.knocks.prepare(static_cast<int>(window_));
    c.hum.prepare(setup.rate);
  }
  cable_.prepare(setup);
  pairs_.prepare(setup);
  rate_.prepare(setup.rate);
  alias_.prepare(static_cast<int>(setup.channels.size()), setup.rate);
  status_.nominalRate = setup.rate;
  reset();
}

void SensorCheck::reset() noexcept {
  for (SensorChannel& c : channels_) {
    c.knocks.reset();
    c.hum.reset();
    c.place = c.largest = c.seconds = 0.0;
    c.loose = c.off = c.noise = c.still = {};
    c.repeats = {};
  }
  cable_.reset();
  pairs_.reset();
  rate_.reset();
  alias_.reset();
  const Hertz nominal = status_.nominalRate;
  status_ = {};
  status_.channels = static_cast<int>(channels_.size());
  status_.nominalRate = nominal;
  begin();
}

// Values that are no numbers would stay in every sum.
void SensorCheck::drop(int index) noexcept {
  SensorChannel& c = channels_[static_cast<std::size_t>(index)];
  c.fill = c.beforeFill = 0;
  c.sum = 0.0;
  c.repeats.interrupt();
}

// The channels' windows end one after another, so that no block has to look at all of them: the first is shorter.
void SensorCheck::begin() noexcept {
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    SensorChannel& c = channels_[i];
    c.fill = c.beforeFill = 0;
    c.length = window_ - window_ * i / (2 * channels_.size());
    c.sum = 0.0;
    c.repeats.interrupt();
  }
}

void SensorCheck::interrupt(const SampleBlock& raw, const Reason& why) noexcept {
  rate_.push(raw);
  alias_.interrupt();
  begin();
  if (raw.has(kBlockGap)) status_.lostFrames += raw.lostFrames;
  status_.fault = why;
}

void SensorCheck::take(const SampleBlock& raw, const ConditionedBlock& block, int index, const CutGate& gate) noexcept {
  SensorChannel& c = channels_[static_cast<std::size_t>(index)];
  const std::span<const float> delivered = raw.channel(index);
  const std::span<const double> x = block.channel(index);
  const bool turning = block.spindle.value > 0.0;
  for (std::size_t f = 0; f < x.size();) {
    const std::size_t now = std::min(c.length - c.fill, x.size() - f);
    double sum = c.sum;
    for (const float v : delivered.subspan(f, now)) {
      c.repeats.see(v);
      sum += static_cast<double>(v);
    }
    c.sum = sum;
    std::copy_n(x.data() + f, now, c.samples.data() + c.fill);
    for (std::size_t k = 0; k < now; ++k) {
      c.angles[c.fill + k] = turning ? KnockFinder::angleOf(block.angle[f + k]) : KnockFinder::kNoAngle;
    }
    c.fill += now;
    f += now;
    if (c.fill == c.length) look(index, gate);
  }
  c.hum.push(x, block.spindle);
}

void SensorCheck::watchMean(SensorChannel& c, double mean, double peak) noexcept {
  if (!changesOnly(c.quantity)) return;
  if (c.seconds < kLearnPlace) {
    c.largest = std::max(c.largest, peak);
    c.place += (mean - c.place) * windowSeconds_ / std::max(windowSeconds_, c.seconds);
    // No accelerometer rests further from zero than gravity turned over: that is no place to learn.
    if (c.quantity == SensorQuantity::Acceleration && std::abs(c.place) > kGravityTurned) c.place = 0.0;
    return;
  }
  const double away = std::abs(mean - c.place);
  const bool left = away > kOffset * c.largest && (c.quantity != SensorQuantity::Acceleration || away > kGravityTurned);
  c.off.see(left, static_cast<int>(kOffsetStays / windowSeconds_), 1);
  // The step itself rings through the high-pass: a window counts once the next one has shown that nothing moved.
  if (away < c.largest) c.largest = std::max(c.largest, c.peak);
  c.peak = peak;
  if (!left) c.place += (mean - c.place) * windowSeconds_ / kPlaceMemory;
}

// What may rest is dead where others of its kind are in a cut, 6 dB above their own air.
void SensorCheck::watchStill(int index, const CutGate& gate) noexcept {
  SensorChannel& c = channels_[static_cast<std::size_t>(index)];
  bool othersCut = false;
  for (std::size_t o = 0; o < channels_.size() && gate.inCut(); ++o) {
    const double air = gate.airFloor(static_cast<int>(o));
    const double rms = status_.channel[o].rms;
    othersCut = othersCut || (channels_[o].quantity == c.quantity && air > 0.0 && rms * rms > kLoud * air);
  }
  const bool still = c.repeats.run() >= static_cast<int>(c.length) && c.quantity != SensorQuantity::SpindleSpeed;
  c.still.see(still && othersCut, windowsIn(kStillStays), 1);
}

void SensorCheck::look(int index, const CutGate& gate) noexcept {
  const auto i = static_cast<std::size_t>(index);
  SensorChannel& c = channels_[i];
  const std::span<const double> x(c.samples.data(), c.fill);
  const double count = static_cast<double>(c.fill);
  double squares = 0.0;
  double peak = 0.0;
  for (const double v : x) {
    squares += v * v;
    peak = std::max(peak, std::abs(v));
  }
  const double mean = c.scale * c.sum / count;
  c.seconds += windowSeconds_;
  const KnockFacts facts = c.knocks.look(x, std::span(c.angles).first(c.fill),
                                         kLastBits * std::abs(c.scale) * static_cast<double>(c.repeats.step()));
  const bool knocks = gate.inCut() && facts.knocks >= kFewestKnocks && facts.part > kKnockPart;
  c.loose.see(knocks, kKnocksStay, windowsIn(kKnocksGone));
  const double air = gate.airFloor(index);
  const bool loud = air > 0.0 && gate.inCut() && squares > kLoud * air * count;
  c.noise.see(loud && facts.left > kNoiseLeft && facts.kurtosis < kGaussian, windowsIn(kNoiseStays), 1);
  cable_.look(index, x, std::span(c.before).first(c.beforeFill), squares / count, 1.0 / windowSeconds_, gate);
  watchMean(c, mean, peak);
  watchStill(index, gate);
  c.repeats.judge();
  ChannelStatus& status = status_.channel[i];
  status.rms = std::sqrt(squares / count);
  status.peak = peak;
  status.offset = mean;
  c.samples.swap(c.before);
  c.beforeFill = c.fill;
  c.fill = 0;
  c.length = window_;
  c.sum = 0.0;
}

int SensorCheck::windowsIn(double seconds) const noexcept {
  return std::max(1, static_cast<int>(std::lround(seconds / windowSeconds_)));
}

Reason SensorCheck::faultOf(int index, const CutGate& gate) const noexcept {
  const SensorChannel& c = channels_[static_cast<std::size_t>(index)];
  const auto channel = static_cast<double>(index);
  if (c.still.stands()) return {ReasonCode::InputDead, {channel}};
  if (cable_.broken(index)) return {ReasonCode::InputSilent, {channel}};
  if (c.loose.stands()) return {ReasonCode::InputLoose, {channel}};
  if (c.off.stands())
    return {ReasonCode::InputOffset, {channel, status_.channel[static_cast<std::size_t>(index)].offset}};
  const double hum = std::sqrt(c.hum.part() * c.hum.meanSquare());
  const bool heard = gate.inCut() || (c.quantity == SensorQuantity::Acceleration && hum > kHumInAir);
  if (heard && c.hum.part() > kHumPart) return {ReasonCode::InputHum, {channel, c.hum.mains().value}};
  if (c.noise.stands()) return {ReasonCode::InputNoise, {channel}};
  const int twin = pairs_.twinOf(index);
  if (twin >= 0 && twin < index) return {ReasonCode::InputDoubled, {static_cast<double>(twin), channel}};
  if (c.repeats.repeats() && c.quantity != SensorQuantity::SpindleSpeed)  // told now and then, and held
    return {ReasonCode::InputRepeated, {channel}};
  if (const auto [line, order] = alias_.folded(index); order > 0) {
    return {ReasonCode::InputAliased, {channel, line.value, static_cast<double>(order)}};
  }
  return {};
}

Reason SensorCheck::faultOfAll(const SampleBlock& raw) const noexcept {
  if (rate_.wrong()) return {ReasonCode::InputRate, {rate_.rate().value, status_.nominalRate.value}};
  if (raw.has(kBlockRateMismatch) && rateMismatchChannel(raw) >= static_cast<int>(channels_.size()))
    return {ReasonCode::InputRepeated, {static_cast<double>(rateMismatchChannel(raw))}};
  if (rate_.pending() > 0.0) return {ReasonCode::Learning, {rate_.pending()}};
  return {};
}

Reason SensorCheck::check(const SampleBlock& raw, const ConditionedBlock& block, const InputCheck& input,
                          const CutGate& gate) noexcept {
  rate_.push(raw);
  pairs_.push(raw);
  alias_.push(block, gate.inCut());
  status_.actualRate = rate_.rate();
  status_.actualRateSd = rate_.sd();
  const int slower = raw.has(kBlockRateMismatch) ? rateMismatchChannel(raw) : -1;
  Reason first;
  for (int i = 0; i < block.channels; ++i) {
    Reason fault = input.fault(i);
    if (fault.code == ReasonCode::None) {
      take(raw, block, i, gate);
      fault = i == slower ? Reason{ReasonCode::InputRepeated, {static_cast<double>(i)}} : faultOf(i, gate);
    } else {
      drop(i);
    }
    status_.channel[static_cast<std::size_t>(i)].fault = fault;
    if (first.code == ReasonCode::None) first = fault;
  }
  const Reason all = faultOfAll(raw);
  status_.fault = all.code != ReasonCode::None ? all : first;
  return all;
}

}  // namespace stillcut::detect
