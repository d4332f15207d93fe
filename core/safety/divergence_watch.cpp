#include "core/safety/divergence_watch.h"

#include <algorithm>
#include <cmath>

namespace stillcut::safety {

namespace {

constexpr double kWindow = 0.004;       // [s]
constexpr double kSilence = 0.005;      // [s]
constexpr double kGrowth = 1.3;         // energy, from window to window
constexpr double kBeyond = 4.0;         // energy: twice the amplitude
constexpr double kWorse = 2.0;          // energy
constexpr double kSlight = 0.01;        // of the largest output, rms
constexpr std::size_t kSaturating = 3;  // windows

}  // namespace

void DivergenceWatch::prepare(Hertz rate, double amplitude) noexcept {
  length_ = std::max(4, static_cast<int>(std::lround(kWindow * rate.value)));
  slight_ = kSlight * kSlight * amplitude * amplitude * length_;
  silence_ = std::max(4, static_cast<int>(std::lround(kSilence * rate.value)));
  reset();
}

void DivergenceWatch::reset() noexcept {
  ring_ = {};
  newest_ = filled_ = 0;
  open_ = {};
  count_ = still_ = 0;
  last_ = 0.0;
}

LoopHealth DivergenceWatch::watch(double error, double without, double output, bool limited) STILLCUT_RT {
  still_ = error == last_ && output != 0.0 ? still_ + 1 : 0;
  last_ = error;
  if (still_ >= silence_) return LoopHealth::DeadSensor;
  open_.error += error * error;
  open_.without += without * without;
  open_.output += output * output;
  open_.limited += limited ? 1 : 0;
  if (++count_ < length_) return LoopHealth::Fine;
  newest_ = (newest_ + 1) % kWindows;
  ring_[newest_] = open_;
  filled_ = std::min(filled_ + 1, kWindows);
  open_ = {};
  count_ = 0;
  return judge();
}

LoopHealth DivergenceWatch::judge() const STILLCUT_RT {
  if (filled_ <= kGrowing) return LoopHealth::Fine;
  int limited = 0;
  for (std::size_t w = 0; w < kSaturating; ++w) limited += back(w).limited;
  if (2 * limited > static_cast<int>(kSaturating) * length_ && loud()) return LoopHealth::Saturated;
  bool worse = true;
  for (std::size_t w = 0; w < kSaturating; ++w) {
    worse = worse && back(w).error > kWorse * back(w).without && back(w).output > slight_;
  }
  if (worse) return LoopHealth::Worse;
  bool growing = true;
  for (std::size_t w = 0; w < kGrowing && growing; ++w) {
    growing = back(w).error > kGrowth * back(w + 1).error && back(w).output > kGrowth * back(w + 1).output;
  }
  return growing && loud() ? LoopHealth::Diverging : LoopHealth::Fine;
}

// Beyond the loudest window before those that are judged: a long look back, taken only where the rest speaks for it.
bool DivergenceWatch::loud() const STILLCUT_RT {
  double before = 0.0;
  for (std::size_t w = kGrowing; w < filled_; ++w) before = std::max(before, back(w).error);
  return back(0).error > kBeyond * before && before > 0.0;
}

}  // namespace stillcut::safety
