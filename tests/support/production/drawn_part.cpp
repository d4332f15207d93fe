#include "tests/support/production/drawn_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/conversions.h"
#include "core/milling/simulation/noise.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::test {
namespace {

using namespace milling;

double between(NoiseSource& random, double a, double b) {
  return a + (b - a) * random.uniform();
}
// In equal ratios.
double ratio(NoiseSource& random, double a, double b) {
  return a * std::pow(b / a, random.uniform());
}
int whole(NoiseSource& random, int least, int most) {
  return std::min(most, least + static_cast<int>((most - least + 1) * random.uniform()));
}

void drawMachine(Scenario& s, NoiseSource& random) {
  const double first = ratio(random, 500.0, 2500.0);
  const double stiffness = ratio(random, 1e7, 6e7);
  s.model.modes = {
      {Hertz(first), between(random, 0.02, 0.05), stiffness, {1.0, 0.0}},
      {Hertz(first * between(random, 0.9, 1.15)), between(random, 0.02, 0.05), stiffness, {0.0, 1.0}},
      {Hertz(first * between(random, 1.8, 3.0)), between(random, 0.02, 0.05), 3.0 * stiffness, {1.0, 0.0}}};
  Tool& tool = s.model.tool;
  tool = {};
  tool.teeth = whole(random, 2, 6);
  tool.diameter = Metres(ratio(random, 6e-3, 25e-3));
  tool.helix = between(random, 0.5, 0.8);
  for (int j = 0; j < tool.teeth; ++j) tool.runout.emplace_back(1e-6 * between(random, -5.0, 5.0));
  Material& m = s.model.material;
  m.tangential = ratio(random, 6e8, 2.2e9);
  m.radial = m.tangential * between(random, 0.25, 0.45);
  m.tangentialEdge = between(random, 8e3, 3e4);
  m.radialEdge = m.tangentialEdge * between(random, 0.6, 1.0);
  s.programme.feedPerTooth = Metres(between(random, 0.004, 0.008) * tool.diameter.value);
}

struct Operation {
  Rpm speed;
  double immersion, corner;  // a/D; the corner's too
  Metres depth;
};

// The least depth that is unstable at the speed and 3 % around it.
Result<Metres> limitOf(const Scenario& s, const Operation& o, double immersion) {
  CutModel model = s.model;
  model.tool.runout.clear();
  model.engagement.radialImmersion = immersion;
  const auto lobes = ExactLobes::make(model, s.name);
  if (!lobes) return lobes.error();
  Metres least = model.tool.diameter;
  for (const double around : {0.97, 0.985, 1.0, 1.015, 1.03}) {
    const auto limits = lobes->limits(Rpm(around * o.speed.value), {model.tool.diameter, false, true, {}});
    if (!limits) return limits.error();
    if (limits->hasLimit()) least = std::min(least, limits->crossings.front().depth);
  }
  return least;
}

// A value from `from` on, reached over `ramp` from the one before.
void step(Schedule& schedule, double from, double ramp, double value) {
  const double before = schedule.segments.empty() ? value : schedule.segments.back().toValue;
  if (!schedule.segments.empty()) schedule.segments.back().to = from;
  schedule.segments.push_back({from, from + ramp, before, value, RampShape::Smoothstep});
  schedule.segments.push_back({from + ramp, from + ramp, value, value, RampShape::Linear});
}

void addCorners(Schedule& immersion, const Operation& o, double begin, double end, NoiseSource& random) {
  for (double at = begin + between(random, 0.5, 2.0); at + 1.6 < end; at += between(random, 2.0, 4.0)) {
    step(immersion, at, between(random, 0.05, 0.2), o.corner);
    step(immersion, at + between(random, 0.4, 1.0), between(random, 0.05, 0.2), o.immersion);
  }
}

}  // namespace

Result<Scenario> drawnPart(const Scenario& base, std::uint64_t seed, double ofLimit) {
  NoiseSource random(seed);
  Scenario s = base;
  s.seed = seed;
  s.name = "part-" + std::to_string(seed);
  s.helixSlices = 3;  // half of the base's: a day of parts is long
  drawMachine(s, random);
  s.model.engagement.side = random.uniform() < 0.5 ? MillingDirection::Up : MillingDirection::Down;
  const double cutting = ratio(random, 60.0, 500.0) / 60.0;  // [m/s]
  const Rpm usual(std::clamp(60.0 * cutting / (std::numbers::pi * s.model.tool.diameter.value), 1500.0, 18000.0));
  Programme& p = s.programme;
  p.entry = p.exit = std::nullopt;
  p.depth = p.immersion = p.speedOverTime = p.feedPerToothOverTime = {};
  const int operations = whole(random, 3, 6);
  const double each = p.duration.value / operations;
  for (int k = 0; k < operations; ++k) {
    Operation o{Rpm(usual.value * between(random, 0.75, 1.25)), ratio(random, 0.08, 1.0), 0.0, {}};
    o.corner = std::min(1.0, o.immersion * between(random, 1.2, 2.0));
    for (const double immersion : {o.immersion, 0.5 * (o.immersion + o.corner), o.corner}) {
      const auto limit = limitOf(s, o, immersion);
      if (!limit) return limit.error();
      const Metres depth = ofLimit * *limit;
      o.depth = o.depth.value > 0.0 ? std::min(o.depth, depth) : depth;
    }
    const double begin = k * each, in = begin + 1.5, out = begin + each - 0.5;
    if (k == 0) p.speed = o.speed;
    step(p.speedOverTime, begin, k == 0 ? 0.0 : 0.8, o.speed.value);
    step(p.immersion, begin, 0.1, o.immersion);
    step(p.depth, begin, 0.1, 0.0);
    step(p.depth, in, between(random, 0.02, 0.5), o.depth.value);
    addCorners(p.immersion, o, in, out, random);
    step(p.depth, out, between(random, 0.02, 0.3), 0.0);
  }
  for (Schedule* schedule : {&p.depth, &p.immersion, &p.speedOverTime}) {
    schedule->segments.back().to = p.duration.value;
    std::erase_if(schedule->segments, [](const ScheduleSegment& g) { return !(g.to > g.from); });
  }
  if (const Status fine = milling::check(s, s.name); !fine) return fine.error();
  return s;
}

}  // namespace stillcut::test
