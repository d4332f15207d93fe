#include "tests/support/hidden_machines/hidden_machine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/milling/stability/exact_lobes.h"

namespace stillcut::test {
namespace {

using learn::Random;
using milling::MillingDirection;

const std::array<milling::Engagement, 4> kWork{
    milling::Engagement{1.0, MillingDirection::Down}, milling::Engagement{0.5, MillingDirection::Down},
    milling::Engagement{0.5, MillingDirection::Up}, milling::Engagement{0.26, MillingDirection::Down}};

double logBetween(Random& random, double low, double high) {
  return low * std::pow(high / low, random.uniform());
}

milling::Mode modeAlong(int axis, double frequency, double damping, double stiffness) {
  milling::Mode m;
  m.frequency = Hertz(frequency);
  m.damping = damping;
  m.stiffness = stiffness;
  m.direction = {axis == 0 ? 1.0 : 0.0, axis == 0 ? 0.0 : 1.0};
  return m;
}

}  // namespace

milling::CutModel HiddenMachine::after(int cuts) const {
  milling::CutModel now = model;
  for (milling::Mode& m : now.modes) m.frequency *= std::exp(drift * cuts / 30.0);
  return now;
}

HiddenMachine hiddenMachine(std::uint64_t seed) {
  Random random(seed * 7919 + 17);
  HiddenMachine machine;
  milling::Tool& tool = machine.model.tool;
  constexpr std::array<double, 5> kDiameters{8e-3, 10e-3, 12e-3, 16e-3, 20e-3};
  tool.diameter = Metres(kDiameters[static_cast<std::size_t>(random.below(5))]);
  tool.teeth = 2 + random.below(3);
  const double size = tool.diameter.value / 0.012;
  const double frequency = logBetween(random, 500.0, 2400.0) * std::pow(size, -0.4);
  const double stiffness = logBetween(random, 7e6, 5e7) * size;
  for (int axis = 0; axis < 2; ++axis) {
    machine.model.modes.push_back(modeAlong(axis, frequency * random.uniform(0.88, 1.12), random.uniform(0.015, 0.06),
                                            stiffness * random.uniform(0.7, 1.4)));
  }
  if (random.uniform() < 0.4) {
    machine.model.modes.push_back(modeAlong(random.below(2), frequency * random.uniform(1.5, 2.3),
                                            random.uniform(0.015, 0.05), stiffness * random.uniform(1.5, 4.0)));
  }
  for (int i = 0; i < tool.teeth; ++i) tool.runout.emplace_back(random.uniform(-5e-6, 5e-6));
  milling::Material& material = machine.model.material;
  material.tangential = 7.5e8 * std::exp(0.15 * random.normal());
  material.radial = material.tangential * 0.3 * std::exp(0.2 * random.normal());
  machine.model.engagement = kWork[static_cast<std::size_t>(random.below(4))];
  machine.highest = Rpm(random.uniform(10000.0, 20000.0));
  machine.lowest = machine.highest * 0.25;
  machine.deepest = tool.diameter;
  machine.drift = random.uniform(-0.05, 0.05);
  return machine;
}

TrueLimit trueLimit(const milling::CutModel& model, Rpm speed, Metres deepest) {
  const auto lobes = milling::ExactLobes::make(model, "hidden machine");
  if (!lobes) return {};
  milling::LimitOptions options;
  options.maxAxialDepth = deepest;
  options.firstOnly = true;
  const auto limits = lobes->limits(speed, options);
  if (!limits || !limits->hasLimit()) return {deepest.value, Hertz{}};
  return {limits->crossings.front().depth.value, limits->crossings.front().frequency};
}

learn::CutEvidence makeCut(const HiddenMachine& machine, int cuts, Rpm speed, Metres depth,
                           const milling::Engagement& engagement, Random& random) {
  milling::CutModel model = machine.after(cuts);
  model.engagement = engagement;
  const Metres real = depth * (1.0 + 0.03 * random.normal());
  const TrueLimit limit = trueLimit(model, speed, machine.deepest * 1.5);
  learn::CutEvidence cut;
  cut.assembly = {"Mill 1", "T1", "ER32", Metres(4.0 * model.tool.diameter.value)};
  cut.material = machine.material;
  cut.teeth = model.tool.teeth;
  cut.diameter = model.tool.diameter;
  cut.speed = speed;
  cut.depth = depth;
  cut.engagement = engagement;
  cut.time_s = 1'700'000'000 + 600 * cuts;
  bool chatter = real.value > limit.depth;
  double frequency = limit.frequency.value;
  if (!chatter && random.uniform() < 0.015) {
    chatter = true;
    frequency = logBetween(random, 200.0, 4000.0);
  } else if (random.uniform() < 0.015) {
    chatter = !chatter;
  }
  if (chatter) {
    cut.outcome = learn::CutOutcome::Chatter;
    cut.frequency = Hertz(std::max(0.0, frequency * (1.0 + 0.005 * random.normal())));
    cut.frequencySd = cut.frequency * 0.005;
  }
  return cut;
}

OrdinaryShop::OrdinaryShop(const HiddenMachine& machine, std::uint64_t seed) : machine_(machine), random_(seed) {
  for (int i = 0; i < 3; ++i) {
    speeds_.push_back(random_.uniform(machine.lowest.value, machine.highest.value));
    depths_.push_back(0.06 * machine.model.tool.diameter.value);
  }
}

learn::CutEvidence OrdinaryShop::next() {
  const auto job = static_cast<std::size_t>(random_.below(3));
  const milling::Engagement engagement =
      random_.uniform() < 0.7 ? machine_.model.engagement : kWork[static_cast<std::size_t>(random_.below(4))];
  const Rpm speed(std::round(speeds_[job] * random_.uniform(0.97, 1.03)));
  const learn::CutEvidence cut = makeCut(machine_, made_++, speed, Metres(depths_[job]), engagement, random_);
  depths_[job] *= cut.outcome == learn::CutOutcome::Chatter ? 0.7 : random_.uniform(1.0, 1.3);
  depths_[job] = std::min(depths_[job], machine_.deepest.value);
  return cut;
}

learn::MachinePrior tapped(const HiddenMachine& machine, Random& random) {
  std::vector<milling::Mode> modes = machine.model.modes;
  for (milling::Mode& m : modes) {
    m.frequency *= 1.0 + 0.005 * random.normal();
    m.damping *= std::exp(0.08 * random.normal());
    m.stiffness *= std::exp(0.06 * random.normal());
  }
  milling::Material nominal;
  nominal.tangential = 7.5e8;
  nominal.radial = 0.3 * nominal.tangential;
  std::vector<learn::PriorMode> tapped;
  for (const milling::Mode& m : modes) tapped.push_back({m, {}});
  return learn::priorOfTap(tapped, nominal);
}

}  // namespace stillcut::test
