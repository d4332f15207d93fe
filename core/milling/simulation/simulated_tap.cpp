#include "core/milling/simulation/simulated_tap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stillcut::milling {
namespace {

constexpr int kSubsteps = 4;  // the force within a sample is constant only nearly

double clip(double value, double range) {
  return std::clamp(value, -range, range);
}

}  // namespace

TapStructure usualTapStructure() {
  TapStructure s;
  s.modes = {{Hertz(872.0), 0.031, 2.4e7, {1.0, 0.0}},
             {Hertz(1654.0), 0.024, 3.9e7, {1.0, 0.0}},
             {Hertz(918.0), 0.028, 2.7e7, {0.0, 1.0}},
             {Hertz(1712.0), 0.026, 4.4e7, {0.0, 1.0}}};
  return s;
}

SimulatedTap::SimulatedTap(TapStructure structure, std::uint64_t seed)
    : structure_(std::move(structure)), noise_(seed) {
  const double h = 1.0 / (structure_.rate.value * kSubsteps);
  for (const Mode& mode : structure_.modes) {
    Oscillator o;
    o.w = kTwoPi * mode.frequency.value;
    o.damping = mode.damping;
    o.mass = mode.mass();
    o.direction = mode.direction;
    // Exact for a force that is constant over the substep.
    const double decay = mode.damping * o.w;
    const double wd = o.w * std::sqrt(1.0 - mode.damping * mode.damping);
    const double e = std::exp(-decay * h), c = std::cos(wd * h), s = std::sin(wd * h);
    o.qq = e * (c + decay / wd * s);
    o.qv = e * s / wd;
    o.vq = -e * o.w * o.w / wd * s;
    o.vv = e * (c - decay / wd * s);
    o.qf = (1.0 - o.qq) / (o.w * o.w);
    o.vf = -o.vq / (o.w * o.w);
    modes_.push_back(o);
  }
}

void SimulatedTap::strike(const TapBlow& blow) {
  blow_ = blow;
  const double c = std::cos(blow.lean), s = std::sin(blow.lean);
  blow_.along = {c * blow.along[0] - s * blow.along[1], s * blow.along[0] + c * blow.along[1]};
  sinceBlow_ = 0.0;
}

double SimulatedTap::forceAt(double t) const noexcept {
  const auto pulse = [&](double since) {
    return since > 0.0 && since < blow_.width ? std::sin(std::numbers::pi * since / blow_.width) : 0.0;
  };
  return blow_.force * (pulse(t) + (blow_.bounce > 0.0 ? blow_.bounce * pulse(t - blow_.bounceAfter) : 0.0));
}

SimulatedTap::Sample SimulatedTap::step() noexcept {
  const double h = 1.0 / (structure_.rate.value * kSubsteps);
  Sample out;
  const double force = forceAt(sinceBlow_);
  for (Oscillator& o : modes_) {
    const double along = o.direction[0] * blow_.along[0] + o.direction[1] * blow_.along[1];
    const double acceleration = along * force / o.mass - 2.0 * o.damping * o.w * o.v - o.w * o.w * o.q;
    for (std::size_t axis = 0; axis < 2; ++axis) out.acceleration[axis] += o.direction[axis] * acceleration;
  }
  for (int k = 0; k < kSubsteps; ++k) {
    const double between = forceAt(sinceBlow_ + (k + 0.5) * h);
    for (Oscillator& o : modes_) {
      const double along = o.direction[0] * blow_.along[0] + o.direction[1] * blow_.along[1];
      const double f = along * between / o.mass;
      const double q = o.qq * o.q + o.qv * o.v + o.qf * f;
      o.v = o.vq * o.q + o.vv * o.v + o.vf * f;
      o.q = q;
    }
  }
  sinceBlow_ += 1.0 / structure_.rate.value;
  out.force = clip(force + structure_.forceNoise * noise_.normal(), structure_.forceRange);
  for (double& a : out.acceleration) {
    a = clip(a + structure_.responseNoise * noise_.normal(), structure_.responseRange);
  }
  return out;
}

}  // namespace stillcut::milling
