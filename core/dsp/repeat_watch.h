// Whether every value of a channel comes two to eight times: samples of a lower rate that were stretched. Runs of equal
// values are counted over a stretch (a tenth of a second will do); single values among them are rare then, which no
// gain, filter or still sensor brings about.
// Thread: one; real-time.
#pragma once

#include <cmath>

#include "core/dsp/finding.h"

namespace stillcut::dsp {

class RepeatWatch {
 public:
  void see(float value) noexcept {
    if (run_ > 0 && value == last_) {
      ++run_;
      return;
    }
    const float change = std::abs(value - last_);
    if (run_ > 0 && (step_ == 0.0F || change < step_)) step_ = change;
    if (run_ == 1) ++singles_;
    if (run_ > 1 && run_ <= kLongestHold) ++held_;
    last_ = value;
    run_ = 1;
  }
  // A stretch has ended; a finding needs three.
  void judge() noexcept {
    repeats_.see(held_ >= kFewestRuns && singles_ < kSingles * (singles_ + held_), kStays, kStays);
    singles_ = held_ = 0;
  }
  // The stretch that runs begins anew, after a gap; what was found stands.
  void interrupt() noexcept {
    run_ = singles_ = held_ = 0;
    step_ = 0.0F;
  }

  bool repeats() const noexcept { return repeats_.stands(); }
  int run() const noexcept { return run_; }      // samples at the present value
  float step() const noexcept { return step_; }  // least change from one value to the next; 0: none yet

 private:
  static constexpr int kLongestHold = 8;
  static constexpr int kFewestRuns = 32;
  static constexpr double kSingles = 0.02;  // part of the runs; a gain or filter never makes pairs of all values
  static constexpr int kStays = 3;

  float last_ = 0.0F, step_ = 0.0F;
  int run_ = 0, singles_ = 0, held_ = 0;
  Finding repeats_;
};

}  // namespace stillcut::dsp
