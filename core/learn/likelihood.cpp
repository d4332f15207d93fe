#include "core/learn/likelihood.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillcut::learn {
namespace {

constexpr double kImmersionStep = 0.02;
// Chatter is looked for in this band; a frequency of another cause is anywhere in it, in equal ratios [Hz].
constexpr double kLowestChatter = 50.0;
constexpr double kHighestChatter = 10000.0;

double normalCdf(double x) {
  return 0.5 * std::erfc(-x * std::numbers::sqrt2 / 2.0);
}

// Density over ln f.
double normalDensity(double x, double sd) {
  const double z = x / sd;
  return std::exp(-0.5 * z * z) / (sd * std::sqrt(kTwoPi));
}

double strayDensity() {
  static const double kDensity = 1.0 / std::log(kHighestChatter / kLowestChatter);
  return kDensity;
}

// Detectors name the strongest member of the chatter's family f + k f_tooth: mostly the one next to the mode.
double frequencyDensity(const Term& term, double predicted) {
  if (!(predicted > 0.0)) return strayDensity();
  const double sd = term.frequencySd;
  const auto at = [&](double member) {
    return member > kLowestChatter ? normalDensity(std::log(term.frequency / member), sd) : 0.0;
  };
  return 0.80 * at(predicted) + 0.05 * at(predicted + term.toothPassing) + 0.05 * at(predicted - term.toothPassing) +
         0.10 * strayDensity();
}

bool sameNumbers(const CutEvidence& a, const CutEvidence& b) {
  const auto near = [](double x, double y, double share) { return std::abs(x - y) <= share * std::max(x, y); };
  return a.outcome == b.outcome && near(a.speed.value, b.speed.value, 0.01) &&
         near(a.depth.value, b.depth.value, 0.03) && near(a.frequency.value, b.frequency.value, 0.02);
}

}  // namespace

bool Shape::covers(const milling::Engagement& engagement, int teethOfCut) const {
  return teethOfCut == teeth && std::abs(engagement.startAngle() - start) < 0.05 &&
         std::abs(engagement.exitAngle() - exit) < 0.05;
}

Shape makeShape(const milling::Engagement& engagement, int teeth, const LearnParams& params) {
  Shape shape;
  milling::Engagement rounded = engagement;
  if (!engagement.offset) {
    rounded.radialImmersion =
        std::clamp(kImmersionStep * std::round(engagement.radialImmersion / kImmersionStep), kImmersionStep, 1.0);
  }
  shape.immersion = rounded.radialImmersion;
  shape.start = rounded.startAngle();
  shape.exit = rounded.exitAngle();
  shape.teeth = teeth;
  shape.force = meanForce(rounded, teeth);
  // The fraction of the time at least one tooth cuts: the zeroth order is as good as that is large.
  const double cutting = std::min(1.0, (shape.exit - shape.start) * teeth / kTwoPi);
  shape.marginSd = params.marginSd + (1.0 - cutting) * (params.interruptedSd - params.marginSd);
  return shape;
}

std::vector<Term> condense(std::span<const CutEvidence> cuts, std::span<const std::size_t> shapeOfCut,
                           std::span<const Shape> shapes, const LearnParams& params) {
  std::vector<Term> terms;
  std::vector<bool> used(cuts.size(), false);
  for (std::size_t i = cuts.size(); i-- > 0;) {  // the newest of equal ones stands for all
    if (used[i]) continue;
    int same = 0;
    for (std::size_t k = 0; k <= i; ++k) {
      if (used[k] || shapeOfCut[k] != shapeOfCut[i] || !sameNumbers(cuts[i], cuts[k])) continue;
      used[k] = true;
      ++same;
    }
    const CutEvidence& cut = cuts[i];
    const auto age = static_cast<double>(cuts.size() - 1 - i);
    const double drift = age * params.driftPerCut * params.driftPerCut;
    Term t;
    t.shape = shapeOfCut[i];
    t.speed = cut.speed.value;
    t.logDepth = std::log(cut.depth.value);
    t.toothPassing = toothPassing(cut.speed, cut.teeth).value;
    t.chatter = cut.outcome == CutOutcome::Chatter;
    t.doubt = std::clamp(cut.doubt, 0.005, 0.5);
    t.frequency = t.chatter ? cut.frequency.value : 0.0;
    const double measured = t.frequency > 0.0 ? cut.frequencySd.value / t.frequency : 0.0;
    t.frequencySd = std::sqrt(params.frequencySd * params.frequencySd + drift + measured * measured);
    t.marginSd = std::hypot(shapes[t.shape].marginSd, params.wearPerCut * std::sqrt(age));
    t.speedSd = std::sqrt(params.speedSd * params.speedSd + drift);
    t.weight = same / (1.0 + (same - 1) * params.sharedError);
    terms.push_back(t);
  }
  return terms;
}

// The mean over three speeds stands for where the lobes may lie (Gauss and Hermite).
double probabilityOfChatter(const Term& term, std::span<const LimitPoint> table, const SpeedGrid& grid) {
  const double step = std::numbers::sqrt3 * term.speedSd;
  const auto at = [&](double speed) {
    return normalCdf((term.logDepth - limitAt(table, grid, speed).logDepth) / term.marginSd);
  };
  return (4.0 * at(term.speed) + at(term.speed * (1.0 - step)) + at(term.speed * (1.0 + step))) / 6.0;
}

double logLikelihood(const Term& term, std::span<const LimitPoint> table, const SpeedGrid& grid,
                     const LearnParams& params) {
  const double p = probabilityOfChatter(term, table, grid);
  const double stray = params.strayChatter;
  if (!term.chatter) return std::log((1.0 - stray) * (1.0 - p) + term.doubt * p);
  if (!(term.frequency > 0.0)) return std::log((1.0 - term.doubt) * p + stray * (1.0 - p) + 1e-9);
  const double predicted = limitAt(table, grid, term.speed).frequency;
  return std::log((1.0 - term.doubt) * p * frequencyDensity(term, predicted) + stray * strayDensity() + 1e-12);
}

double logLikelihood(std::span<const Term> terms, LimitTables tables, const SpeedGrid& grid,
                     const LearnParams& params) {
  double sum = 0.0;
  for (const Term& t : terms) sum += t.weight * logLikelihood(t, tables[t.shape], grid, params);
  return sum;
}

}  // namespace stillcut::learn
