// What a simulated cut leaves behind: the recording that `--out` names and the series that `--series` names.
// Thread: one.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "core/evaluate/series_log.h"
#include "core/formats/sound/wav_reader.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::app {

// A session (.h5) takes everything and the truth, a sound file (.wav) the samples in SI. An empty path: nothing.
class SimulatedFile {
 public:
  static Result<SimulatedFile> open(const std::string& path, Rig& rig, const std::string& configuration);
  void add(const SampleBlock& block, const milling::SimulatedCut& plant);
  Status close(const milling::SimulatedCut& plant);

 private:
  Status addTruth(const milling::SimulatedCut& plant);

  std::unique_ptr<record::WavWriter> wav_;
  std::vector<double> scale_;
  record::Recorder* session_ = nullptr;
  Status status_{Done{}};
};

// A row a block: what the detectors say, then the machine, our command, and the cut itself by its own truth.
class SimulatedSeries {
 public:
  void observe(const StepInput& input, const StepOutput& output, const milling::SimulatedCut& plant,
               const pipeline::Chain& chain);
  // An empty path: nothing.
  Status write(const std::string& path) const;

 private:
  std::optional<evaluate::SeriesLog> log_;
  std::size_t detectors_ = 0;
  double speed_ = 1.0, feed_ = 1.0;  // commanded
};

}  // namespace stillcut::app
