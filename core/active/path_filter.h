// Runs signals through a PathModel, one sample a call.
// Thread: one; everything but prepare() is real-time.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/active/delay_line.h"
#include "core/active/path_model.h"
#include "core/base/realtime.h"
#include "core/dsp/kernels/aligned.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::active {

// Two signals through the same model: the controller needs its output and its reference as they arrive at the sensor.
class PathPair {
 public:
  void prepare(const PathModel& model);
  void reset() noexcept;
  // Another model of the same lengths and delay; what is under way arrives as the old one has it.
  void renew(const PathModel& model) STILLCUT_RT;
  // What arrives at the sensor now from the inputs pushed so far; to be called once a sample, before push().
  void arrive() STILLCUT_RT {
    for (std::size_t i = 0; i < 2; ++i) run_.in[i] = delay_ > 0 ? late(i) : pushed_[i];
    if (delay_ > 0) at_ = at_ + 1 < delay_ ? at_ + 1 : 0;
    kernels_.filterPair(run_);
  }
  double arrived(std::size_t signal) const STILLCUT_RT { return run_.out[signal]; }
  void push(std::size_t signal, double input) STILLCUT_RT { pushed_[signal] = input; }

 private:
  double late(std::size_t signal) STILLCUT_RT { return std::exchange(waiting_[signal][at_], pushed_[signal]); }

  dsp::kernels::Kernels kernels_;
  dsp::kernels::LaneValues forward_, backward_;  // padded to one length
  std::array<dsp::kernels::LaneValues, 2> states_;
  std::array<std::vector<double>, 2> waiting_;  // rings of `delay_`
  std::array<double, 2> pushed_{};
  dsp::kernels::PairRun run_;
  std::size_t delay_ = 0, at_ = 0;
};

class PathFilter {
 public:
  void prepare(const PathModel& model);
  void reset() noexcept;
  // As of a PathPair; what is under way goes through the new one.
  void renew(const PathModel& model) STILLCUT_RT;
  double arrive() STILLCUT_RT {
    const double r = kernels_.tapSum(forward_.data(), inputs_.data() + delay_, forward_.size()) +
                     kernels_.tapSum(backward_.data(), outputs_.data(), backward_.size());
    outputs_.push(r);
    return r;
  }
  void push(double input) STILLCUT_RT { inputs_.push(input); }

 private:
  dsp::kernels::Kernels kernels_;
  dsp::kernels::LaneValues forward_, backward_;  // padded
  DelayLine inputs_, outputs_;
  std::size_t delay_ = 0;
};

}  // namespace stillcut::active
