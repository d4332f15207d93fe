#include "app/vamp/chatter_plugin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/detect/registry.h"
#include "core/evaluate/judged_time.h"
#include "core/model/judged_cut.h"

namespace stillcut::app {
namespace {

constexpr std::array kSensors{SensorQuantity::Sound,        SensorQuantity::Acceleration, SensorQuantity::Velocity,
                              SensorQuantity::Displacement, SensorQuantity::Force,        SensorQuantity::Current};
constexpr float kSmallestScale = 1e-6F;  // with 0 there would be no vibration

// The places of the parameters in their list.
enum Parameter { kTeeth, kSpeed, kSensor, kScale, kMethod, kParameters };

Vamp::Plugin::ParameterDescriptor parameter(const char* id, const char* name, const char* about, const char* unit,
                                            float most, float usual) {
  Vamp::Plugin::ParameterDescriptor d;
  d.identifier = id;
  d.name = name;
  d.description = about;
  d.unit = unit;
  d.minValue = 0.0F;
  d.maxValue = most;
  d.defaultValue = usual;
  d.isQuantized = true;
  d.quantizeStep = 1.0F;
  return d;
}

Vamp::Plugin::OutputDescriptor output(const char* id, const char* name, const char* about, const char* unit) {
  Vamp::Plugin::OutputDescriptor d;
  d.identifier = id;
  d.name = name;
  d.description = about;
  d.unit = unit;
  d.hasFixedBinCount = true;
  d.binCount = 1;
  return d;
}

int stateOf(const Verdict& v) {
  return hasState(v) ? 1 + static_cast<int>(v.state) : 0;
}

// For a whole stretch: without the numbers that hold for one block only.
std::string words(const Reason& why) {
  switch (why.code) {
    case ReasonCode::Learning:
      return "still learning";
    case ReasonCode::SpindleRunUp:
      return "the spindle is running up";
    case ReasonCode::InputGap:
      return "samples are missing";
    case ReasonCode::DriveTone:
      return "the tone of an axis drive glides";
    default:
      return sentence(why);
  }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool ChatterPlugin::Stretch::holds(const Verdict& v) const {
  if (state != stateOf(v)) return false;
  if (state != 0) return true;
  const Reason now = whyNotJudged(v);
  return now.code == why.code && evaluate::channelOf(now) == evaluate::channelOf(why);
}

std::string ChatterPlugin::Stretch::label() const {
  if (state == 0) {
    const std::string reason = words(why);
    return reason.empty() ? "not judged" : "not judged: " + reason;
  }
  const auto of = static_cast<CutState>(state - 1);
  if (of == CutState::AirCutting) return "air cutting";
  std::string text(name(of));
  if (!frequencies.empty()) text += " at " + std::to_string(std::lround(median(frequencies))) + " Hz";
  return text;
}

std::string ChatterPlugin::getCopyright() const {
  return "The Stillcut engineers; GPL-3.0-or-later";
}

std::size_t ChatterPlugin::getMaxChannelCount() const {
  return kMaxChannels;
}

Vamp::Plugin::ParameterList ChatterPlugin::getParameterDescriptors() const {
  ParameterList all(kParameters);
  all[kTeeth] = parameter("teeth", "Teeth", "Of the tool; 0: not known", "", 200.0F, 0.0F);
  all[kSpeed] = parameter("speed", "Spindle speed", "Nominal; 0: looked for in the signal", "rpm", 100'000.0F, 0.0F);
  all[kSensor] = parameter("sensor", "Sensor", "What the samples are", "", kSensors.size() - 1.0F, 0.0F);
  for (const SensorQuantity q : kSensors) all[kSensor].valueNames.emplace_back(name(q));
  all[kScale] =
      parameter("scale", "Full scale [Pa, m/s2, m/s, m, N, A]", "What a sample of 1 stands for", "", 1e6F, 1.0F);
  all[kScale].minValue = kSmallestScale;
  all[kScale].isQuantized = false;
  const auto methods = detect::detectorTable();
  all[kMethod] =
      parameter("method", "Method", "Which detector decides", "", static_cast<float>(methods.size()) - 1.0F, 0.0F);
  for (std::size_t k = 0; k < methods.size(); ++k) {
    all[kMethod].valueNames.emplace_back(methods[k].id);
    if (methods[k].id == detect::kDefaultDetector) all[kMethod].defaultValue = static_cast<float>(k);
  }
  return all;
}

float ChatterPlugin::getParameter(std::string id) const {
  const ParameterList all = getParameterDescriptors();
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].identifier == id) return values_.empty() ? all[k].defaultValue : values_[k];
  }
  return 0.0F;
}

void ChatterPlugin::setParameter(std::string id, float value) {
  const ParameterList all = getParameterDescriptors();
  if (values_.empty()) {
    for (const ParameterDescriptor& d : all) values_.push_back(d.defaultValue);
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (all[k].identifier == id) values_[k] = std::clamp(value, all[k].minValue, all[k].maxValue);
  }
}

Vamp::Plugin::OutputList ChatterPlugin::getOutputDescriptors() const {
  OutputList all;
  all.push_back(output("states", "States",
                       "0 not judged and why, 1 air cutting, 2 stable, 3 onset, 4 chatter and its frequency", ""));
  OutputDescriptor& states = all.back();
  states.sampleType = OutputDescriptor::VariableSampleRate;
  states.hasDuration = states.hasKnownExtents = states.isQuantized = true;
  states.maxValue = 4.0F;
  states.quantizeStep = 1.0F;
  all.push_back(series("energyratio", "Energy ratio", "Energy of the chatter over all of the vibration's", ""));
  all.back().hasKnownExtents = true;
  all.back().maxValue = 1.0F;
  all.push_back(series("frequency", "Chatter frequency", "Of the strongest line, while it alarms", "Hz"));
  return all;
}

// A value a block, where there is one. Not of variable rate: programs that keep labels would make one of each value.
Vamp::Plugin::OutputDescriptor ChatterPlugin::series(const char* id, const char* name, const char* about,
                                                     const char* unit) const {
  OutputDescriptor d = output(id, name, about, unit);
  const Hertz rate(static_cast<double>(getInputSampleRate()));
  d.sampleType = OutputDescriptor::FixedSampleRate;
  d.sampleRate = static_cast<float>(rate.value / BlockRun::framesOf(rate));
  return d;
}

bool ChatterPlugin::build() {
  BlockRunOptions options;
  options.setup.rate = Hertz(static_cast<double>(getInputSampleRate()));
  options.setup.teeth = static_cast<int>(std::lround(getParameter("teeth")));
  options.setup.nominalSpeed = Rpm(static_cast<double>(getParameter("speed")));
  for (std::size_t c = 0; c < channels_; ++c) {
    ChannelInfo info;
    info.name = "channel " + std::to_string(c);
    info.quantity = kSensors.at(static_cast<std::size_t>(std::lround(getParameter("sensor"))));
    info.scale = static_cast<double>(getParameter("scale"));
    options.setup.channels.push_back(std::move(info));
  }
  const auto method = static_cast<std::size_t>(std::lround(getParameter("method")));
  options.detectors = {std::string(detect::detectorTable()[method].id)};
  auto run = BlockRun::build(std::move(options));
  run_ = run ? std::move(run).value() : nullptr;
  began_.reset();
  stretch_.reset();
  return run_ != nullptr;
}

bool ChatterPlugin::initialise(std::size_t channels, std::size_t step, std::size_t block) {
  if (channels < 1 || channels > getMaxChannelCount() || step != block || block == 0) return false;
  channels_ = channels;
  frames_ = block;
  sideBySide_.resize(channels * block);
  return build();
}

void ChatterPlugin::reset() {
  if (channels_ > 0) build();
}

Vamp::RealTime ChatterPlugin::timeOf(Instant moment) const {
  return *began_ + Vamp::RealTime::fromSeconds(sinceEpoch(moment).value);
}

void ChatterPlugin::endStretch(FeatureSet& found) {
  if (!stretch_) return;
  Feature feature;
  feature.hasTimestamp = feature.hasDuration = true;
  feature.timestamp = stretch_->from;
  feature.duration = stretch_->to - stretch_->from;
  feature.values = {static_cast<float>(stretch_->state)};
  feature.label = stretch_->label();
  found[kStates].push_back(std::move(feature));
}

void ChatterPlugin::take(const Verdict& v, FeatureSet& found) {
  const Vamp::RealTime now = timeOf(v.time);
  if (!stretch_ || !stretch_->holds(v)) {
    const Vamp::RealTime from = stretch_ ? stretch_->to : *began_;
    endStretch(found);
    stretch_ = {.state = stateOf(v),
                .why = hasState(v) ? Reason{} : whyNotJudged(v),
                .from = from,
                .to = now,
                .frequencies = {}};
  }
  stretch_->to = now;
  Feature feature;
  feature.hasTimestamp = true;
  feature.timestamp = now;
  if (judges(v)) {
    feature.values = {static_cast<float>(v.severity.value)};
    found[kEnergyRatio].push_back(feature);
  }
  if (v.alarming() && v.frequency.value > 0.0) {
    stretch_->frequencies.push_back(v.frequency.value);
    feature.values = {static_cast<float>(v.frequency.value)};
    found[kFrequency].push_back(std::move(feature));
  }
}

BlockRun::Took ChatterPlugin::taker(FeatureSet& found) {
  return [this, &found](const StepInput&, const StepOutput& out) { take(out.verdicts.front(), found); };
}

Vamp::Plugin::FeatureSet ChatterPlugin::process(const float* const* inputBuffers, Vamp::RealTime timestamp) {
  FeatureSet found;
  if (!run_) return found;
  if (!began_) began_ = timestamp;
  for (std::size_t frame = 0; frame < frames_; ++frame) {
    for (std::size_t c = 0; c < channels_; ++c) sideBySide_[frame * channels_ + c] = inputBuffers[c][frame];
  }
  run_->feed(sideBySide_, Rpm{}, taker(found));
  return found;
}

Vamp::Plugin::FeatureSet ChatterPlugin::getRemainingFeatures() {
  FeatureSet found;
  if (!run_ || !began_) return found;
  run_->finish(taker(found));
  endStretch(found);
  stretch_.reset();
  return found;
}

}  // namespace stillcut::app
