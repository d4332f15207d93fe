// What the Python module asks of the program in one call each, as text in JSON: a recording judged, lobes. Thread: any,
// each call by itself. Errors are thrown as std::invalid_argument with their one line, which Python shows as
// ValueError.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/embed/block_run.h"
#include "core/milling/cut_model.h"

namespace stillcut::app {

// "KEY" to "VALUE", as `stillcut-cli parameters` lists them.
using Settings = std::map<std::string, std::string>;

struct Sampled {
  double rate = 0.0;  // [Hz]
  int channels = 1;
  std::string quantity;  // of every channel: "acceleration", "sound", ... (SensorQuantity)
  double scale = 1.0;    // SI units per unit of the samples
  int teeth = 0;         // 0: not known
  double speed = 0.0;    // nominal [rev/min]; 0: not known
};

BlockRunOptions optionsOf(const Sampled& about, const std::vector<std::string>& detectors, const Settings& settings);

// Shape: samples[frame * channels + channel]. The fields are those of the line `answer` of `stillcut-cli analyze
// --json` (resources/manual/scripts.md), as far as samples alone can have them.
std::string analyzeSamples(const Sampled& about, std::span<const float> samples,
                           const std::vector<std::string>& detectors, const Settings& settings);

struct LobesAsked {
  milling::CutModel model;
  std::vector<double> speeds;    // [rev/min]
  double deepest = 0.010;        // [m]
  std::string method = "exact";  // or "sdm", "zoa"
};
// The object of `stillcut-cli lobes --json`.
std::string lobesOf(const LobesAsked& asked);

}  // namespace stillcut::app
