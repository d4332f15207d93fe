#include "core/sensing/hum_canceller.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kFollows = 0.3;  // s, time constant
constexpr double kLeast = 0.01;   // of the power of the air: less hides nothing

}  // namespace

void HumCanceller::prepare(Hertz rate) {
  rate_ = rate.value;
  watch_.prepare(rate);
  reset();
}

void HumCanceller::reset() noexcept {
  watch_.reset();
  count_ = 0;
}

void HumCanceller::choose(Hertz spindle, bool air) noexcept {
  for (std::size_t i = 0; i < count_;) {
    if (watch_.nearOrder(waves_[i].line, spindle)) {
      waves_[i] = waves_[--count_];
    } else {
      ++i;
    }
  }
  if (!air) return;
  for (std::size_t line = 0; line < HumWatch::kLines; ++line) {
    if (watch_.power(line) < kLeast * watch_.meanSquare() || !(watch_.power(line) > 0.0)) continue;
    const auto end = waves_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (std::any_of(waves_.begin(), end, [line](const Wave& w) { return w.line == line; })) continue;
    waves_[count_++] = {line, std::polar(1.0, kTwoPi * watch_.frequency(line).value / rate_), 1.0, 0.0};
  }
}

void HumCanceller::process(std::span<double> x, Hertz spindle, bool air) noexcept {
  watch_.push(x, spindle);
  choose(spindle, air);
  if (count_ == 0) return;
  const double mu = 1.0 / (kFollows * rate_);
  for (double& v : x) {
    double hum = 0.0;
    for (std::size_t i = 0; i < count_; ++i) hum += 2.0 * (waves_[i].amplitude * waves_[i].rotor).real();
    v -= hum;
    for (std::size_t i = 0; i < count_; ++i) {
      Wave& w = waves_[i];
      w.amplitude += mu * v * std::conj(w.rotor);
      w.rotor *= w.step;
    }
  }
  for (std::size_t i = 0; i < count_; ++i) waves_[i].rotor /= std::abs(waves_[i].rotor);
}

}  // namespace stillcut::detect
