#include "app/cli/simulate/simulated_files.h"

#include <array>
#include <utility>

namespace stillcut::app {

Result<SimulatedFile> SimulatedFile::open(const std::string& path, Rig& rig, const std::string& configuration) {
  SimulatedFile out;
  if (path.empty()) return out;
  if (path.ends_with(".wav")) {
    const CutSetup& setup = rig.setup();
    auto wav = record::WavWriter::create(path, static_cast<int>(setup.channels.size()), setup.rate);
    if (!wav) return wav.error();
    out.wav_ = std::move(wav).value();
    for (const ChannelInfo& channel : setup.channels) out.scale_.push_back(channel.scale);
  } else if (path.ends_with(".h5")) {
    if (const Status s = rig.recordTo(path, configuration); !s) return s.error();
    out.session_ = rig.recorder();
  }
  return out;
}

void SimulatedFile::add(const SampleBlock& block, const milling::SimulatedCut& plant) {
  if (wav_ && status_) status_ = wav_->write(block, scale_);
  if (session_ != nullptr && session_->writer() != nullptr && status_) {
    const milling::ChatterTruth& truth = plant.truth();
    status_ = session_->writer()->addTruth("chatter_ratio", block.end(), truth.ratio());
    if (status_) status_ = session_->writer()->addTruth("chatter_counted", block.end(), truth.chatterRatio());
  }
}

Status SimulatedFile::close(const milling::SimulatedCut& plant) {
  if (wav_ && status_) status_ = wav_->finish();
  if (session_ != nullptr && status_) status_ = addTruth(plant);
  if (session_ != nullptr && status_) status_ = session_->finish();
  return status_;
}

Status SimulatedFile::addTruth(const milling::SimulatedCut& plant) {
  record::SessionWriter* writer = session_->writer();
  if (writer == nullptr) return Error{session_->status().path, session_->status().fault};
  const milling::ChatterOnset onset = plant.truth().onset();
  const std::pair<const char*, double> known[] = {{"onset_1pct_s", onset.at1},
                                                  {"onset_20pct_s", onset.at20},
                                                  {"onset_50pct_s", onset.at50},
                                                  {"chatter_hz", plant.truth().chatterFrequency().value},
                                                  {"chatter_kind", static_cast<double>(plant.truth().kind())},
                                                  {"peak_ratio", plant.truth().peakRatio()},
                                                  {"marked_m", plant.truth().marked().value}};
  for (const auto& [name, value] : known) {
    if (Status s = writer->addTruth(name, value); !s) return s;
  }
  return Done{};
}

void SimulatedSeries::observe(const StepInput& input, const StepOutput& output, const milling::SimulatedCut& plant,
                              const pipeline::Chain& chain) {
  if (!log_) {
    std::vector<detect::DetectorInfo> infos;
    for (const auto& detector : chain.parts().detectors) infos.push_back(detector->describe());
    detectors_ = infos.size();
    log_.emplace(
        infos, input.block.firstSample,
        std::vector<std::string>{"machine.speed_rpm", "machine.feed_mm_min", "command.speed_percent",
                                 "command.feed_percent", "cut.depth_mm", "cut.vibration_m_s2", "cut.chatter_ratio"});
  }
  if (output.hasCommand) {
    const bool set = output.command.kind == CommandKind::Set;
    speed_ = set ? output.command.speed.value : 1.0;
    feed_ = set ? output.command.feed.value : 1.0;
  }
  const MachineState& m = input.machine;
  const std::array<double, 7> more{
      m.actualSpeed.value,       toMmPerMin(m.actualFeed),    100.0 * speed_, 100.0 * feed_, 1e3 * plant.depth().value,
      plant.truth().vibration(), plant.truth().chatterRatio()};
  log_->observe({output.verdicts.data(), detectors_}, more);
}

Status SimulatedSeries::write(const std::string& path) const {
  return log_ && !path.empty() ? log_->write(path) : Status(Done{});
}

}  // namespace stillcut::app
