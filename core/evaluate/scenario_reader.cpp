#include "core/evaluate/scenario_reader.h"

#include <cmath>
#include <utility>

#include "core/milling/simulation/simulated_cut.h"
#include "core/session/open_recording.h"

namespace stillcut::evaluate {
namespace {

class ScenarioReader final : public record::RecordingReader {
 public:
  explicit ScenarioReader(const milling::Scenario& scenario) : plant_(scenario) {
    const CutSetup setup = plant_.scenario().cutSetup();
    format_.kind = "simulated cut";
    format_.rate = setup.rate;
    format_.frames = std::llround(scenario.programme.duration.value * setup.rate.value);
    format_.blockFrames = setup.blockFrames;
    format_.blocks = (format_.frames + setup.blockFrames - 1) / setup.blockFrames;
    for (const ChannelInfo& channel : setup.channels) format_.channels.push_back({channel, "", true});
    format_.setup = setup;
    format_.simulated = true;
  }

  const record::RecordingFormat& format() const override { return format_; }
  Result<bool> read(SampleBlock& block) override {
    if (!plant_.fill(block)) return false;
    step_.input.machine = plant_.machineState();
    return true;
  }
  const StepRecord* recordedStep() const override { return &step_; }

 private:
  milling::SimulatedCut plant_;
  record::RecordingFormat format_;
  StepRecord step_;
};

}  // namespace

bool isScenarioFile(const std::string& path) {
  return path.ends_with(".toml");
}

Result<std::unique_ptr<record::RecordingReader>> openCut(const std::string& path, const record::ReadOptions& options) {
  if (!isScenarioFile(path)) return record::openRecording(path, options);
  const auto scenario = milling::loadScenario(path);
  if (!scenario) return scenario.error();
  return std::unique_ptr<record::RecordingReader>(new ScenarioReader(*scenario));
}

}  // namespace stillcut::evaluate
