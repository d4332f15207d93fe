#include "ui/models/tune/sensitivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr double kStep = 1.2;   // a step of a limit: 0.2 to 0.24 or 0.167
constexpr double kSame = 5e-3;  // values are kept with three digits
constexpr std::array<std::string_view, 3> kLimits{".chatter", ".evidence", ".onset-amplitude"};

double stepped(const config::ParamDecl& decl, int step) {
  const double wanted = decl.fallback * std::pow(kStep, -step);
  const double digits = std::pow(10.0, std::floor(std::log10(wanted)) - 2.0);
  return std::clamp(std::round(wanted / digits) * digits, decl.lowest, decl.highest);
}

}  // namespace

Sensitivity::Sensitivity(const TunableComponent& detector) {
  if (detector.role != TunableComponent::Role::Detector) return;
  for (const config::ParamDecl* decl : detector.params) {
    const bool decides =
        std::ranges::any_of(kLimits, [decl](std::string_view end) { return decl->key.ends_with(end); });
    if (decides && !decl->lockedWhileRunning && decl->fallback > 0.0) limits_.push_back(decl);
  }
}

Sensitivity::Values Sensitivity::at(int step) const {
  Values values;
  for (const config::ParamDecl* decl : limits_) {
    values.emplace_back(decl, stepped(*decl, std::clamp(step, -kMost, kMost)));
  }
  return values;
}

std::optional<int> Sensitivity::stepOf(const std::function<double(const config::ParamDecl&)>& value) const {
  for (int step = -kMost; step <= kMost; ++step) {
    const bool same = std::ranges::all_of(limits_, [&](const config::ParamDecl* decl) {
      const double wanted = stepped(*decl, step);
      return std::abs(value(*decl) - wanted) <= kSame * wanted;
    });
    if (same) return step;
  }
  return std::nullopt;
}

QString sensitivityText(std::optional<int> step) {
  if (!step) return say("Set by hand");
  if (*step == 0) return say("As delivered");
  if (*step == 1) return say("One step more sensitive");
  if (*step == -1) return say("One step less sensitive");
  return *step > 0 ? say("%1 steps more sensitive").arg(*step) : say("%1 steps less sensitive").arg(-*step);
}

QString trialText(const SensitivityTrial& trial) {
  if (trial.running && trial.looked == 0) return say("Looking at your last recordings");
  if (trial.recordings == 0 && !trial.running) return say("There are no recordings yet to try it on");
  if (trial.looked == 0) return trial.problem;
  QString text = trial.looked == 1
                     ? say("In your last recording it would have alarmed %1 times, %2 of them marked false")
                           .arg(trial.alarms)
                           .arg(trial.markedFalse)
                     : say("In your last %1 recordings it would have alarmed %2 times, %3 of them marked false")
                           .arg(trial.looked)
                           .arg(trial.alarms)
                           .arg(trial.markedFalse);
  text += say("; as they were recorded %1 times, %2 of them marked false").arg(trial.alarmsNow).arg(trial.falseNow);
  if (trial.running) text += say("; looking at more");
  return text;
}

}  // namespace stillcut::ui
