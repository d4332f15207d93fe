#include "core/sensing/conditioner.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/dsp/kernels/choose.h"
#include "core/sensing/feed_now.h"

namespace stillcut::detect {
namespace {

constexpr std::array<const config::ParamDecl*, 4> kParams{&kHighPass, &kSpeedRange, &kCutLevel, &kVibrationLimit};
enum Own : std::size_t { OwnHighPass, OwnSpeed, OwnSpeedSd, OwnNoise };
constexpr std::size_t kNoises = 4;  // channels that tell theirs
constexpr std::array<std::string_view, 3> kWhyHighPass{kSetByHand, "a quarter of the told spindle frequency",
                                                       "low enough for any spindle, as no speed was told"};
// By SpeedSource.
constexpr std::array<std::string_view, 4> kWhySpeed{"nobody has told it, and the signal has not shown it", "as told",
                                                    "as the machine reads it", "found in the signal, and followed"};
constexpr std::array<std::string_view, 3> kWhySpeedSd{"no speed is known", "of what was told",
                                                      "of what the signal shows"};
constexpr std::array<std::string_view, 2> kWhyNoise{"no air has been heard yet",
                                                    "the quietest fifth of a second so far"};
constexpr std::array<AutoValueDecl, OwnNoise + kNoises> kOwnValues{{
    {"conditioner.high-pass", "High-pass edge", "Hz", kWhyHighPass},
    {"conditioner.speed", "Spindle speed", "rpm", kWhySpeed},
    {"conditioner.speed-doubt", "Uncertainty of the speed", "rpm", kWhySpeedSd},
    {"conditioner.noise-1", "Noise in air, channel 1", "", kWhyNoise},
    {"conditioner.noise-2", "Noise in air, channel 2", "", kWhyNoise},
    {"conditioner.noise-3", "Noise in air, channel 3", "", kWhyNoise},
    {"conditioner.noise-4", "Noise in air, channel 4", "", kWhyNoise},
}};

constexpr double kHighPassOrder = 0.25;  // of the spindle frequency: keeps the first order whole
constexpr Hertz kHighPassUnknown{2.0};   // no speed known
constexpr int kFilterOrder = 2;
constexpr Hertz kHighestChatter{2500.0};
constexpr int kLowPassOrder = 4;
constexpr Seconds kTurnUnknown{0.02};
constexpr Seconds kStep{1e-3};
constexpr int kLooks = 3;  // on end
// Lines of teeth that cut, with what they make vibrate: blows have many. A spindle that idles has one or two of its
// own, and those of its motor and of fans.
constexpr int kCutLines = 4;
// Looks for which a cut told by its chatter goes on without it: one window, so that nothing is left of what told it.
constexpr unsigned kHolds = SeriesWatch::kLooksPerWindow;

// Speed and current are integrals of the cutting torque and fall with the frequency; what an encoder or a converter
// adds does not, and an encoder's rises with it. Above where tools chatter they tell nothing.
bool hasLowPass(SensorQuantity q) {
  return q == SensorQuantity::SpindleSpeed || q == SensorQuantity::Current;
}

bool vibrates(SensorQuantity q) {
  return changesOnly(q) || q == SensorQuantity::Force || q == SensorQuantity::Displacement;
}

void refuse(const CutSetup& setup) {
  const auto count = static_cast<int>(setup.channels.size());
  if (count < 1 || count > kMaxChannels) {
    throw std::runtime_error("conditioner: " + std::to_string(count) + " channels (allowed: 1 to " +
                             std::to_string(kMaxChannels) + ")");
  }
  if (!(setup.rate.value >= 100.0) || setup.rate.value > 1e6) {
    throw std::runtime_error("conditioner: sampling rate " + std::to_string(setup.rate.value) +
                             " Hz (allowed: 100 to 1000000)");
  }
  if (setup.blockFrames < 1) throw std::runtime_error("conditioner: the longest block has no frames");
}

}  // namespace

config::ParamTable conditionerParams() {
  return kParams;
}

void Conditioner::prepare(const CutSetup& setup, const config::ParamSet& params) {
  refuse(setup);
  setup_ = setup;
  capacity_ = setup.blockFrames;
  channels_ = static_cast<int>(setup.channels.size());
  const Hertz spindle = toHertz(setup.nominalSpeed);
  if (!params.isAutomatic(kHighPass)) {
    highPass_ = Hertz(params.real(kHighPass));
  } else {
    highPass_ = spindle.value > 0.0 ? spindle * kHighPassOrder : kHighPassUnknown;
  }
  const auto count = static_cast<std::size_t>(channels_);
  const auto frames = static_cast<std::size_t>(capacity_);
  kernels_ = dsp::kernels::bestKernels();
  filters_.assign(count, {});
  hums_.assign(count, {});
  for (HumCanceller& hum : hums_) hum.prepare(setup.rate);
  drives_ = std::vector<DriveTone>(count);
  for (DriveTone& drive : drives_) drive.prepare(setup.rate);
  const bool any = std::any_of(setup.channels.begin(), setup.channels.end(),
                               [](const ChannelInfo& c) { return hasLowPass(c.quantity); });
  integrals_.assign(any && kHighestChatter < setup.rate * 0.45 ? count : 0, {});
  offset_.assign(count, 0.0);
  samples_.assign(count * frames, 0.0);
  kept_.assign(count * frames, 0.0);
  angle_.assign(frames, 0.0);
  angleStep_.assign(frames, 0.0);
  stepFrames_ = std::max(1, static_cast<int>(std::lround(kStep.value * setup.rate.value)));
  check_.prepare(setup);
  leftOut_.prepare(setup);
  sensors_.prepare(setup);
  speed_.prepare(setup, params.real(kSpeedRange));
  series_.prepare(setup, params.real(kSpeedRange));
  gate_.prepare(setup);
  onlyForce_ = std::all_of(setup.channels.begin(), setup.channels.end(),
                           [](const ChannelInfo& c) { return c.quantity == SensorQuantity::Force; });
  retune(params);
  reset();
  own_.set(OwnHighPass, highPass_.value, !params.isAutomatic(kHighPass) ? 0 : spindle.value > 0.0 ? 1 : 2);
}

void Conditioner::retune(const config::ParamSet& params) noexcept {
  gate_.setOpenRatio(std::pow(10.0, params.real(kCutLevel) / 10.0));
}

double Conditioner::chosen(const config::ParamDecl& decl) const {
  return decl.key == kHighPass.key ? highPass_.value : config::kAutomatic;
}

void Conditioner::reset() noexcept {
  check_.reset();
  leftOut_.reset();
  sensors_.reset();
  speed_.reset();
  series_.reset();
  gate_.reset();
  for (HumCanceller& hum : hums_) hum.reset();
  for (DriveTone& drive : drives_) drive.reset();
  out_ = {};
  restart();
  gapPending_ = false;
  doubted_ = false;
  startsInChatter_ = 0;
  cutUntil_ = 0;
}

void Conditioner::restart() noexcept {
  primed_ = false;
  for (auto& filter : filters_) {
    filter.reset();
    filter.highPass(kFilterOrder, highPass_, setup_.rate);
  }
  for (auto& filter : integrals_) {
    filter.reset();
    filter.lowPass(kLowPassOrder, kHighestChatter, setup_.rate);
  }
  speed_.restart();
  series_.interrupt();
  stepDone_ = 0;
  squares_ = {};
}

bool Conditioner::usable(const SampleBlock& block) noexcept {
  if (block.channels != channels_ || block.frames > capacity_ || block.frames < 1) {
    out_.reason = {ReasonCode::DetectorFault, {}};
    return false;
  }
  check_.look(block);
  const Seconds length(block.frames / setup_.rate.value);
  for (int c = 0; c < channels_; ++c) {
    if (check_.fault(c).code != ReasonCode::None) leftOut_.see(c, check_.fault(c), length);
  }
  out_.overloaded = check_.clipped();
  out_.reason = check_.allBad() ? leftOut_.allOut() : Reason{};
  if (out_.reason.code == ReasonCode::None && block.has(kBlockGap)) {
    // The block after the gap is sound in itself, but everything that was followed through it is not.
    out_.reason = {ReasonCode::InputGap, {static_cast<double>(block.lostFrames)}};
  }
  return out_.reason.code == ReasonCode::None;
}

void Conditioner::makeSi(const SampleBlock& block) noexcept {
  for (int c = 0; c < channels_; ++c) {
    const auto i = static_cast<std::size_t>(c);
    const std::span<const float> in = block.channel(c);
    double* out = samples_.data() + static_cast<std::ptrdiff_t>(c) * capacity_;
    const double scale = setup_.channels[i].scale;
    const bool numbers = check_.fault(c).code == ReasonCode::None;
    if (!primed_) offset_[i] = numbers ? scale * static_cast<double>(in[0]) : 0.0;  // spares the filter the step
    for (int f = 0; f < block.frames; ++f) {
      out[f] = numbers ? scale * static_cast<double>(in[static_cast<std::size_t>(f)]) - offset_[i] : 0.0;
    }
  }
  dsp::Butterworth::process(filters_, samples_.data(), capacity_, samples_.data(), capacity_,
                            static_cast<std::size_t>(block.frames), kernels_);
  for (std::size_t c = 0; c < integrals_.size(); ++c) {
    if (!hasLowPass(setup_.channels[c].quantity)) continue;
    double* row = samples_.data() + static_cast<std::ptrdiff_t>(c) * capacity_;
    for (int f = 0; f < block.frames; ++f) row[f] = integrals_[c].process(row[f]);
  }
  // Until the lines of a cut say which speed it is: the strongest line may be the hum itself, and be followed as the
  // spindle's.
  const SeriesLook& look = series_.newest();
  const Hertz spindle = gate_.inCut() && look.certain && look.teethHeard ? look.spindle : speed_.told();
  for (std::size_t c = 0; c < hums_.size(); ++c) {
    const std::span<double> row(samples_.data() + c * static_cast<std::size_t>(capacity_),
                                static_cast<std::size_t>(block.frames));
    if (!vibrates(setup_.channels[c].quantity)) continue;
    hums_[c].process(row, spindle, !gate_.inCut());
    drives_[c].process(row, gate_.phase() == CutPhase::Entry);
  }
  primed_ = true;
}

void Conditioner::silenceLeftOut() noexcept {
  for (int c = 0; c < channels_; ++c) {
    if (!leftOut_.is(c)) continue;
    double* row = samples_.data() + static_cast<std::ptrdiff_t>(c) * capacity_;
    std::copy_n(row, out_.frames, kept_.data() + static_cast<std::ptrdiff_t>(c) * capacity_);
    std::fill_n(row, out_.frames, 0.0);
  }
}

void Conditioner::restoreLeftOut() noexcept {
  for (int c = 0; c < channels_; ++c) {
    const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(c) * capacity_;
    if (leftOut_.is(c)) std::copy_n(kept_.data() + from, out_.frames, samples_.data() + from);
  }
}

void Conditioner::addSquares(int from, int frames) noexcept {
  for (int c = 0; c < channels_; ++c) {
    const double* x = samples_.data() + static_cast<std::ptrdiff_t>(c) * capacity_ + from;
    double sum = 0.0;
    for (int f = 0; f < frames; ++f) sum += x[f] * x[f];
    squares_[static_cast<std::size_t>(c)] += sum;
  }
}

void Conditioner::follow(int frames) noexcept {
  for (int f = 0; f < frames;) {
    const int now = std::min(frames - f, stepFrames_ - stepDone_);
    for (int c = 0; c < channels_; ++c) pointers_[static_cast<std::size_t>(c)] = samples_.data() + c * capacity_ + f;
    speed_.advance(pointers_.data(), now, angle_.data() + f, angleStep_.data() + f);
    series_.push(pointers_.data(), now, !gate_.inCut());
    addSquares(f, now);
    f += now;
    stepDone_ += now;
    if (stepDone_ < stepFrames_) continue;
    // A tone that glides takes the speed along where it crosses a harmonic.
    if (doubtDrives().code == ReasonCode::None)
      speed_.look(Seconds(stepFrames_ / setup_.rate.value), gate_.phase() == CutPhase::Exit);
    lookAtLines();
    advanceGate();
    stepDone_ = 0;
    squares_ = {};
  }
}

void Conditioner::lookAtLines() noexcept {
  if (speed_.riding() || doubtDrives().code != ReasonCode::None) series_.interrupt();
  if (!series_.due()) return;
  std::array<double, kMaxChannels> standing{};
  for (std::size_t c = 0; c < drives_.size(); ++c) {
    if (drives_[c].standing()) standing[c] = drives_[c].frequency().value;
  }
  series_.setDrives(standing);
  series_.look(speed_.centre(), speed_.centreSd());
  series_.compare(speed_.foundFar() ? speed_.spindle() : Hertz(0.0));
  const SeriesLook& look = series_.newest();
  startsInChatter_ = look.certain && look.familyLeads ? startsInChatter_ + 1 : 0;
  if (gate_.inCut()) speed_.believe(look.spindle, look.sd, look.certain && look.teethHeard);
}

// Chatter with its side lines a spindle's turn apart proves that a tool cuts, where no air was heard before.
bool Conditioner::chattersFromTheStart() const noexcept {
  return startsInChatter_ >= kLooks;
}

void Conditioner::advanceGate() noexcept {
  const double spindle = speed_.known() ? speed_.spindle().value : 0.0;
  const Seconds turn = spindle > 0.0 ? Seconds(1.0 / spindle) : kTurnUnknown;
  const CutPhase before = gate_.phase();
  const SeriesLook& look = series_.newest();
  // An idling spindle puts no force on the tool: any series of its orders is cut. In a slot that four teeth cut the
  // tooth passing is nearly constant, and its runout is what a force sensor measures.
  const bool teeth = speed_.forced() || (onlyForce_ && look.certain);
  if (chattersFromTheStart() || (gate_.inCut() && look.familyStands)) cutUntil_ = look.count + kHolds;
  gate_.setForced((teeth && look.seriesLines >= kCutLines) || look.count < cutUntil_);
  gate_.setSpeedKnown((speed_.locked() && speed_.known()) || speed_.isolatedLine().value > 0.0 ||
                      (look.certain && look.teethHeard));
  for (double& s : squares_) s /= stepFrames_;
  gate_.advance(std::span(squares_).first(static_cast<std::size_t>(channels_)),
                Seconds(stepFrames_ / setup_.rate.value), turn);
  if (before == CutPhase::AirCutting && gate_.inCut() && !gate_.airSeen() && chattersFromTheStart()) series_.allIsCut();
  if (before == CutPhase::AirCutting && gate_.inCut() && gate_.airSeen()) {
    speed_.beginCut();
    series_.beginCut();
  }
}

// Where nothing quieter was ever heard, a tone that no teeth force may be chatter that was there before, or the
// machine's own.
Reason Conditioner::doubtAir() const noexcept {
  const Hertz tone = speed_.suspect();
  if (gate_.airSeen() || gate_.inCut() || !(tone.value > 0.0)) return {};
  return {ReasonCode::NoAirCutting, {tone.value}};
}

// A tone that glides is in whatever is compared. While the spindle changes its speed its own lines glide.
Reason Conditioner::doubtDrives() const noexcept {
  if (speed_.riding() || !gate_.inCut()) return {};
  for (int c = 0; c < channels_; ++c) {
    const DriveTone& drive = drives_[static_cast<std::size_t>(c)];
    if (drive.unsettled() && !leftOut_.is(c)) return {ReasonCode::DriveTone, {drive.frequency().value}};
  }
  return {};
}

// The signal goes on, so that the speed is followed and recovery is seen; the detectors start anew after it.
void Conditioner::checkSensors(const SampleBlock& block) noexcept {
  restoreLeftOut();
  Reason doubt = sensors_.check(block, out_, check_, gate_);
  silenceLeftOut();
  const Seconds length(block.frames / setup_.rate.value);
  for (int c = 0; c < channels_; ++c)
    leftOut_.see(c, sensors_.status().channel[static_cast<std::size_t>(c)].fault, length);
  if (doubt.code == ReasonCode::None) doubt = leftOut_.allOut();
  if (doubt.code == ReasonCode::None) doubt = doubtAir();
  if (doubt.code == ReasonCode::None) doubt = doubtDrives();
  if (doubted_ && doubt.code == ReasonCode::None) out_.afterGap = true;
  doubted_ = doubt.code != ReasonCode::None;
  if (!doubted_) return;
  out_.valid = false;
  out_.reason = doubt;
}

AutoValueTable Conditioner::autoValues() {
  return kOwnValues;
}

void Conditioner::tellOwn() noexcept {
  const bool known = speed_.known();
  own_.set(OwnSpeed, known ? toRpm(speed_.spindle()).value : config::kAutomatic,
           known ? static_cast<std::size_t>(speed_.source()) : 0);
  own_.set(OwnSpeedSd, known ? toRpm(speed_.sd()).value : config::kAutomatic, !known ? 0 : speed_.locked() ? 2 : 1);
  for (std::size_t c = 0; c < kNoises && c < static_cast<std::size_t>(channels_); ++c) {
    const double air = gate_.airFloor(static_cast<int>(c));
    own_.set(OwnNoise + c, air > 0.0 ? std::sqrt(air) : config::kAutomatic, air > 0.0 ? 1 : 0);
  }
}

const ConditionedBlock& Conditioner::process(const SampleBlock& block, const MachineState& machine) noexcept {
  out_.sequence = block.sequence;
  out_.firstSample = block.firstSample;
  out_.rate = setup_.rate;
  out_.channels = channels_;
  out_.frames = std::clamp(block.frames, 0, capacity_);
  out_.samples = samples_.data();
  out_.stride = capacity_;
  out_.angle = angle_.data();
  out_.angleStep = angleStep_.data();
  out_.afterGap = leftOut_.takeReturned();
  out_.feed = feedNow(machine, setup_.nominalFeed);
  speed_.setMachineState(machine, out_.frames, out_.end());
  out_.valid = usable(block);
  if (!out_.valid) {
    gapPending_ = true;  // whatever follows starts anew
    sensors_.interrupt(block, out_.reason);
    return out_;
  }
  if (gapPending_) {
    restart();
    out_.afterGap = true;
    gapPending_ = false;
  }
  makeSi(block);
  silenceLeftOut();
  follow(block.frames);
  out_.spindle = speed_.known() ? speed_.spindle() : Hertz(0.0);
  out_.series = series_.newest();
  out_.isolatedLine = speed_.isolatedLine();
  out_.spindleSd = speed_.sd();
  out_.speedChanging = speed_.riding();
  out_.revolutionsComparable = !speed_.moving();
  out_.phase = gate_.phase();
  const bool drives =
      std::any_of(drives_.begin(), drives_.end(), [](const DriveTone& drive) { return drive.expected(); });
  out_.alarmWait = drives ? MovingTone::kRecognised : Seconds(0.0);
  out_.levelTrend = gate_.trend();
  checkSensors(block);
  tellOwn();
  return out_;
}

}  // namespace stillcut::detect
