#include <algorithm>
#include <cmath>

#include "app/session/tap/tap_work.h"
#include "core/milling/stability/advice/recommended_cut.h"
#include "core/milling/stability/lobe_sweep.h"
#include "ui/base/say.h"

namespace stillcut::app {
namespace {

constexpr int kSpeeds = 80;
constexpr int kDraws = 8;
// Doubt that the scatter of a fit does not hold: another clamping, a warm spindle, a hammer off its axis.
constexpr double kFrequencyDoubt = 0.01, kDampingDoubt = 0.1, kStiffnessDoubt = 0.07;
constexpr double kMost = 0.5;  // that a spread may be

double spreadOf(const std::vector<identify::IdentifiedMode>& modes, double least,
                double (*of)(const identify::IdentifiedMode&)) {
  double most = least;
  for (const auto& m : modes) most = std::max(most, of(m));
  return std::min(most, kMost);
}

ui::TapLobes problem(const ui::TapCut& cut, const Error& error) {
  ui::TapLobes lobes;
  lobes.state = ui::TapLobes::State::Failed;
  lobes.cut = cut;
  lobes.problem = ui::sayError(error);
  return lobes;
}

}  // namespace

milling::CutModel cutModel(const std::vector<identify::IdentifiedMode>& modes, const milling::Material& material,
                           const ui::TapCut& cut) {
  milling::CutModel model;
  for (const auto& m : modes) model.modes.push_back(m.mode);
  model.tool.teeth = cut.teeth;
  model.tool.diameter = cut.diameter;
  model.material = material;
  model.engagement.radialImmersion = cut.immersion;
  model.engagement.side = cut.upMilling ? milling::MillingDirection::Up : milling::MillingDirection::Down;
  return model;
}

ui::TapLobes tapLobes(const std::vector<identify::IdentifiedMode>& modes, const milling::Material& material,
                      double materialSpread, const ui::TapCut& cut, const std::stop_token& stop) {
  const milling::CutModel model = cutModel(modes, material, cut);
  if (const Status sane = milling::check(model, "tap test"); !sane) return problem(cut, sane.error());
  const auto speeds =
      milling::speedSteps(cut.lowest, cut.highest, (cut.highest - cut.lowest) * (1.0 / (kSpeeds - 1)), "tap test");
  if (!speeds) return problem(cut, speeds.error());
  milling::SweepOptions options;
  options.limits.maxAxialDepth = cut.deepest;
  options.limits.firstOnly = true;
  options.limits.frequencies = false;
  options.threads = 1;
  const auto sweep = milling::sweepLobes(model, *speeds, options, "tap test", stop);
  if (!sweep) return problem(cut, sweep.error());
  milling::ModelSpread spread;
  spread.frequency =
      spreadOf(modes, kFrequencyDoubt, [](const auto& m) { return m.frequencySd / m.mode.frequency.value; });
  spread.damping = spreadOf(modes, kDampingDoubt, [](const auto& m) { return m.dampingSd / m.mode.damping; });
  spread.stiffness = spreadOf(modes, kStiffnessDoubt, [](const auto& m) { return m.stiffnessSd / m.mode.stiffness; });
  spread.force = materialSpread;
  spread.samples = kDraws;
  const auto bands = milling::limitBands(model, *speeds, cut.deepest, spread, 1, "tap test", stop);
  if (!bands) return problem(cut, bands.error());
  ui::TapLobes lobes;
  lobes.cut = cut;
  if (!sweep->finished || !bands->finished) return lobes;
  lobes.state = ui::TapLobes::State::Done;
  for (std::size_t i = 0; i < speeds->size(); ++i) {
    const milling::SpeedLimits& at = sweep->speeds[i];
    const Metres limit = at.hasLimit() ? at.crossings.front().depth : cut.deepest;
    lobes.limits.push_back({(*speeds)[i], limit, bands->speeds[i].low, bands->speeds[i].high});
  }
  if (const auto best = milling::recommendCut(bands->speeds, cut.deepest)) {
    lobes.speed = best->speed;
    lobes.depth = best->depth;
    lobes.anySpeed = best->anySpeed;
    lobes.open = best->open;
    const double feed = cut.feedPerTooth.value * cut.teeth * best->speed.value / 60.0;
    lobes.removal = best->depth.value * cut.immersion * cut.diameter.value * feed;
  }
  return lobes;
}

// The middle of a pocket lies close to where a mode swings a whole number of times between two teeth.
std::vector<ui::TapSpeed> speedsToTry(const TapAxis& axis, const ui::TapCut& cut) {
  std::vector<ui::TapSpeed> all;
  for (const ui::TapMode& mode : axis.shown.modes) {
    if (!mode.used) continue;
    for (int waves = 1; waves <= 12; ++waves) {
      const Rpm speed(60.0 * mode.frequency.value / (cut.teeth * waves));
      if (speed < cut.lowest || speed > cut.highest) continue;
      all.push_back({speed, waves, mode.frequency});
    }
  }
  return all;
}

}  // namespace stillcut::app
