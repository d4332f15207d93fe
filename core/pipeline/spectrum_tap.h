// SpectrumTap: the spectrogram of one channel, the first unless another is asked for, made on the worker from the raw
// samples (calibrated), about fifty columns a second of stream time, so that the picture scrolls with samples and not
// with frames. Thread: prepare() on set-up; feed() on the worker, real-time; show() on any.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "core/dsp/spectrum.h"
#include "core/model/cut_setup.h"
#include "core/model/snapshot.h"
#include "core/model/step_record.h"

namespace stillcut::pipeline {

class SpectrumTap {
 public:
  void prepare(const CutSetup& setup);
  // From the next block on, of this channel; one there is not: of the first.
  void show(int channel) noexcept { wanted_.store(channel, std::memory_order_relaxed); }
  // `verdict` in charge gives the spindle line and the chatter mark of the columns this block completes.
  void feed(const SampleBlock& block, const Verdict& verdict) noexcept;

  std::uint64_t count() const { return count_; }
  const SpectrumColumn& column(std::uint64_t number) const { return columns_[number % kSpectrumColumns]; }
  Hertz top() const { return Hertz(rate_ / 2.0); }

 private:
  void makeColumn(Instant middle, const Verdict& verdict) noexcept;

  double rate_ = 0.0;
  std::vector<double> scales_;  // SI per device unit
  std::atomic<int> wanted_{0};
  int channel_ = 0;
  std::size_t hop_ = 0;
  std::size_t filled_ = 0;  // samples since the last column
  std::size_t held_ = 0;    // valid samples in history_
  bool gap_ = false;
  std::size_t window_ = 0;
  std::vector<double> history_;  // every sample twice, one window apart: the newest window is always in one piece
  std::size_t position_ = 0;
  dsp::Spectrum spectrum_;
  std::array<SpectrumColumn, kSpectrumColumns> columns_{};
  std::uint64_t count_ = 0;
};

}  // namespace stillcut::pipeline
