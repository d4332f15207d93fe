// Runs signals through a PathModel, one sample a call.
// Thread: one; everything but prepare() is real-time.
#pragma once

#include <array>
#include <vector>

#include "core/active/path_model.h"
#include "core/active/tap_line.h"
#include "core/base/realtime.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::active {

// Two signals through the same model: the controller needs its output and its reference as they arrive at the sensor.
class PathPair {
 public:
  void prepare(const PathModel& model);
  void reset() noexcept;
  // Another model of the same lengths and delay; what is under way stays.
  void renew(const PathModel& model) STILLCUT_RT;
  // What arrives at the sensor now from the inputs pushed so far; to be called once a sample, before push().
  void arrive() STILLCUT_RT {
    for (std::size_t i = 0; i < 2; ++i) {
      run_.in[i] = inputs_[i].data() + delay_;
      run_.past[i] = outputs_[i].data();
    }
    kernels_.tapPair(run_);
    for (std::size_t i = 0; i < 2; ++i) outputs_[i].push(run_.out[i]);
  }
  double arrived(std::size_t signal) const STILLCUT_RT { return run_.out[signal]; }
  void push(std::size_t signal, double input) STILLCUT_RT { inputs_[signal].push(input); }

 private:
  dsp::kernels::Kernels kernels_;
  std::vector<double> forward_, backward_;  // padded
  std::array<TapLine, 2> inputs_, outputs_;
  dsp::kernels::PairRun run_;
  std::size_t delay_ = 0;
};

class PathFilter {
 public:
  void prepare(const PathModel& model);
  void reset() noexcept;
  double arrive() STILLCUT_RT {
    const double r = kernels_.tapSum(forward_.data(), inputs_.data() + delay_, forward_.size()) +
                     kernels_.tapSum(backward_.data(), outputs_.data(), backward_.size());
    outputs_.push(r);
    return r;
  }
  void push(double input) STILLCUT_RT { inputs_.push(input); }

 private:
  dsp::kernels::Kernels kernels_;
  std::vector<double> forward_, backward_;  // padded
  TapLine inputs_, outputs_;
  std::size_t delay_ = 0;
};

}  // namespace stillcut::active
