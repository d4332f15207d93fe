#include "core/milling/simulation/simulated_cut.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillcut::milling {

namespace {

constexpr int kOversampling = 4;

double highestMode(const CutModel& m) {
  double top = 0.0;
  for (const Mode& mode : m.modes) top = std::max(top, mode.frequency.value);
  return top;
}

double slowestDecay(const CutModel& m) {  // [1/s]
  double least = 1e9;
  for (const Mode& mode : m.modes) least = std::min(least, mode.damping * kTwoPi * mode.frequency.value);
  return least;
}

// Steps between two looks at drives and engagement: 12 looks per period of the highest mode, which is also what the
// truth needs. The steps of a revolution are a multiple of 32.
int stepsPerTick(const Scenario& s) {
  const double stepRate = s.chosenSteps() * s.programme.speedOverTime.lowest(s.programme.speed.value) / 60.0 *
                          s.overrides.lowestSpeed.value;
  int k = 32;
  while (k > 1 && stepRate / k < 12.0 * highestMode(s.model)) k /= 2;
  return k;
}

CutNumerics numericsOf(const Scenario& s) {
  CutNumerics n;
  n.stepsPerRevolution = s.chosenSteps();
  n.slices = s.helixSlices;
  n.deepest = Metres(s.programme.depth.highest(0.0));
  return n;
}

CutNumerics forcedNumerics(const Scenario& s) {
  CutNumerics n = companionNumerics(numericsOf(s), stepsPerTick(s));
  n.leavesMarks = false;
  return n;
}

// The forced vibration repeats with the tooth when the teeth are all alike, otherwise with the revolution.
int forcedPeriods(const Tool& t) {
  const auto same = [](const auto& values) {
    return std::all_of(values.begin(), values.end(), [&](const auto& v) { return v == values.front(); });
  };
  return same(t.pitch) && same(t.runout) && same(t.toothHelix) ? t.teeth : 1;
}

// With the modes of the programmed speed, and a work-holder's.
Scenario withFlexure(Scenario s) {
  s.model = modelAt(std::move(s.model), s.programme.speed);
  if (!s.workHolder) return s;
  for (const Mode& mode : workHolderModes(*s.workHolder)) s.model.modes.push_back(mode);
  return s;
}

ChatterTruth::Settings truthSettings(const Scenario& s) {
  ChatterTruth::Settings t;
  t.samplesPerRevolution = s.chosenSteps() / stepsPerTick(s);
  t.periodsPerRevolution = forcedPeriods(s.model.tool);
  const double low = s.programme.speedOverTime.lowest(s.programme.speed.value) / 60.0;
  const double high = s.programme.speedOverTime.highest(s.programme.speed.value) / 60.0;
  t.nominalHz = s.programme.speed.value / 60.0;
  t.fastestHz = high * std::max(1.0, s.overrides.highestSpeed.value);
  t.duration = s.programme.duration.value;
  t.settle = 6.0 / slowestDecay(s.model) + 3.0 / low;
  t.highestHz = highestMode(s.model);
  return t;
}

}  // namespace

