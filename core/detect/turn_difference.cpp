#include "core/detect/turn_difference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace stillcut::detect {

void TurnDifference::prepare(int channels, Hertz rate, Hertz slowest) {
  channels_ = channels;
  rate_ = rate.value;
  const double longest = 2.0 * rate_ / slowest.value + 2.0 * kTaps;
  mask_ = std::bit_ceil(static_cast<std::size_t>(longest) + 1) - 1;
  ring_.assign(static_cast<std::size_t>(channels) * 2 * (mask_ + 1), 0.0);
  reset();
}

void TurnDifference::reset() noexcept {
  std::fill(ring_.begin(), ring_.end(), 0.0);
  head_ = seen_ = 0;
  turn_ = twoTurns_ = 0.0;
  needed_ = mask_;
}

void TurnDifference::make(double delay, Delay& out) noexcept {
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

void TurnDifference::setTurn(Hertz spindle) noexcept {
  if (!(spindle.value > 0.0)) return;
  setTurns(rate_ / spindle.value, 2.0 * rate_ / spindle.value);
}

void TurnDifference::setTurns(double one, double two) noexcept {
  const double longest = static_cast<double>(mask_) - 2.0 * kTaps;
  const double turn = std::clamp(one, 2.0, 0.5 * longest);
  const double twoTurns = std::clamp(two, turn, longest);
  if (turn == turn_ && twoTurns == twoTurns_) return;
  turn_ = turn;
  twoTurns_ = twoTurns;
  make(turn + kHalfTaps, one_);
  make(twoTurns + kHalfTaps, two_);
  needed_ = static_cast<std::size_t>(twoTurns) + kTaps + 1;
}

double TurnDifference::read(const double* ring, const Delay& delay) const noexcept {
  // Every frame is there twice, so that the taps lie side by side; four sums, so that none waits for another.
  const double* newest = ring + mask_ + 1 + head_ - delay.whole;
  std::array<double, 4> sums{};
  for (std::size_t k = 0; k < kTaps; k += 4) {
    for (std::size_t i = 0; i < 4; ++i) sums[i] += delay.taps[k + i] * newest[-static_cast<std::ptrdiff_t>(k + i)];
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

void TurnDifference::process(const double* x, double* difference, double* news) noexcept {
  constexpr double kDifferenceScale = 0.408248290463863;  // 1 / sqrt(6)
  constexpr double kNewsScale = 0.816496580927726;        // 1 / sqrt(1.5)
  ++seen_;
  const bool known = ready() && turn_ > 0.0;
  for (int c = 0; c < channels_; ++c) {
    double* ring = ring_.data() + static_cast<std::size_t>(c) * 2 * (mask_ + 1);
    ring[head_] = ring[head_ + mask_ + 1] = x[c];
    difference[c] = 0.0;
    if (news != nullptr) news[c] = 0.0;
    if (!known) continue;
    const double now = ring[(head_ - kHalfTaps) & mask_];
    const double one = read(ring, one_);
    const double two = read(ring, two_);
    difference[c] = kDifferenceScale * (now - 2.0 * one + two);
    if (news != nullptr) news[c] = kNewsScale * (now - 0.5 * (one + two));
  }
  head_ = (head_ + 1) & mask_;
}

double TurnDifference::differenceGain(double offset) noexcept {
  const double chord = 2.0 * std::sin(std::numbers::pi * offset);
  return chord * chord * chord * chord / 6.0;
}

}  // namespace stillcut::detect
