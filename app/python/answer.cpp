#include "app/python/answer.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "app/embed/array_reader.h"
#include "app/python/remarks.h"
#include "core/base/json_schema.h"
#include "core/config/profile.h"
#include "core/evaluate/answer_json.h"
#include "core/evaluate/channel_survey.h"
#include "core/evaluate/recording_judge.h"
#include "core/milling/stability/lobe_csv.h"
#include "core/milling/stability/lobe_sweep.h"
#include "core/pipeline/catalog.h"

namespace stillcut::app {
namespace {

constexpr const char* kSamples = "samples";

template <class T>
T valueOf(Result<T> result) {
  if (!result) throw std::invalid_argument(result.error().line());
  return std::move(result).value();
}

// The channels that are a vibration by what they hold, side by side as before.
std::vector<float> without(const std::vector<LeftOutChannel>& leftOut, std::span<const float> samples, int channels,
                           std::vector<int>& kept) {
  for (int c = 0; c < channels; ++c) {
    const bool out = std::any_of(leftOut.begin(), leftOut.end(), [c](const auto& l) { return l.index == c; });
    if (!out) kept.push_back(c);
  }
  std::vector<float> some;
  some.reserve(samples.size());
  for (std::size_t frame = 0; frame + static_cast<std::size_t>(channels) <= samples.size();
       frame += static_cast<std::size_t>(channels)) {
    for (const int c : kept) some.push_back(samples[frame + static_cast<std::size_t>(c)]);
  }
  return some;
}

}  // namespace

BlockRunOptions optionsOf(const Sampled& about, const std::vector<std::string>& detectors, const Settings& settings) {
  BlockRunOptions options;
  const auto quantity = sensorQuantityFromName(about.quantity);
  if (!quantity) {
    throw std::invalid_argument("sensor '" + about.quantity +
                                "' is none of acceleration, velocity, displacement, sound, force, current, speed");
  }
  if (about.channels < 1 || about.channels > kMaxChannels)
    throw std::invalid_argument("channels: " + std::to_string(about.channels) + " (1 to 32)");
  options.setup.rate = Hertz(about.rate);
  options.setup.teeth = about.teeth;
  options.setup.nominalSpeed = Rpm(about.speed);
  for (int c = 0; c < about.channels; ++c) {
    ChannelInfo info;
    info.name = "channel " + std::to_string(c);
    info.quantity = *quantity;
    info.scale = about.scale;
    options.setup.channels.push_back(std::move(info));
  }
  options.detectors = detectors;
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  for (const auto& [key, value] : settings)
    valueOf(config::applySetting(options.params, catalog, key + "=" + value, "parameters"));
  return options;
}

std::string analyzeSamples(const Sampled& about, std::span<const float> samples,
                           const std::vector<std::string>& detectors, const Settings& settings) {
  BlockRunOptions options = optionsOf(about, detectors, settings);
  if (samples.size() < options.setup.channels.size()) throw std::invalid_argument("samples: there are none");
  ArrayReader reader(samples, options.setup.channels, options.setup.rate);
  evaluate::JudgedRecording judged;
  judged.leftOut = valueOf(evaluate::surveyChannels(reader, toHertz(options.setup.nominalSpeed)));
  std::vector<float> kept;
  if (!judged.leftOut.empty()) {
    kept = without(judged.leftOut, samples, about.channels, judged.fileChannels);
    samples = kept;
    std::vector<ChannelInfo> channels;
    for (const int c : judged.fileChannels) channels.push_back(options.setup.channels[static_cast<std::size_t>(c)]);
    options.setup.channels = std::move(channels);
  }
  const std::unique_ptr<BlockRun> run = valueOf(BlockRun::build(std::move(options)));
  judged.setup = run->setup();
  evaluate::RecordingJudge judge(run->chain(), judged);
  const auto observe = [&judge](const StepInput& in, const StepOutput& out) { judge.observe(in, out); };
  run->feed(samples, Rpm{}, observe);
  run->finish(observe);

  nlohmann::json object{{"schema", kJsonSchema}, {"command", "analyze"}, {"type", "answer"}, {"recording", kSamples}};
  object["answer"] = evaluate::toJson(judge.answer(0));
  object["rate_hz"] = about.rate;
  object["channels"] = run->setup().channels.size();
  object["length_s"] = reader.format().length().value;
  object["remarks"] = remarks(run->setup(), samples, Hertz(judge.summary(0).spindle_Hz));
  object["own_values"] = toJson(judge.ownValues());
  object["detectors"] = nlohmann::json::array();
  for (std::size_t d = 0; d < judge.detectors(); ++d) {
    nlohmann::json row;
    evaluate::toJson(row, judge.summary(d));
    evaluate::addJudged(row, judge.answer(d));
    nlohmann::json events = nlohmann::json::array();
    judge.log(d).appendEvents(events);
    row["events"] = std::move(events);
    object["detectors"].push_back(std::move(row));
  }
  return object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string lobesOf(const LobesAsked& asked) {
  std::vector<Rpm> speeds;
  speeds.reserve(asked.speeds.size());
  for (const double speed : asked.speeds) speeds.emplace_back(speed);
  milling::SweepOptions options;
  if (asked.method != "exact" && asked.method != "sdm" && asked.method != "zoa")
    throw std::invalid_argument("method '" + asked.method + "' is none of exact, sdm, zoa");
  options.method = asked.method == "zoa"   ? milling::LobeMethod::ZerothOrder
                   : asked.method == "sdm" ? milling::LobeMethod::SemiDiscretization
                                           : milling::LobeMethod::Exact;
  options.limits.maxAxialDepth = Metres(asked.deepest);
  const milling::LobeSweep sweep = valueOf(milling::sweepLobes(asked.model, speeds, options, "lobes"));
  return milling::lobeJson(sweep, "lobes");
}

}  // namespace stillcut::app