SimulatedCut::SimulatedCut(const Scenario& scenario, std::uint64_t seed)
    : scenario_(withFlexure(scenario)),
      tickSteps_(stepsPerTick(scenario_)),
      cut_(scenario_.model, numericsOf(scenario_)),
      probe_(scenario_.model, numericsOf(scenario_), tickSteps_, scenario.programme.feedPerTooth),
      forced_(scenario_.model, forcedNumerics(scenario_)),
      drive_(scenario.drive, Rpm(scenario.programme.speedOverTime.at(0.0, 0.0, scenario.programme.speed.value))),
      overrides_(scenario.overrides, (seed != 0 ? seed : scenario.seed) * 3 + 1),
      noise_((seed != 0 ? seed : scenario.seed) * 3 + 2),
      truth_(truthSettings(scenario_)),
      before_(scenario.sensors.size(), 0.0),
      now_(scenario.sensors.size(), 0.0) {
  const std::uint64_t noiseSeed = (seed != 0 ? seed : scenario.seed) * 1000003;
  sensors_.reserve(scenario.sensors.size());
  for (std::size_t i = 0; i < scenario.sensors.size(); ++i) {
    sensors_.emplace_back(scenario.sensors[i], scenario.rate, kOversampling, noiseSeed + i);
  }
  if (scenario.workHolder) {
    for (std::size_t i = 0; i < 2; ++i) {
      holder_.emplace_back(*scenario.workHolder, kOversampling * scenario.rate);
    }
  }
  totalFrames_ = static_cast<std::uint64_t>(std::llround(scenario.programme.duration.value * scenario.rate.value));
  setCutSpeed(drive_.radPerSecond());
  programmedRpm_ = drive_.speed().value;
  feed_ = scenario_.programmedFeed(drive_.speed()).value;
  cut_.setFeed(feed_);
  forced_.setFeed(feed_);
  updateEngagement();
  readSensors(now_);
}

void SimulatedCut::readSensors(std::vector<double>& values) const noexcept {
  for (std::size_t i = 0; i < sensors_.size(); ++i) values[i] = sensors_[i].quantity(cut_, drive_);
}

void SimulatedCut::setCutSpeed(double radPerSecond) noexcept {
  modelSpeed_ = radPerSecond;
  for (RegenerativeCut* c : cuts()) c->setSpeed(radPerSecond);
}

void SimulatedCut::updateDrives() noexcept {
  const Programme& p = scenario_.programme;
  const double t = cut_.time(), dt = t - lastTick_;
  lastTick_ = t;
  overrides_.advance(start_ + toDuration(Seconds(t)));
  programmedRpm_ = p.speedOverTime.at(t, cut_.feedPath(), p.speed.value);
  const MachineState state = machineState();
  drive_.setTarget(state.targetSpeed());
  drive_.advance(Seconds(dt), cut_.takeMeanTorque());
  // The transition of every mode depends on the step time: renew it only when the speed has really moved.
  if (std::abs(drive_.radPerSecond() - modelSpeed_) > 2e-6 * modelSpeed_) {
    setCutSpeed(drive_.radPerSecond());
  }
  const double wanted = feedHold_ ? 0.0 : state.programmedFeed.value * state.feedOverride.value;
  feed_ += (wanted - feed_) * (p.feedLag.value > 0.0 ? 1.0 - std::exp(-dt / p.feedLag.value) : 1.0);
  cut_.setFeed(feed_);
  forced_.setFeed(feed_);
}

void SimulatedCut::updateEngagement() noexcept {
  const Programme& p = scenario_.programme;
  const double t = cut_.time(), path = cut_.feedPath();
  const double radius = 0.5 * scenario_.model.tool.diameter.value;
  double entered = 1.0, remaining = 1.0;
  if (p.entry) {
    entered = (p.entry->along == Along::Time ? (t - p.entry->at) * feed_ : path - p.entry->at) / radius;
  }
  if (p.exit) {
    remaining = (p.exit->along == Along::Time ? (p.exit->at - t) * feed_ : p.exit->at - path) / radius;
  }
  if (scenario_.model.turning) {
    // The edge is in the work or beside it: a part of a radius means nothing.
    entered = entered > 0.0 ? 1.0 : 0.0;
    remaining = remaining > 0.0 ? 1.0 : 0.0;
  }
  Engagement e = scenario_.model.engagement;
  e.radialImmersion = p.immersion.at(t, path, e.radialImmersion);
  const EngagedAngles angles = engagedAngles({e.startAngle(), e.exitAngle()}, entered, remaining);
  const double depth = angles.count > 0 ? p.depth.at(t, path, 0.0) : 0.0;
  cutting_ = depth > 0.0;
  engagementSteady_ = entered >= 1.0 && remaining >= 1.0;

  // A fiftieth of a step is as fine as an edge need be placed.
  const double fine = 0.02 * kTwoPi / scenario_.chosenSteps();
  bool moved = angles.count != windowCount_;
  for (int i = 0; i < angles.count && !moved; ++i) {
    const auto k = static_cast<std::size_t>(i);
    moved = std::abs(angles.windows[k].from - windows_[k].from) > fine ||
            std::abs(angles.windows[k].to - windows_[k].to) > fine;
  }
  if (moved) {
    windows_ = angles.windows;
    windowCount_ = angles.count;
    for (RegenerativeCut* c : cuts()) c->setWindows({windows_.data(), static_cast<std::size_t>(windowCount_)});
  }
  if (depth != depth_) {
    depth_ = depth;
    for (RegenerativeCut* c : cuts()) c->setAxialDepth(depth);
  }
}

