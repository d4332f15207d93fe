// Runs a signal through a PathModel, one sample a call.
// Thread: one; everything but prepare() is real-time.
#pragma once

#include <vector>

#include "core/active/path_model.h"
#include "core/active/tap_line.h"
#include "core/base/realtime.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::active {

class PathFilter {
 public:
  void prepare(const PathModel& model);
  void reset() noexcept;
  // What arrives at the sensor now from the inputs pushed so far; to be called once a sample, before push().
  double arrive() STILLCUT_RT {
    const double r = kernels_.tapSum(forward_.data(), inputs_.data(), forward_.size()) +
                     kernels_.tapSum(backward_.data(), outputs_.data(), backward_.size());
    outputs_.push(r);
    return r;
  }
  void push(double input) STILLCUT_RT { inputs_.push(input); }

 private:
  dsp::kernels::Kernels kernels_;
  std::vector<double> forward_, backward_;  // padded
  TapLine inputs_, outputs_;
};

}  // namespace stillcut::active
