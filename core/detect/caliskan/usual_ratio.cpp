#include "core/detect/caliskan/usual_ratio.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kTurns = 16.0;  // of a mean
constexpr double kAbove = 4.0;   // what does not repeat over what does, in energy, as onset_test.h asks of growth

}  // namespace

void UsualRatio::learn(double ratio, double turns) {
  mean_ = seen_ > 0.0 ? mean_ + (1.0 - std::exp(-turns / kTurns)) * (ratio - mean_) : ratio;
  const bool first = seen_ < kTurns;
  seen_ += turns;
  if (seen_ >= kTurns) lowest_ = first ? mean_ : std::min(lowest_, mean_);
}

double UsualRatio::limit(double chatterRatio, double part) const {
  const double rest = kAbove * part * lowest_;
  return std::max(part * chatterRatio, rest / (rest + 1.0 - lowest_));
}

}  // namespace stillcut::detect