void SimulatedCut::disturb() noexcept {
  const Programme& p = scenario_.programme;
  // Held over a tick, their density is flat up to several times the highest mode.
  const double rmsPerDensity = std::sqrt(0.5 / (tickSteps_ * cut_.stepTime()));
  if (p.unevenness > 0.0) {
    cut_.setForceScale(std::max(0.0, 1.0 + p.unevenness * rmsPerDensity * noise_.normal()));
  }
  if (p.randomForce > 0.0) {
    for (double& f : random_) f = p.randomForce * rmsPerDensity * noise_.normal();
    cut_.setExternalForce(random_[0], random_[1]);
  }
}

void SimulatedCut::setWorkHolder(double x, double y) noexcept {
  wanted_ = {x, y};
}

void SimulatedCut::moveWorkHolder() noexcept {
  // In a straight line from reading to reading: in stairs, every reading would fall on the same side of a step.
  // Readings fall between steps, so the line is laid through its own time, one step late; the end of it need not be
  // known before it is there, and nothing adds up.
  const double fineRate = kOversampling * scenario_.rate.value;
  const double share = std::clamp(1.0 - (static_cast<double>(fine_) - cut_.time() * fineRate), 0.0, 1.0);
  for (std::size_t i = 0; i < holder_.size(); ++i) {
    const double from = push_[i];
    push_[i] = holder_[i].step(wanted_[i]);
    const double rise = push_[i] - from;
    cut_.leadModalForce(flexure(i), from + share * rise, rise * fineRate);
  }
}

// A companion moves with the table: the table's own motion is nothing that the cut excites.
void SimulatedCut::takeAlong(RegenerativeCut& companion, int steps) noexcept {
  for (std::size_t i = 0; i < holder_.size(); ++i) {
    const int mode = flexure(i);
    const double rise = (cut_.modalForce(mode) - companion.modalForce(mode)) / steps;
    companion.leadModalForce(mode, companion.modalForce(mode) + rise, rise / companion.stepTime());
  }
}

void SimulatedCut::tick() noexcept {
  probe_.advance();
  takeAlong(forced_, companionTick(tickSteps_));
  forced_.advance(companionTick(tickSteps_));
  updateDrives();
  updateEngagement();
  disturb();
  TruthSample s;
  s.time = cut_.time();
  s.acceleration = cut_.tipAcceleration();
  s.spindleHz = modelSpeed_ / kTwoPi;
  s.path = cut_.feedPath();
  s.forced = forced_.tipAcceleration();
  s.growth = probe_.growth();
  s.gain = probe_.gain(forcedPeriods(scenario_.model.tool));
  s.flips = probe_.flips();
  s.folded = probe_.folded();
  s.foldHz = modelSpeed_ / kTwoPi * probe_.periodsPerRevolution();
  s.cutting = cutting_;
  s.engagementSteady = engagementSteady_;
  truth_.add(s);
}

