#include "tests/support/truth_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "core/milling/linear_force.h"
#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::test {
namespace {

using namespace milling;

constexpr double kEnoughFolds = 15.0;  // from what noise leaves to what a forced vibration is
constexpr double kSameLine = 0.05;     // of a period's frequency

double between(NoiseSource& random, double a, double b) {
  return a + (b - a) * random.uniform();
}

void setTool(Tool& tool, NoiseSource& random, CutKind kind) {
  tool.teeth = (kind == CutKind::Plain ? 1 : 2) + static_cast<int>(4.0 * random.uniform());
  tool.diameter = Metres(between(random, 10e-3, 20e-3));
  if (kind == CutKind::Helix || kind == CutKind::UnlikeHelix) tool.helix = between(random, 0.2, 0.8);
  for (int j = 0; kind == CutKind::UnlikeHelix && j < tool.teeth; ++j) {
    tool.toothHelix.push_back(tool.helix + (j % 2 == 0 ? 0.03 : -0.03));
  }
  const double even = kTwoPi / tool.teeth;
  for (int j = 0; kind == CutKind::UnevenPitch && j < tool.teeth; ++j) {
    const bool odd = j + 1 == tool.teeth && tool.teeth % 2 == 1;
    tool.pitch.push_back(odd ? even : even * (j % 2 == 0 ? 1.15 : 0.85));
  }
}

}  // namespace

const char* cutKindName(CutKind kind) {
  static constexpr std::array<const char*, 5> kNames{"plain", "helix", "uneven pitch", "power law",
                                                     "helix for each tooth"};
  return kNames[static_cast<std::size_t>(kind)];
}

Scenario randomCut(NoiseSource& random, CutKind kind) {
  Scenario s;
  s.name = "random";
  const int modes = 1 + static_cast<int>(2.0 * random.uniform());
  for (int i = 0; i < modes; ++i) {
    const double angle = between(random, 0.0, kTwoPi);
    s.model.modes.push_back({Hertz(between(random, 400.0, 1000.0)),
                             between(random, 0.01, 0.04),
                             1e6 * std::pow(10.0, random.uniform()),
                             {std::cos(angle), std::sin(angle)}});
  }
  setTool(s.model.tool, random, kind);
  const bool low = random.uniform() < 0.5;
  s.model.engagement = {low ? between(random, 0.03, 0.15) : between(random, 0.15, 1.0),
                        random.uniform() < 0.5 ? MillingDirection::Up : MillingDirection::Down};
  s.programme.feedPerTooth = Metres(0.08e-3);
  Material& m = s.model.material;
  m.tangential = 8e8;
  m.radial = 2.5e8;
  if (kind == CutKind::PowerLaw) {
    // The same slope at the mean chip.
    m.exponent = between(random, 0.7, 0.9);
    const double slope =
        m.exponent * std::pow(meanChip(s.model.engagement, s.programme.feedPerTooth).value, m.exponent - 1.0);
    m.tangential /= slope;
    m.radial /= slope;
  }
  s.programme.speed = Rpm(between(random, 6000.0, 18000.0));
  s.programme.duration = Seconds(2.5);
  s.programme.randomForce = 2e-3;
  s.drive.inertia = 0.02;  // the speed stays
  s.helixSlices = s.model.tool.helix != 0.0 ? 16 : 1;
  SensorSettings tip;
  tip.name = "y";
  tip.quantity = SensorQuantity::Displacement;
  tip.axis = "y";
  s.sensors = {tip};
  return s;
}

Result<std::optional<KnownLimit>> knownLimit(const Scenario& scenario) {
  CutModel model = scenario.model;
  lineariseForLobes(model, scenario.programme.feedPerTooth);
  const auto lobes = ExactLobes::make(model, scenario.name);
  if (!lobes) return lobes.error();
  const auto limits = lobes->limits(scenario.programme.speed, {Metres(12e-3), false, true, {}});
  if (!limits) return limits.error();
  if (!limits->hasLimit()) return std::optional<KnownLimit>();
  return std::optional(KnownLimit{limits->crossings.front(), *limits});
}

