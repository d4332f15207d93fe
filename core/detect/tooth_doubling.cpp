#include "core/detect/tooth_doubling.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kSmallest = 5e-3;  // of the other orders' energy: 7 % of their amplitude

constexpr double kOtherSpeed = 5e-3;

}  // namespace

void ToothDoubling::setSpindle(Hertz spindle) noexcept {
  onset_.setSpindle(spindle);
  if (grown() || std::abs(spindle.value - learnedAt_.value) < kOtherSpeed * spindle.value) return;
  learnedAt_ = spindle;
  relearn();
}

void ToothDoubling::prepare(int teeth, int eta) noexcept {
  teeth_ = teeth % 2 == 0 ? teeth : 0;
  eta_ = eta;
  share_ = weightedShare_ = purity_ = 0.0;
  order_ = 0;
  learnedAt_ = {};
  relearn();
}

void ToothDoubling::setEvidence(double evidence) noexcept {
  onset_.prepare({kSmallest, evidence});
}

void ToothDoubling::endHop(const EnergyChain& chain, int channel) noexcept {
  if (teeth_ < 2) return;
  double all = 0.0;
  double odd = 0.0;
  double weightedAll = 0.0;
  double weightedOdd = 0.0;
  double strongest = 0.0;
  for (int n = 1; n <= chain.active(); ++n) {
    const double power = chain.harmonicPower(channel, n);
    const double weight = eta_ == 0 ? 1.0 : eta_ > 0 ? 1.0 * n * n : 1.0 / (1.0 * n * n);
    all += power;
    weightedAll += power * weight;
    if (n % teeth_ != teeth_ / 2) continue;
    odd += power;
    weightedOdd += power * weight;
    if (power <= strongest) continue;
    strongest = power;
    order_ = n;
  }
  energy_ = odd;
  share_ = all > odd ? odd / (all - odd) : 0.0;
  weightedShare_ = weightedAll > 0.0 ? weightedOdd / weightedAll : 0.0;
  purity_ = odd > 0.0 ? strongest / odd : 0.0;
}

void ToothDoubling::test(double turns, bool learn) noexcept {
  if (teeth_ >= 2) onset_.update(share_, turns, learn, energy_);
}

double ToothDoubling::severity() const noexcept {
  return grown() && share_ > 0.0 ? weightedShare_ * std::max(0.0, 1.0 - onset_.floor() / share_) : 0.0;
}

}  // namespace stillcut::detect
