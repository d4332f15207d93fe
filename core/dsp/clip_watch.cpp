#include "core/dsp/clip_watch.h"

#include <algorithm>
#include <cmath>

namespace stillcut::dsp {
namespace {

constexpr int kFlat = 3;       // samples; two equal ones a tone at a quarter of the rate has too
constexpr float kDeep = 3.0F;  // steps: more than (1 + 2/3)^2
constexpr int kFlats = 3;
constexpr float kFar = 0.5F;      // of the largest magnitude: what is nearer to zero is rest
constexpr float kForget = 0.98F;  // of it, a block

}  // namespace

// last_ stood for run_ samples between before_ and next.
void ClipWatch::endFlat(float next) noexcept {
  const bool above = before_ < last_ && next < last_;
  const bool below = before_ > last_ && next > last_;
  if (run_ < kFlat || !(above || below) || std::abs(last_) < kFar * loud_) return;
  const float deep = kDeep * step_;
  if (std::abs(last_ - before_) <= deep || std::abs(last_ - next) <= deep) return;
  Limit& limit = limits_[above ? 1 : 0];
  limit.flats = limit.flats > 0 && limit.value == last_ ? std::min(limit.flats + 1, kFlats) : 1;
  limit.value = last_;
}

void ClipWatch::learnStep(float change) noexcept {
  if (change > 0.0F && (step_ == 0.0F || change < step_)) step_ = change;
}

bool ClipWatch::see(std::span<const float> samples) noexcept {
  loud_ *= kForget;
  bool reached = false;
  const float reference = samples.empty() ? 0.0F : samples.front();
  for (const float v : samples) {
    loud_ = std::max(loud_, std::abs(v));
    if (run_ > 0 && v == last_) {
      ++run_;
    } else {
      if (run_ > 0) {
        learnStep(std::abs(v - last_));
        learnStep(std::abs(v - reference));  // a tone that goes with the rate never comes near itself
        if (turned_) endFlat(v);
        before_ = last_;
        turned_ = true;
      }
      last_ = v;
      run_ = 1;
    }
    if (v < limits_[0].value) limits_[0].flats = 0;
    if (v > limits_[1].value) limits_[1].flats = 0;
    for (const Limit& limit : limits_) reached = reached || (limit.flats == kFlats && v == limit.value);
  }
  return reached;
}

}  // namespace stillcut::dsp