double growthOf(const Scenario& scenario, Metres depth) {
  constexpr int kRevolutions = 200, kLooks = 128, kSteps = 16;
  CutModel model = scenario.model;
  lineariseForLobes(model, scenario.programme.feedPerTooth);
  model.tool.runout.clear();
  CutNumerics n;
  n.stepsPerRevolution = kLooks * kSteps / model.tool.teeth * model.tool.teeth;
  n.slices = scenario.helixSlices;
  n.deepest = depth;
  n.mayLeaveCut = false;
  RegenerativeCut cut(model, n);
  const double perSecond = scenario.programme.speed.value / 60.0;
  cut.setSpeed(kTwoPi * perSecond);
  const AngularWindow window{model.engagement.startAngle(), model.engagement.exitAngle()};
  cut.setWindows({&window, 1});
  cut.setAxialDepth(depth.value);
  for (int i = 0; i < cut.modes(); ++i) cut.disturb(i, 1e-6 * (i + 1), 0.0);
  double grown = 0.0;
  for (int r = 0; r < kRevolutions; ++r) {
    double power = 0.0;
    for (int i = 0; i < kLooks; ++i) {
      cut.advance(n.stepsPerRevolution / kLooks);
      for (int k = 0; k < cut.modes(); ++k) {
        power += model.modes[static_cast<std::size_t>(k)].stiffness * cut.displacement(k) * cut.displacement(k);
      }
    }
    const double size = std::sqrt(std::max(power, 1e-300));
    if (r >= kRevolutions / 2) grown += std::log(size);
    cut.scaleMotion(1.0 / size);
  }
  return grown / (kRevolutions - kRevolutions / 2) * perSecond;
}

Comparison compareWithTruth(Scenario s, const KnownLimit& known, double factor) {
  const Metres depth = factor * known.first.depth;
  Comparison c;
  c.unstable = known.limits.outsideAt(depth) > 0;
  if (c.unstable) c.folds = growthOf(s, depth) * 0.8 * s.programme.duration.value;
  if (c.unstable && c.folds < kEnoughFolds) {
    c.agreement = Agreement::NoTimeToGrow;
    return c;
  }
  s.programme.depth = constantSchedule(depth.value);
  SimulatedCut cut(s);
  SampleBlock block;
  block.allocate(static_cast<int>(s.sensors.size()), s.blockFrames);
  while (cut.fill(block)) {
  }
  c.kind = cut.truth().kind();
  c.hz = cut.truth().chatterFrequency().value;
  c.peak = cut.truth().peakRatio();
  const bool found = c.kind != ChatterKind::Unknown;
  if (c.unstable != found) {
    c.agreement = found ? Agreement::FalseChatter : Agreement::UnnamedChatter;
  } else if (found) {
    // Any line of the family: the loudest at the tip's acceleration need not be that of its displacement.
    const bool alike = s.model.tool.pitch.empty() && s.model.tool.toothHelix.empty();
    const double period = 60.0 / (s.programme.speed.value * (alike ? s.model.tool.teeth : 1));
    const double order = (c.hz - known.first.frequency.value) * period,
                 twin = (c.hz + known.first.frequency.value) * period;
    const double off = std::min(std::abs(order - std::round(order)), std::abs(twin - std::round(twin)));
    if (off > kSameLine) c.agreement = Agreement::OtherFrequency;
  }
  return c;
}

std::string comparisonText(const Scenario& s, const KnownLimit& known, double factor, const Comparison& c) {
  std::array<char, 400> line{};
  static constexpr std::array<const char*, 5> kWords{"agrees", "no time to grow", "stable, called chatter",
                                                     "unstable, not called chatter", "another frequency"};
  std::snprintf(line.data(), line.size(),
                "%s: %d teeth, immersion %.3f %s, helix %.0f deg, exponent %.2f, %.0f rpm, %.1f x %.3f mm (%s at "
                "%.1f Hz, %.0f "
                "e-folds): found %.1f Hz, peak ratio %.3f",
                kWords[static_cast<std::size_t>(c.agreement)], s.model.tool.teeth, s.model.engagement.radialImmersion,
                s.model.engagement.side == MillingDirection::Up ? "up" : "down", s.model.tool.helix * 360.0 / kTwoPi,
                s.model.material.exponent, s.programme.speed.value, factor, 1e3 * known.first.depth.value,
                crossingName(known.first.kind), known.first.frequency.value, c.folds, c.hz, c.peak);
  return line.data();
}

}  // namespace stillcut::test
