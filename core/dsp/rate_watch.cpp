#include "core/dsp/rate_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/model/device_flags.h"

namespace stillcut::dsp {
namespace {

constexpr double kKnownAfter = 1.0;  // s
constexpr double kUsualWait = 1.5;   // s, of a device whose rate is the nominal one
constexpr double kLeastWait = 0.1;
constexpr double kFewest = 8.0;   // blocks
constexpr double kRecent = 10.0;  // s
constexpr double kLag = 1e-3;     // s
constexpr double kWrong = 0.005;  // a chatter frequency that is 0.5 % wrong sends the spindle astray
constexpr double kDoubts = 3.0;
constexpr double kMostRate = 1000.0;  // times the nominal one

}  // namespace

void RateWatch::prepare(Hertz nominal) noexcept {
  nominal_ = nominal.value;
  reset();
}

void RateWatch::reset() noexcept {
  long_ = recent_ = {};
  unchecked_ = pending_ = false;
}

void RateWatch::push(const SampleBlock& block) noexcept {
  // The stamps jump where the first arrivals have shown another rate; those before followed the nominal one.
  if (unchecked_ && block.has(kBlockGap)) long_ = recent_ = {};
  pendingFor_ = std::max(
      kLeastWait, (block.has(kBlockRateUnverified) && !pending_ ? kUsualWait : pendingFor_) - block.frames / nominal_);
  unchecked_ = block.has(kBlockRateUnverified);
  if (recent_.seconds >= kRecent) long_ = std::exchange(recent_, {});
  long_.push(block, nominal_);
  recent_.push(block, nominal_);
  pending_ = unchecked_ || (pending_ && !(long_.rate.value > 0.0));
}

// y is how far the stamp is from where the nominal rate puts it, so that nothing large is subtracted.
void RateWatch::Lines::push(const SampleBlock& block, double nominal) noexcept {
  if (block.has(kBlockGap) || n < 0.5) {
    first = block.firstSample;
    frames = n = meanX = meanY = 0.0;
    lines += 1.0;
  }
  const double x = frames / nominal;
  const double y = secondsBetween(first, block.firstSample).value - x;
  const double step = n > 0.5 ? y - lastY : 0.0;
  lastY = y;
  steps += step * step;
  frames += block.frames;
  seconds += block.frames / nominal;
  all += 1.0;
  n += 1.0;
  const double dx = x - meanX;
  const double dy = y - meanY;
  meanX += dx / n;
  meanY += dy / n;
  xx += dx * (x - meanX);
  xy += dx * (y - meanY);
  yy += dy * (y - meanY);
  if (seconds < kKnownAfter || all < kFewest || !(xx > 0.0)) return;
  const double slope = std::max(xy / xx, 1.0 / kMostRate - 1.0);  // seconds too many per second
  const double left = std::max(0.0, yy - slope * xy);
  const double scatter = left / std::max(1.0, all - lines - 1.0);
  const double drift = slope * seconds / all;  // of a step, that is the line's own
  const double apart = left > 0.0 ? std::clamp((steps - all * drift * drift) / (2.0 * left), 1e-9, 1.0) : 1.0;
  const double alike = std::min((2.0 - apart) / apart, all);
  rate = Hertz(nominal / (1.0 + slope));
  sd = Hertz(nominal * (std::sqrt(scatter * alike / xx) + kLag / seconds));
}

bool RateWatch::wrong(const Lines& lines) const noexcept {
  return lines.rate.value > 0.0 && std::abs(lines.rate.value - nominal_) > kWrong * nominal_ + kDoubts * lines.sd.value;
}

}  // namespace stillcut::dsp
