#include "core/milling/stability/limit_band.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {

namespace {

constexpr unsigned kSeed = 20030u;
constexpr double kOutside = 0.1;  // of the draws on either side of the band
constexpr double kLeast = 0.2;    // of its value, what a draw leaves of a quantity at least

// Normal draws that are the same with every standard library.
class Dice {
 public:
  double around(double value, double spread) {
    const double size = std::sqrt(-2.0 * std::log(uniform()));
    return value * std::max(kLeast, 1.0 + spread * size * std::cos(2.0 * std::numbers::pi * uniform()));
  }

 private:
  double uniform() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }
  std::mt19937 random_{kSeed};
};

CutModel drawn(CutModel model, const ModelSpread& spread, Dice& dice) {
  for (Mode& m : model.modes) {
    const Mode before = m;
    m.frequency = Hertz(dice.around(m.frequency.value, spread.frequency));
    m.damping = std::min(0.99, dice.around(m.damping, spread.damping));
    m.stiffness = dice.around(m.stiffness, spread.stiffness);
    for (ModeAtSpeed& row : m.atSpeeds) {
      row.frequency = row.frequency * (m.frequency / before.frequency);
      row.damping = std::min(0.99, row.damping * m.damping / before.damping);
      row.stiffness *= m.stiffness / before.stiffness;
    }
  }
  const double force = dice.around(1.0, spread.force);
  model.material.tangential *= force;
  model.material.radial *= force;
  model.material.processDamping *= force;
  // Drawn only where it is asked for, so that bands without it stay what they were.
  if (spread.processDamping > 0.0) model.material.processDamping *= dice.around(1.0, spread.processDamping);
  return model;
}

}  // namespace

std::vector<CutModel> drawnModels(const CutModel& model, const ModelSpread& spread) {
  Dice dice;
  std::vector<CutModel> models;
  models.reserve(static_cast<std::size_t>(spread.samples));
  for (int i = 0; i < spread.samples; ++i) models.push_back(drawn(model, spread, dice));
  return models;
}

std::size_t outsideBand(const ModelSpread& spread) {
  return static_cast<std::size_t>(std::floor(kOutside * spread.samples));
}

Status check(const ModelSpread& spread, const std::string& where) {
  for (double v : {spread.frequency, spread.damping, spread.stiffness, spread.force, spread.processDamping}) {
    if (!(v >= 0.0) || v > 0.5) return Error{where, message("a spread must lie between 0 and 50 %")};
  }
  if (spread.samples < 8 || spread.samples > 1000) return Error{where, message("samples must be 8 to 1000")};
  return Done{};
}

Result<LimitBands> limitBands(const CutModel& model, std::span<const Rpm> speeds, Metres maxAxialDepth,
                              const ModelSpread& spread, int threads, const std::string& where,
                              const std::stop_token& stop) {
  if (Status ok = check(spread, where); !ok) return ok.error();
  SweepOptions options;
  options.limits = {maxAxialDepth, true, false, {}};
  options.threads = threads;
  std::vector<std::vector<double>> limits(speeds.size());
  LimitBands bands;
  for (const CutModel& one : drawnModels(model, spread)) {
    const Result<LobeSweep> sweep = sweepLobes(one, speeds, options, where, stop);
    if (!sweep) return sweep.error();
    if (!sweep->finished) return bands;
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      const SpeedLimits& l = sweep->speeds[k];
      limits[k].push_back(l.hasLimit() ? l.crossings.front().depth.value : l.searchedTo.value);
    }
  }
  const std::size_t outside = outsideBand(spread);
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    std::sort(limits[k].begin(), limits[k].end());
    bands.speeds.push_back({speeds[k], Metres(limits[k][outside]), Metres(limits[k][limits[k].size() - 1 - outside])});
  }
  bands.finished = true;
  return bands;
}

}  // namespace stillcut::milling
