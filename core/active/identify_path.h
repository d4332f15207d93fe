// Off-line identification of the secondary path from what was written to the actuator and what the sensor read, and how
// good the model is. The excitation should reach every frequency that is to be controlled: white noise, or a sweep.
// The recursive model is kept where it is stable and predicts better than the finite response that is tried beside it.
// Thread: set-up; allocates.
#pragma once

#include <complex>
#include <span>
#include <string>
#include <vector>

#include "core/active/path_identifier.h"
#include "core/base/result.h"

namespace stillcut::active {

struct PathRequest {
  IdentifierOptions filter{.forward = 35, .backward = 35, .step = 0.1, .normalised = true};
  int passes = 4;  // over the record
};

struct PathReport {
  std::vector<double> frequency;               // [Hz]
  std::vector<std::complex<double>> measured;  // H1: cross density over that of the output
  std::vector<std::complex<double>> modelled;
  std::vector<double> coherence;  // 0 .. 1
  double residual = 0.0;          // rms of what the model does not predict over that of the reading
  // Largest phase error where the coherence tells (0.8 and more), and the phase that is left of the 90 degrees that
  // FXLMS can stand [rad]; the frequency it happens at [Hz].
  double worstPhase = 0.0;
  double phaseLeft = 0.0;
  double worstAt = 0.0;
};

struct IdentifiedPath {
  PathModel model;
  PathReport report;
};

// `output` and `reading` sample by sample: reading[n] was taken just before output[n] was written.
Result<IdentifiedPath> identifyPath(std::span<const double> output, std::span<const double> reading, Hertz rate,
                                    const PathRequest& request, const std::string& where);

}  // namespace stillcut::active