void SimulatedCut::advanceTo(double seconds) noexcept {
  while (cut_.time() < seconds) {
    const double left = std::ceil((seconds - cut_.time()) / cut_.stepTime());
    const int room = tickSteps_ - stepInTick_;
    const int steps = left < room ? std::max(1, static_cast<int>(left)) : room;
    cut_.advance(steps - 1);
    readSensors(before_);
    beforeTime_ = cut_.time();
    cut_.advance(1);
    readSensors(now_);
    nowTime_ = cut_.time();
    stepInTick_ += steps;
    if (stepInTick_ == tickSteps_) {
      stepInTick_ = 0;
      tick();
    }
  }
}

bool SimulatedCut::fill(SampleBlock& block) STILLCUT_RT {
  if (frames_ >= totalFrames_) return false;
  const auto frames = std::min<std::uint64_t>(static_cast<std::uint64_t>(block.capacityFrames), totalFrames_ - frames_);
  block.sequence = blocks_++;
  block.firstSample = start_ + toDuration(Seconds(static_cast<double>(frames_) / scenario_.rate.value));
  block.rate = scenario_.rate;
  block.channels = static_cast<int>(sensors_.size());
  block.frames = static_cast<int>(frames);
  block.flags = 0;
  block.lostFrames = 0;
  for (int f = 0; f < block.frames; ++f) {
    const std::uint64_t last = frames_ * kOversampling;
    for (; fine_ <= last; ++fine_) {
      const double at = static_cast<double>(fine_) / (scenario_.rate.value * kOversampling);
      moveWorkHolder();
      advanceTo(at);
      const double span = nowTime_ - beforeTime_;
      const double u = span > 0.0 ? std::clamp((at - beforeTime_) / span, 0.0, 1.0) : 1.0;
      for (std::size_t c = 0; c < sensors_.size(); ++c) sensors_[c].push(before_[c] + u * (now_[c] - before_[c]));
    }
    for (std::size_t c = 0; c < sensors_.size(); ++c) {
      block.channel(static_cast<int>(c))[static_cast<std::size_t>(f)] =
          sensors_[c].take(static_cast<double>(frames_) / scenario_.rate.value);
      if (sensors_[c].clipped()) block.flags |= kBlockClipped;
    }
    ++frames_;
  }
  if (frames_ >= totalFrames_) block.flags |= kBlockEnd;
  return true;
}

MachineState SimulatedCut::machineState() const STILLCUT_RT {
  MachineState m;
  m.time = start_ + toDuration(Seconds(cut_.time()));
  m.valid = true;
  m.linkUp = true;
  m.programRunning = frames_ < totalFrames_;
  m.feedHold = feedHold_;
  m.overridesEnabled = overridesEnabled_;
  m.programmedSpeed = Rpm(programmedRpm_);
  m.programmedFeed = scenario_.programmedFeed(m.programmedSpeed, cut_.time(), cut_.feedPath());
  m.operatorSpeed = knobSpeed_;
  m.operatorFeed = knobFeed_;
  if (overridesEnabled_) {
    const OverrideSettings& o = scenario_.overrides;
    m.speedOverride =
        Ratio(std::clamp(overrides_.speed().value * knobSpeed_.value, o.lowestSpeed.value, o.highestSpeed.value));
    m.feedOverride =
        Ratio(std::clamp(overrides_.feed().value * knobFeed_.value, o.lowestFeed.value, o.highestFeed.value));
  }
  m.actualSpeed = drive_.speed();
  m.actualFeed = MetresPerSecond(feed_);
  const double target = m.targetSpeed().value;
  m.atSpeed = std::abs(m.actualSpeed.value - target) <= 0.005 * target;
  return m;
}

void SimulatedCut::setOverrides(Ratio speed, Ratio feed, Instant when) STILLCUT_RT {
  overrides_.command(speed, feed, std::max(when, start_ + toDuration(time())));
}

void SimulatedCut::setOperatorOverrides(Ratio speed, Ratio feed) STILLCUT_RT {
  if (isFinite(speed) && speed.value >= 0.0) knobSpeed_ = speed;
  if (isFinite(feed) && feed.value >= 0.0) knobFeed_ = feed;
}

}  // namespace stillcut::milling
