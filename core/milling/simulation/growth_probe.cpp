#include "core/milling/simulation/growth_probe.h"

#include <algorithm>
#include <cmath>

#include "core/milling/linear_force.h"

namespace stillcut::milling {

namespace {

constexpr double kNudge = 1e-3;
constexpr double kMemory = 0.01;  // [s], or
constexpr double kPeriods = 4.0;  // tooth periods, the longer of the two
constexpr double kSmallest = 1e-6;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

CutModel linearised(CutModel m, Metres feedPerTooth) {
  m.tool.runout.clear();
  m.material.tangentialEdge = m.material.radialEdge = 0.0;
  // Where the lobes take it as straight.
  m.material = linearisedAt(m.material, meanChip(m, std::max(feedPerTooth, Metres(1e-6))));
  return m;
}

CutNumerics linearNumerics(CutNumerics n) {
  n.mayLeaveCut = false;
  return n;
}

}  // namespace

int companionTick(int tickSteps) {
  return tickSteps % 2 == 0 ? tickSteps / 2 : tickSteps;
}

CutNumerics companionNumerics(CutNumerics plant, int tickSteps) {
  plant.stepsPerRevolution = plant.stepsPerRevolution / tickSteps * companionTick(tickSteps);
  return plant;
}

GrowthProbe::GrowthProbe(const CutModel& model, const CutNumerics& plant, int tickSteps, Metres feedPerTooth)
    : cut_(linearised(model, feedPerTooth), linearNumerics(companionNumerics(plant, tickSteps))),
      tickSteps_(companionTick(tickSteps)),
      periods_(model.tool.pitch.empty() && model.tool.toothHelix.empty() ? model.tool.teeth : 1),
      ticksPerPeriod_(plant.stepsPerRevolution / tickSteps / periods_),
      past_(static_cast<std::size_t>(2 * ticksPerPeriod_), 0.0) {
  for (int i = 0; i < cut_.modes(); ++i) {
    stiffness_[at(i)] = model.modes[at(i)].stiffness;
    mass_[at(i)] = model.modes[at(i)].mass();
    cut_.disturb(i, 1.0 / std::sqrt(stiffness_[at(i)]), 0.0);
  }
}

double GrowthProbe::gain(int perRevolution) const noexcept {
  const int periods = periods_ / std::min(perRevolution, periods_);
  return 2.0 - 2.0 * std::cos(periods * std::acos(std::clamp(cosine_, -1.0, 1.0)));
}

double GrowthProbe::folded() const noexcept {
  return std::acos(std::clamp(cosine_, -1.0, 1.0)) / kTwoPi;
}

double GrowthProbe::energy() const noexcept {
  double sum = 0.0;
  for (int i = 0; i < cut_.modes(); ++i) {
    const double q = cut_.displacement(i), v = cut_.velocity(i);
    sum += stiffness_[at(i)] * q * q + mass_[at(i)] * v * v;
  }
  return sum;
}

void GrowthProbe::advance() noexcept {
  duration_ += tickSteps_ * cut_.stepTime();
  cut_.advance(tickSteps_);
  energySum_ += energy();
  // For one tone that grows: d(t) / g + g d(t - 2T) = 2 cos(2 pi f T) d(t - T), g its growth over T.
  const auto tip = cut_.tip();
  const double d = tip[0] + tip[1];
  const std::size_t period = past_.size() / 2;
  const double middle = past_[(pastAt_ + period) % past_.size()];
  const double g =
      std::exp(std::clamp(growth_ * static_cast<double>(period) * tickSteps_ * cut_.stepTime(), -5.0, 5.0));
  num_ += middle * (d / g + g * past_[pastAt_]);
  den_ += 2.0 * middle * middle;
  past_[pastAt_] = d;
  pastAt_ = (pastAt_ + 1) % past_.size();
  if (++tick_ == ticksPerPeriod_) endPeriod();
}

void GrowthProbe::endPeriod() noexcept {
  const double mean = energySum_ / tick_;
  const double pace = 1.0 - std::exp(-duration_ / std::max(kMemory, kPeriods * duration_));
  // The phase over a revolution needs the phase over a period the more exactly the more of them there are.
  const double slowPace = 1.0 - std::exp(-duration_ / std::max(kMemory, kPeriods * periods_ * duration_));
  if (!first_ && mean > 0.0) growth_ += (0.5 * std::log(mean / energyBefore_) / duration_ - growth_) * pace;
  if (!first_ && den_ > 0.0) cosine_ += (std::clamp(num_ / den_, -1.0, 1.0) - cosine_) * slowPace;
  first_ = false;
  energyBefore_ = mean;
  double size = std::sqrt(std::max(mean, 1e-200));
  if (size < kSmallest || size > 1.0 / kSmallest) {
    cut_.scaleMotion(1.0 / size);
    for (double& p : past_) p /= size;
    energyBefore_ = mean / (size * size);
    size = 1.0;
  }
  for (int i = 0; i < cut_.modes(); ++i) {
    cut_.disturb(i, size * kNudge / std::sqrt(stiffness_[at(i)]) * nudges_.normal(),
                 size * kNudge / std::sqrt(mass_[at(i)]) * nudges_.normal());
  }
  tick_ = 0;
  energySum_ = duration_ = num_ = den_ = 0.0;
}

}  // namespace stillcut::milling
