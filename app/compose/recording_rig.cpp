#include "app/compose/recording_rig.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/compose/run_text.h"
#include "core/daq/replay_source.h"
#include "core/evaluate/channel_survey.h"
#include "core/evaluate/judged_samples.h"
#include "core/evaluate/scenario_reader.h"
#include "core/model/sensor_status.h"
#include "core/pipeline/catalog.h"
#include "core/session/open_recording.h"

namespace stillcut::app {
namespace {

std::string shownRate(Hertz rate) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", rate.value);
  return text;
}

// A session: machine state and operator inputs come with each block, as they were. `chosen`: parameters that whoever
// runs it again has chosen; what was made of them during the cut is left out.
class SessionStepSource final : public pipeline::StepSource {
 public:
  explicit SessionStepSource(daq::ReplaySource& source, std::vector<std::uint32_t> chosen = {})
      : source_(source), chosen_(std::move(chosen)) {}
  bool read(StepInput& step) noexcept override {
    if (!source_.read(step.block)) return false;
    const StepInput* recorded = source_.recordedStep();
    step.machine = recorded != nullptr ? recorded->machine : MachineState{};
    step.machine.time += source_.shift();
    step.machine.link.shift(source_.shift());
    step.inputs = {};
    step.inputCount = 0;
    for (int i = 0; recorded != nullptr && i < recorded->inputCount; ++i) {
      const OperatorInput& input = recorded->inputs[static_cast<std::size_t>(i)];
      if (overruled(input)) continue;
      step.inputs[static_cast<std::size_t>(step.inputCount++)] = input;
    }
    return true;
  }
  void stop() noexcept override { source_.stop(); }

 private:
  bool overruled(const OperatorInput& input) const noexcept {
    return input.action == OperatorAction::SetParameter &&
           std::find(chosen_.begin(), chosen_.end(), input.parameter) != chosen_.end();
  }

  daq::ReplaySource& source_;
  std::vector<std::uint32_t> chosen_;
};

// What is set now and was not so when the recorded run began.
std::vector<std::uint32_t> chosenNow(const record::RecordingFormat& format, const config::ParamSet& params) {
  const auto recorded = parseRunText(format.configuration, "configuration");
  const config::ParamSet before = recorded ? recorded->params : config::ParamSet();
  const config::ParamCatalog catalog = pipeline::fullCatalog();
  std::vector<std::uint32_t> chosen;
  for (const config::ParamDecl* decl : catalog.all()) {
    const bool same = before.isSet(*decl) && before.text(*decl) == params.text(*decl);
    if (params.isSet(*decl) && !same) chosen.push_back(config::parameterId(decl->key));
  }
  return chosen;
}

void controlBy(const ReplayPacing& hand, const std::string& path, const record::ReadOptions& read,
               daq::ReplayOptions& replay) {
  replay.control = hand.control;
  replay.clock = hand.clock;
  replay.reopen = [path, read] { return evaluate::openCut(path, read); };
}

// What filters and windows are sized for before the first block.
Rpm middleSpeed(std::vector<pipeline::SpeedLogSource::Point> log) {
  const auto middle = log.begin() + static_cast<std::ptrdiff_t>(log.size() / 2);
  std::nth_element(log.begin(), middle, log.end(),
                   [](const auto& a, const auto& b) { return a.speed.value < b.speed.value; });
  return middle->speed;
}

Status checkFormat(const std::string& path, const record::RecordingFormat& format) {
  if (format.blocks > 0 && format.frames == 0) {
    return Error{path, message("holds no samples"),
                 message("a history of features; detectors need the samples themselves")};
  }
  if (format.rate < evaluate::kSlowestSampling) {
    return Error{path, message("%1 samples a second are too few for vibration", shownRate(format.rate)),
                 message("at least 100 are needed; is its time not in seconds? --time-unit or --rate says so")};
  }
  if (format.rate > evaluate::kFastestSampling) {
    return Error{path, message("%1 samples a second are more than can be judged", shownRate(format.rate)),
                 message("at most 1000000; is its time not in seconds? --time-unit or --rate says so")};
  }
  return Done{};
}

// The reader at its beginning, of the channels that may be judged.
struct Opened {
  std::unique_ptr<record::RecordingReader> reader;
  record::ReadOptions read;  // with which it was opened in the end
  std::vector<LeftOutChannel> leftOut;
};

Status checkChannels(const std::string& path, const record::RecordingFormat& format) {
  if (format.channels.size() <= kMaxChannels) return Done{};
  return Error{path, message("has %1 channels, more than are judged at once", format.channels.size()),
               message("choose at most 32 with --channel N[,N]")};
}

Result<Opened> openAll(const std::string& path, const record::ReadOptions& read, Hertz told) {
  auto reader = evaluate::openCut(path, read);
  if (!reader) return reader.error();
  const record::RecordingFormat& format = (*reader)->format();
  if (const Status usable = checkFormat(path, format); !usable) return usable.error();
  Opened opened{nullptr, read, {}};
  const bool ours = format.setup.has_value();
  if (ours || !read.channels.empty()) {
    opened.reader = std::move(reader).value();
    return opened;
  }
  auto leftOut = evaluate::surveyChannels(**reader, told);
  if (!leftOut) return leftOut.error();
  opened.leftOut = std::move(leftOut).value();
  if (!opened.leftOut.empty()) {
    for (int c = 0; c < static_cast<int>(format.channels.size()); ++c) {
      const bool out = std::any_of(opened.leftOut.begin(), opened.leftOut.end(),
                                   [c](const LeftOutChannel& channel) { return channel.index == c; });
      if (!out) opened.read.channels.push_back(c);
    }
  }
  const auto back = opened.leftOut.empty() ? (*reader)->seek(Instant{}) : Result<bool>(false);
  if (back && *back) {
    opened.reader = std::move(reader).value();
    return opened;
  }
  auto again = evaluate::openCut(path, opened.read);
  if (!again) return again.error();
  opened.reader = std::move(again).value();
  return opened;
}

Result<Opened> openChannels(const std::string& path, const record::ReadOptions& read, Hertz told) {
  auto opened = openAll(path, read, told);
  if (!opened) return opened;
  if (const Status fits = checkChannels(path, opened->reader->format()); !fits) return fits.error();
  return opened;
}

}  // namespace

