// Off-line identification of the secondary path from what was written to the actuator and what the sensor read, and how
// good the model is. LMS forgets of a sweep what came first, so of a sweep the finite response that fits it best is
// found first, and the filters learn that from noise. The excitation should reach every frequency that is to be
// controlled: white noise, or a sweep. The loop's own delay is found first and taken out of the filter. The recursive
// model is kept where it is stable and predicts better than the finite response that is tried beside it. Thread:
// set-up; allocates.
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
  int passes = 4;        // over the record
  bool sweep = false;    // the output was a sweep and no noise
  int mostDelay = 2048;  // of the loop, looked for [samples]
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
  double phaseMargin = 0.0;
  double worstFrequency = 0.0;
};

struct IdentifiedPath {
  PathModel model;
  PathReport report;
};

// `output` and `reading` sample by sample: reading[n] was taken just before output[n] was written.
Result<IdentifiedPath> identifyPath(std::span<const double> output, std::span<const double> reading, Hertz rate,
                                    const PathRequest& request, const std::string& where);

// The recursive model of the lengths and the delay of `like` that is nearest to an impulse response r(1), r(2) ...,
// learned from noise through it.
Result<PathModel> modelOf(const std::vector<double>& impulse, const PathModel& like, const std::string& where);

}  // namespace stillcut::active
