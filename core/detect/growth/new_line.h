// The frequency of a line that has come within the last few turns.
//
// The turn difference (turn_difference.h) answers a line that comes, or stops growing, with two turns of another phase.
// Near a harmonic it passes more of those than of the line that stands, and until they have left the spectrum's window
// the top of its spectrum is pulled away from the harmonic, by up to a tenth of an order. Here the forced vibration is
// taken out as it was before the line came: E_k is what a Hann window of two turns, begun k turns earlier than the
// newest, holds near a rough frequency, phases counted from its own begin. Every whole order stands still in it. Where
// it stood still, K turns ago, it is the nearest order alone; E_k - E_K is the line, and what that turns by from one
// turn to the next is its frequency. All turns since then count by their power (the pulse pair of Doppler radar). Not
// in Caliskan 2018. Thread: worker; everything but prepare() is real-time.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <span>

#include "core/base/units.h"
#include "core/dsp/frame_ring.h"
#include "core/dsp/kernels/kernels.h"

namespace stillcut::detect {

class NewLine {
 public:
  // window: samples that are remembered, kTurnsBack turns or so.
  void prepare(int channels, int window, Hertz rate);
  void reset();
  // x[channel * stride + frame], the vibration.
  void push(const double* x, std::ptrdiff_t stride, std::size_t frames);
  // Frames since the spindle stood 0, 1, 2 ... whole turns back, which is as far as is looked.
  static constexpr std::size_t kTurnsBack = 25;
  using TurnsAgo = std::array<double, kTurnsBack>;
  // Of the line near `rough`, at most half a spindle order from it, over all channels by its part of them. 0 where none
  // has come within the last 0.2 s, twelve turns at least and twenty at most, and where the forced vibration before it
  // was too restless to tell.
  Hertz frequency(Hertz rough, Hertz spindle, const TurnsAgo& ago) const;
  // ... at a constant speed.
  Hertz frequency(Hertz rough, Hertz spindle) const { return frequency(rough, spindle, atSpeed(spindle)); }
  // E_0, E_1, ... of one channel; false where not so many turns are remembered.
  bool turnsOf(int channel, Hertz rough, Hertz spindle, std::span<std::complex<double>> out) const;

 private:
  TurnsAgo atSpeed(Hertz spindle) const;
  std::span<const double> newest(int channel) const;
  bool windowOf(std::span<const double> newest, double order, const TurnsAgo& ago, std::size_t k,
                std::complex<double>& out) const;
  std::complex<double> advance(std::span<const double> newest, double order, double w, const TurnsAgo& ago) const;

  dsp::kernels::Kernels kernels_;
  double rate_ = 0.0;
  int channels_ = 0;
  FrameRing ring_;
};

}  // namespace stillcut::detect
