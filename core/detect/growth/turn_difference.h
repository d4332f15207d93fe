// What does not repeat from turn to turn, T one spindle turn:
//   difference  d(t) = (x(t) - 2 x(t - T) + x(t - 2T)) / sqrt(6)
//   news        n(t) = (x(t) - (x(t - T) + x(t - 2T)) / 2) / sqrt(1.5)
//
// Difference: everything locked to the spindle drops out, all orders at once, also where its size grows steadily (a
// depth ramp) or the speed used is slightly wrong: the rest of order h at a relative speed error e is (2 pi h e)^2, 4 %
// at order 32 and e = 0.1 %, where a comb that takes one turn leaves 20 %. White noise keeps its power. A line between
// the orders at an offset of p orders (0..0.5) passes with (2 sin pi p)^2 / sqrt(6), so that growth shows within one
// turn. News: the same for everything that stands still, and white noise keeps its power here too. What grows within a
// turn passes with four times the power that the difference leaves of it, and a line near a harmonic with far more (p =
// 0.1: 55 % of its power against 2.4 %), but so does forced vibration whose size or speed changes. These are the onset
// statistics of the energy-ratio detector; they are not in Caliskan's paper, whose ratio at a fixed threshold of 20 %
// comes tens of milliseconds late on the reference cuts. The fractional delay is a windowed sinc of 16 taps. Thread:
// worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <vector>

#include "core/base/units.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

class RevolutionDifference {
 public:
  // slowest: lowest spindle frequency that will be asked for.
  void prepare(int channels, Hertz rate, Hertz slowest);
  void reset();
  void setTurn(Hertz spindle);
  // While the speed changes: how many samples ago the spindle stood one and two turns back.
  void setTurns(double one, double two);

  // x[channel * stride + frame] in; out the same with outStride, 0 until two turns are known. news may be null.
  void process(const double* x, std::ptrdiff_t stride, std::size_t frames, double* difference, double* innovation,
               std::ptrdiff_t outStride);
  // Part of the power of a line `offset` orders from a harmonic that the difference passes.
  static double differenceGain(double offset);
  // ... and the news.
  static double newsGain(double offset);
  // ... that is passed in the line's first turn.
  static constexpr double kDifferenceArrival = 1.0 / 6.0;
  static constexpr double kNewsArrival = 1.0 / 1.5;
  bool ready() const { return seen_ > needed_; }

 private:
  static constexpr int kTaps = dsp::kernels::kDelayTaps;
  static constexpr int kHalfTaps = kTaps / 2;
  struct Delay {
    std::size_t whole = 0;
    std::array<double, kTaps> taps{};
  };
  static constexpr std::size_t kMostFrames = 256;  // that the ring takes at once
  static void make(double delay, Delay& out);
  void remember(const double* x, std::ptrdiff_t stride, std::size_t frames);

  dsp::kernels::Kernels kernels_;
  int channels_ = 0;
  double rate_ = 0.0;
  double turn_ = 0.0;
  double twoTurns_ = 0.0;
  std::size_t mask_ = 0;
  std::size_t head_ = 0;
  std::size_t seen_ = 0;
  std::size_t needed_ = 0;
  Delay one_, two_;
  std::vector<double> ring_;
};

}  // namespace stillcut::detect
