#include "core/detect/growth/turn_difference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {

void RevolutionDifference::prepare(int channels, Hertz rate, Hertz slowest) {
  channels_ = channels;
  rate_ = rate.value;
  kernels_ = dsp::kernels::bestKernels();
  const double longest = 2.0 * rate_ / slowest.value + 2.0 * kTaps + static_cast<double>(kMostFrames);
  mask_ = std::bit_ceil(static_cast<std::size_t>(longest) + 1) - 1;
  ring_.assign(static_cast<std::size_t>(channels) * 2 * (mask_ + 1), 0.0);
  reset();
}

void RevolutionDifference::reset() {
  std::fill(ring_.begin(), ring_.end(), 0.0);
  head_ = seen_ = 0;
  turn_ = twoTurns_ = 0.0;
  needed_ = mask_;
}

void RevolutionDifference::make(double delay, Delay& out) {
  const double floor = std::floor(delay);
  const double part = delay - floor;
  // Taps at whole - 7 .. whole + 8 around the wanted delay.
  out.whole = static_cast<std::size_t>(floor) - (kHalfTaps - 1);
  double sum = 0.0;
  for (int k = 0; k < kTaps; ++k) {
    const double t = k - (kHalfTaps - 1) - part;
    const double window = std::cos(std::numbers::pi * t / (kTaps + 1));
    const double sinc = std::abs(t) < 1e-9 ? 1.0 : std::sin(std::numbers::pi * t) / (std::numbers::pi * t);
    out.taps[static_cast<std::size_t>(k)] = sinc * window * window;
    sum += out.taps[static_cast<std::size_t>(k)];
  }
  for (double& tap : out.taps) tap /= sum;
}

void RevolutionDifference::setTurn(Hertz spindle) {
  if (!(spindle.value > 0.0)) return;
  setTurns(rate_ / spindle.value, 2.0 * rate_ / spindle.value);
}

void RevolutionDifference::setTurns(double one, double two) {
  const double longest = static_cast<double>(mask_ - kMostFrames) - 2.0 * kTaps;
  const double turn = std::clamp(one, 2.0, 0.5 * longest);
  const double twoTurns = std::clamp(two, turn, longest);
  if (turn == turn_ && twoTurns == twoTurns_) return;
  turn_ = turn;
  twoTurns_ = twoTurns;
  make(turn + kHalfTaps, one_);
  make(twoTurns + kHalfTaps, two_);
  needed_ = static_cast<std::size_t>(twoTurns) + kTaps + 1;
}

// Every frame is there twice, so that the taps lie side by side.
void RevolutionDifference::remember(const double* x, std::ptrdiff_t stride, std::size_t frames) {
  const std::size_t size = mask_ + 1;
  for (int c = 0; c < channels_; ++c) {
    const double* from = x + c * stride;
    double* ring = ring_.data() + static_cast<std::size_t>(c) * 2 * size;
    for (double* to : {ring + head_, ring + head_ + size}) std::copy_n(from, frames, to);
  }
}

void RevolutionDifference::process(const double* x, std::ptrdiff_t stride, std::size_t frames, double* difference,
                                   double* innovation, std::ptrdiff_t outStride) {
  const std::size_t size = mask_ + 1;
  for (std::size_t done = 0; done < frames;) {
    const std::size_t now = std::min({frames - done, kMostFrames, size - head_});
    remember(x + done, stride, now);
    // The first frame after `needed` is the first that is known.
    const std::size_t unknown = turn_ > 0.0 ? std::min(now, needed_ - std::min(seen_, needed_)) : now;
    for (int c = 0; c < channels_; ++c) {
      const double* newest = ring_.data() + static_cast<std::size_t>(c) * 2 * size + size + head_ + unknown;
      double* out = difference + c * outStride + done;
      double* second = innovation != nullptr ? innovation + c * outStride + done : nullptr;
      std::fill_n(out, unknown, 0.0);
      if (second != nullptr) std::fill_n(second, unknown, 0.0);
      if (unknown == now) continue;
      kernels_.turns({newest - kHalfTaps, newest - one_.whole, newest - two_.whole, one_.taps.data(), two_.taps.data(),
                      now - unknown, out + unknown, second != nullptr ? second + unknown : nullptr});
    }
    seen_ += now;
    head_ = (head_ + now) & mask_;
    done += now;
  }
}

double RevolutionDifference::differenceGain(double offset) {
  const double chord = 2.0 * std::sin(std::numbers::pi * offset);
  return chord * chord * chord * chord / 6.0;
}

double RevolutionDifference::newsGain(double offset) {
  const double turn = 2.0 * std::numbers::pi * offset;
  const double re = 1.0 - 0.5 * (std::cos(turn) + std::cos(2.0 * turn));
  const double im = 0.5 * (std::sin(turn) + std::sin(2.0 * turn));
  return (re * re + im * im) / 1.5;
}

}  // namespace stillcut::detect
