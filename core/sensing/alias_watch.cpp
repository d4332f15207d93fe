#include "core/sensing/alias_watch.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/fft.h"
#include "core/dsp/kernels/choose.h"
#include "core/dsp/line_outside.h"

namespace stillcut::detect {
namespace {

constexpr double kWindow = 0.5;  // s
constexpr int kMostFrames = 1 << 14;
constexpr double kMoved = 0.002;  // of the spindle's speed: less moves no order that can be told from its neighbours
constexpr double kRest = 5.0;     // s between looks at a speed that stands
constexpr double kUsableBand = 0.49;  // of the rate: what folds stands close to its half as well
constexpr double kMaskBins = 2.25;    // a Hann line and a quarter
constexpr double kLeastPart = 0.01;   // of the vibration: a tenth of its amplitude, or nobody takes it for chatter
constexpr double kLeastPurity = 0.3;
constexpr double kPlaceBins = 0.25;  // to which a line's place is known
constexpr double kSmear = 0.25;      // of the speed's drift: the line's middle is known better than its ends
constexpr double kMostDoubt = 0.05;  // of the spindle's frequency: beyond, any line stands near some order
constexpr double kClear = 4.0;       // doubts that a move must go further than
constexpr int kMoves = 3;            // one in twenty stands by chance where it should, each time, in four ways to fold
constexpr int kGone = 3;             // looks

}  // namespace

void AliasWatch::prepare(int channels, Hertz rate) {
  kernels_ = dsp::kernels::bestKernels();
  rate_ = rate.value;
  const int frames = dsp::fastFftSize(std::min(static_cast<int>(kWindow * rate_), kMostFrames));
  window_ = static_cast<std::size_t>(frames);
  spectrum_.prepare(frames, rate, dsp::WindowKind::Hann);
  mask_.prepare(spectrum_.bins(), spectrum_.binWidth());
  power_.assign(static_cast<std::size_t>(spectrum_.bins()), 0.0);
  channels_.assign(static_cast<std::size_t>(channels), {});
  for (AliasChannel& c : channels_) c.samples.assign(window_, 0.0);
  reset();
}

void AliasWatch::reset() noexcept {
  for (AliasChannel& c : channels_) {
    c.folds = {};
    c.folded = {};
  }
  fill_ = looked_ = 0;
  waited_ = 0;
  lookSpindle_ = 0.0;
}

// Is a look worth its cost now?
bool AliasWatch::begin(const ConditionedBlock& block) noexcept {
  waited_ += block.frames;
  const bool moved = std::abs(block.spindle.value - lookSpindle_) > kMoved * lookSpindle_;
  if (!moved && static_cast<double>(waited_) < kRest * rate_) return false;
  low_ = high_ = block.spindle.value;
  sum_ = 0.0;
  looked_ = 0;
  waited_ = 0;
  return true;
}

void AliasWatch::push(const ConditionedBlock& block, bool inCut) noexcept {
  if (fill_ == window_) {  // one transform a block
    look(channels_[looked_]);
    if (++looked_ == channels_.size()) fill_ = 0;
    return;
  }
  if (!inCut || !block.speedKnown()) {
    fill_ = 0;
    return;
  }
  if (fill_ == 0 && !begin(block)) return;
  const std::size_t frames = std::min(window_ - fill_, static_cast<std::size_t>(block.frames));
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    std::copy_n(block.channel(static_cast<int>(c)).begin(), frames,
                channels_[c].samples.begin() + static_cast<std::ptrdiff_t>(fill_));
  }
  fill_ += frames;
  low_ = std::min(low_, block.spindle.value);
  high_ = std::max(high_, block.spindle.value);
  sum_ += static_cast<double>(frames) * block.spindle.value;
  if (fill_ < window_) return;
  mean_ = lookSpindle_ = sum_ / static_cast<double>(window_);
  doubt_ = block.spindleSd.value + kSmear * (high_ - low_);
}

void AliasWatch::look(AliasChannel& c) noexcept {
  spectrum_.transform(c.samples);
  spectrum_.powers(power_);
  mask_.update(Hertz(mean_), Hertz(doubt_), kMaskBins, Hertz(kUsableBand * rate_));
  const LineOutside line = strongestOutside(power_, mask_, spectrum_.binWidth(), 1.0, 0, kernels_);
  const bool strong = line.part > kLeastPart && line.purity > kLeastPurity;
  const Folded before = c.folded;
  c.folded = {};
  for (std::size_t i = 0; i < c.folds.size(); ++i) {
    const std::size_t turns = 1 + i / 2;  // two folds, up and down, of each
    const double turned = static_cast<double>(turns) * rate_;
    Fold& fold = c.folds[i];
    const bool away = fold.order != 0 && hidden(std::abs(turned - fold.order * mean_));
    if (!away) follow(fold, strong ? turned + (i % 2 == 0 ? -1.0 : 1.0) * line.frequency.value : 0.0);
    if (fold.moves >= kMoves && c.folded.order == 0) c.folded = away ? before : Folded{line.frequency, fold.order};
  }
}

// On its way a folded order passes the harmonics; there nothing can be told from them.
bool AliasWatch::hidden(double line) const noexcept {
  const double orders = line / mean_;
  return std::abs(orders - std::round(orders)) * mean_ < (kMaskBins + 1.0) * spectrum_.binWidth() + doubt_;
}

// place: n f_sp, were the line this fold of an order; 0: no line.
void AliasWatch::follow(Fold& fold, double place) const noexcept {
  const auto vague = [this](double n) { return kPlaceBins * spectrum_.binWidth() + n * doubt_ > kMostDoubt * mean_; };
  if (fold.order != 0 && vague(fold.order)) return;
  const double order = std::round(place / mean_);
  const double doubt = kPlaceBins * spectrum_.binWidth() + order * doubt_;
  const bool stands = place > 0.0 && !vague(order) && std::abs(place - order * mean_) < doubt;
  if (fold.order != 0 && (!stands || static_cast<int>(order) != fold.order)) {
    if (++fold.misses < (fold.moves >= kMoves ? kGone : 1)) return;
    fold = {};
  }
  if (!stands) return;
  fold.misses = 0;
  if (fold.order == 0) {
    fold.order = static_cast<int>(order);
    fold.spindle = mean_;
  } else if (order * std::abs(mean_ - fold.spindle) > kClear * doubt) {
    ++fold.moves;
    fold.spindle = mean_;
  }
}

}  // namespace stillcut::detect
