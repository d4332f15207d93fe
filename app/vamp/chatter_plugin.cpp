#include "app/vamp/chatter_plugin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/detect/registry.h"
#include "core/model/judged_cut.h"

namespace stillcut::app {
namespace {

constexpr std::array kSensors{SensorQuantity::Sound,        SensorQuantity::Acceleration, SensorQuantity::Velocity,
                              SensorQuantity::Displacement, SensorQuantity::Force,        SensorQuantity::Current};
constexpr double kBlocksPerSecond = 200.0;  // of BlockRun

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
  d.sampleType = Vamp::Plugin::OutputDescriptor::VariableSampleRate;
  d.sampleRate = static_cast<float>(kBlocksPerSecond);
  return d;
}

std::string labelOf(const Verdict& v) {
  if (!hasState(v)) {
    const std::string why = sentence(whyNotJudged(v));
    return why.empty() ? "not judged" : "not judged: " + why;
  }
  if (!v.alarming()) return v.state == CutState::AirCutting ? "air cutting" : "stable";
  return std::string(name(v.state)) + " at " + std::to_string(std::lround(v.frequency.value)) + " Hz";
}

}  // namespace

std::string ChatterPlugin::getCopyright() const {
  return "The Stillcut engineers; GPL-3.0-or-later";
}

std::size_t ChatterPlugin::getMaxChannelCount() const {
  return kMaxChannels;
}

Vamp::Plugin::ParameterList ChatterPlugin::getParameterDescriptors() const {
  ParameterList all(kParameters);
  all[kTeeth] = parameter("teeth", "Teeth", "Of the tool; 0: not known", "", 200.0F, 0.0F);
  all[kSpeed] =
      parameter("speed", "Spindle speed", "Nominal; 0: looked for in the signal", "rev/min", 100'000.0F, 0.0F);
  all[kSensor] = parameter("sensor", "Sensor", "What the samples are", "", kSensors.size() - 1.0F, 0.0F);
  for (const SensorQuantity q : kSensors) all[kSensor].valueNames.emplace_back(name(q));
  all[kScale] =
      parameter("scale", "Full scale", "What a sample of 1 stands for (Pa, m/s2, m/s, m, N, A)", "", 1e6F, 1.0F);
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
  all.push_back(output("states", "States", "Air cutting, stable, onset, chatter, or why it was not judged", ""));
  all.back().hasDuration = true;
  all.back().binCount = 0;
  all.push_back(output("energyratio", "Energy ratio", "Energy of the chatter over all of the vibration's", ""));
  all.back().hasKnownExtents = true;
  all.back().maxValue = 1.0F;
  all.push_back(output("frequency", "Chatter frequency", "Of the strongest line, while it alarms", "Hz"));
  return all;
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
  feature.label = stretch_->label;
  found[kStates].push_back(std::move(feature));
}

void ChatterPlugin::take(const Verdict& v, FeatureSet& found) {
  const Vamp::RealTime now = timeOf(v.time);
  const std::string label = labelOf(v);
  if (!stretch_ || stretch_->label != label) {
    const Vamp::RealTime from = stretch_ ? stretch_->to : *began_;
    endStretch(found);
    stretch_ = {label, from, now};
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
