#include "core/detect/rate_watch.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kKnownAfter = 1.0;  // s
constexpr double kFewest = 8.0;      // blocks
constexpr double kWrong = 0.005;     // a chatter frequency that is 0.5 % wrong sends the spindle astray
constexpr double kDoubts = 3.0;

}  // namespace

void RateWatch::prepare(Hertz nominal) noexcept {
  nominal_ = nominal.value;
  reset();
}

void RateWatch::reset() noexcept {
  frames_ = n_ = meanX_ = meanY_ = xx_ = xy_ = yy_ = 0.0;
  rate_ = sd_ = {};
}

// y is how far the stamp is from where the told rate puts it, so that nothing large is subtracted.
void RateWatch::push(const SampleBlock& block) noexcept {
  if (block.has(kBlockGap)) reset();
  if (n_ < 0.5) first_ = block.firstSample;
  const double x = frames_ / nominal_;
  const double y = secondsBetween(first_, block.firstSample).value - x;
  frames_ += block.frames;
  n_ += 1.0;
  const double dx = x - meanX_;
  const double dy = y - meanY_;
  meanX_ += dx / n_;
  meanY_ += dy / n_;
  xx_ += dx * (x - meanX_);
  xy_ += dx * (y - meanY_);
  yy_ += dy * (y - meanY_);
  if (x < kKnownAfter || n_ < kFewest) return;
  const double slope = xy_ / xx_;  // seconds too many per second
  const double scatter = std::max(0.0, yy_ - slope * xy_) / (n_ - 2.0);
  rate_ = Hertz(nominal_ / (1.0 + slope));
  sd_ = Hertz(nominal_ * std::sqrt(scatter / xx_));
}

bool RateWatch::wrong() const noexcept {
  return rate_.value > 0.0 && std::abs(rate_.value - nominal_) > kWrong * nominal_ + kDoubts * sd_.value;
}

}  // namespace stillcut::detect
