// PathRecorder: moves both actuators to identify their paths and keeps what was written and read. White noise on both
// at once, or a sweep of x and then of y (a sweep of both could not be separated where one axis reaches the other).
// Through the gates, as every output: they ramp, limit and let go. Thread: step() on the loop's thread, real-time; the
// rest while that thread does not run it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/active/active_loop.h"
#include "core/milling/simulation/noise.h"

namespace stillcut::active {

enum class Excitation { Noise, Sweep };

struct RecordRequest {
  Excitation excitation = Excitation::Noise;
  Seconds duration{4.0};
  double rms = 0.1;  // fraction of the amplitude limit; of a sweep too
  std::uint64_t seed = 1;
};

class PathRecorder {
 public:
  Status prepare(const RecordRequest& request, const std::array<safety::ActuatorLimits, kActiveAxes>& limits,
                 Hertz rate);
  void begin() STILLCUT_RT;
  CommandPair step(const AxisPair& errors) STILLCUT_RT;
  void release() noexcept;
  void cut() STILLCUT_RT;
  // All recorded, or let go before; in either case the outputs are at zero.
  bool over() const noexcept;
  double part() const noexcept { return static_cast<double>(at_) / static_cast<double>(length_); }
  void tell(std::array<ActiveAxis, kActiveAxes>& axes) const STILLCUT_RT;

  // Why the record is not whole; empty text: it is.
  Status complete() const;
  // Of one axis, written and read sample by sample: reading[n] was taken just before output[n] was written, with the
  // sign of a path that is taken off (e = d - s * y).
  std::span<const double> output(std::size_t axis) const { return part(axis, output_[axis]); }
  std::span<const double> reading(std::size_t axis) const { return part(axis, reading_[axis]); }

 private:
  std::span<const double> part(std::size_t axis, const std::vector<double>& of) const;
  double wanted(std::size_t axis) STILLCUT_RT;

  RecordRequest request_;
  std::array<safety::ActuatorGate, kActiveAxes> gates_;
  std::array<AxisTally, kActiveAxes> tallies_;
  std::array<std::vector<double>, kActiveAxes> output_, reading_;
  std::array<double, kActiveAxes> amplitude_{};
  milling::NoiseSource noise_{1};
  std::size_t at_ = 0, length_ = 1;
  bool released_ = false;
};

}  // namespace stillcut::active
