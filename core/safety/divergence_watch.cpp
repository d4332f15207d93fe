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
constexpr double kAtStake = 0.1;        // of the largest output, rms
constexpr double kLouder = 1.5;         // energy, over a quarter second
constexpr std::size_t kSaturating = 3;  // windows
constexpr std::size_t kBefore = 4;      // windows before a silence
constexpr double kSilenced = 0.01;      // energy: 20 dB
constexpr double kSteady = 10.0;  // energy: a pure line that is being quietened falls as fast, but from its beginning

constexpr std::size_t kUsual = 32;  // windows: beats of the lines of a cut are slower than a window
constexpr double kForgets = 30.0;   // [s] until the quietest counts as twice as loud

}  // namespace

void DivergenceWatch::prepare(Hertz rate, double amplitude) noexcept {
  length_ = std::max(4, static_cast<int>(std::lround(kWindow * rate.value)));
  slight_ = kSlight * kSlight * amplitude * amplitude * length_;
  atStake_ = kAtStake * kAtStake * amplitude * amplitude * length_;
  silence_ = std::max(4, static_cast<int>(std::lround(kSilence * rate.value)));
  forgets_ = std::exp2(kWindow / kForgets);
  before_ = 0.0;
  heard_ = 0;
  reset();
}

void DivergenceWatch::reset() noexcept {
  ring_ = {};
  newest_ = filled_ = 0;
  open_ = {};
  count_ = still_ = 0;
  last_ = usual_ = quietest_ = 0.0;
}

void DivergenceWatch::listen(double error) STILLCUT_RT {
  open_.error += error * error;
  if (++count_ < length_) return;
  heard_ = std::min(heard_ + 1, kWindows);
  before_ += (open_.error - before_) / static_cast<double>(heard_);
  open_ = {};
  count_ = 0;
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

LoopHealth DivergenceWatch::judge() STILLCUT_RT {
  before_ *= forgets_;
  usual_ += (back(0).error - usual_) / static_cast<double>(std::min(filled_, kUsual));
  quietest_ = filled_ < kUsual ? usual_ : std::min(quietest_ * forgets_, usual_);
  if (filled_ <= kGrowing) return LoopHealth::Fine;
  if (atEnd(kSaturating) && loud()) return LoopHealth::Saturated;
  if ((usual_ > kBeyond * quietest_ || louderThanBefore()) && filled_ == kWindows && atEnd(kWindows)) {
    return LoopHealth::Saturated;
  }
  if (silenced()) return LoopHealth::Silenced;
  if (worse()) return LoopHealth::Worse;
  return back(0).output > atStake_ && growing() && loud() ? LoopHealth::Diverging : LoopHealth::Fine;
}

// More than half of the samples of these windows were cut off.
bool DivergenceWatch::atEnd(std::size_t windows) const STILLCUT_RT {
  int limited = 0;
  for (std::size_t w = 0; w < windows; ++w) limited += back(w).limited;
  return 2 * limited > static_cast<int>(windows) * length_;
}

bool DivergenceWatch::louderThanBefore() const STILLCUT_RT {
  double now = 0.0;
  for (const Window& w : ring_) now += w.error;
  return heard_ == kWindows && now > kLouder * before_ * static_cast<double>(kWindows);
}

bool DivergenceWatch::growing() const STILLCUT_RT {
  for (std::size_t w = 0; w < kGrowing; ++w) {
    if (back(w).error <= kGrowth * back(w + 1).error || back(w).output <= kGrowth * back(w + 1).output) return false;
  }
  return true;
}

// Beyond the loudest window before those that are judged: a long look back, taken only where the rest speaks for it.
bool DivergenceWatch::loud() const STILLCUT_RT {
  double before = 0.0;
  for (std::size_t w = kGrowing; w < filled_; ++w) before = std::max(before, back(w).error);
  return back(0).error > kBeyond * before && before > 0.0;
}

bool DivergenceWatch::silenced() const STILLCUT_RT {
  if (filled_ < kSaturating + kBefore) return false;
  double loudest = 0.0, output = 0.0;
  for (std::size_t w = 0; w < kSaturating; ++w) {
    loudest = std::max(loudest, back(w).error);
    output += back(w).output / kSaturating;
  }
  double outputBefore = 0.0, least = back(kSaturating).error, most = least;
  for (std::size_t w = kSaturating; w < kSaturating + kBefore; ++w) {
    least = std::min(least, back(w).error);
    most = std::max(most, back(w).error);
    outputBefore += back(w).output / kBefore;
  }
  if (loudest >= kSilenced * least || most > kSteady * least) return false;
  return output > slight_ && output > 0.5 * outputBefore && output < 2.0 * outputBefore;
}

// Now, and in more than half of the quarter second.
bool DivergenceWatch::worse() const STILLCUT_RT {
  const auto bad = [&](std::size_t w) { return back(w).error > kWorse * back(w).without && back(w).output > slight_; };
  std::size_t now = 0, bads = 0;
  for (std::size_t w = 0; w < filled_; ++w) {
    if (!bad(w)) continue;
    ++bads;
    if (w < kSaturating) ++now;
  }
  return now == kSaturating && 2 * bads > kWindows;
}

}  // namespace stillcut::safety