Result<RecordingRig> buildRecordingRig(const std::string& path, const RecordingOptions& options) {
  auto opened = openChannels(path, options.read, toHertz(options.speed));
  if (!opened) return opened.error();
  const record::RecordingFormat format = opened->reader->format();

  daq::ReplayOptions replay;
  replay.blockFrames = std::max(1, static_cast<int>(format.rate.value * evaluate::kJudgedBlock.value));
  controlBy(options.hand, path, opened->read, replay);
  auto source = std::make_unique<daq::ReplaySource>(std::move(opened->reader), replay);

  RigSpec spec;
  if (format.setup) spec.setup = *format.setup;
  if (options.stableSpeeds) spec.setup.stableSpeeds = options.stableSpeeds;
  if (options.teeth > 0) spec.setup.teeth = options.teeth;
  if (options.speed.value > 0.0) spec.setup.nominalSpeed = options.speed;
  if (!options.log.empty()) spec.setup.nominalSpeed = middleSpeed(options.log);
  const bool isSession = format.blocks > 0;
  const bool toldSpeed = options.speed.value > 0.0 || !options.log.empty();
  if (isSession && !toldSpeed) {
    spec.steps = std::make_unique<SessionStepSource>(*source, chosenNow(format, options.params));
    spec.feed = std::make_unique<pipeline::RecordedStateSource>();
  } else {
    spec.feed = std::make_unique<pipeline::SpeedLogSource>(options.log);
  }
  spec.device = std::move(source);
  spec.params = options.params;
  spec.methods = options.methods;
  spec.deterministic = true;
  spec.watched = options.hand.control != nullptr;
  auto rig = Rig::build(std::move(spec));
  if (!rig) return rig.error();
  evaluate::JudgedRecording judged{(*rig)->setup(), opened->read.channels, std::move(opened->leftOut), options.reach,
                                   options.depthLimit};
  return RecordingRig{std::move(rig).value(), format, std::move(judged)};
}

Result<RecordingRig> buildReplayRig(const std::string& path, const ReplayPacing& hand) {
  auto reader = record::openRecording(path);
  if (!reader) return reader.error();
  const record::RecordingFormat format = (*reader)->format();
  if (!format.setup)
    return Error{path, message("cannot be decided again"), message("only Stillcut sessions say how they were made")};
  auto run = parseRunText(format.configuration, path + " (configuration)");
  if (!run) return run.error();

  daq::ReplayOptions replay;
  controlBy(hand, path, {}, replay);
  auto source = std::make_unique<daq::ReplaySource>(std::move(reader).value(), replay);
  RigSpec spec;
  spec.setup = *format.setup;
  spec.steps = std::make_unique<SessionStepSource>(*source);
  spec.feed = std::make_unique<pipeline::RecordedStateSource>();
  spec.device = std::move(source);
  spec.params = std::move(run->params);
  spec.methods = std::move(run->methods);
  spec.autoAllowed = run->autoAllowed;
  spec.deterministic = true;
  spec.watched = hand.control != nullptr;
  auto rig = Rig::build(std::move(spec));
  if (!rig) return rig.error();
  evaluate::JudgedRecording judged;
  judged.setup = (*rig)->setup();
  return RecordingRig{std::move(rig).value(), format, std::move(judged)};
}

}  // namespace stillcut::app
