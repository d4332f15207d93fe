// One control over how readily a detector alarms: steps from less to more sensitive, each of which moves the limits
// that decide (chatter ratio, evidence for an onset, smallest onset) by one small share. Step 0 is as delivered. Pure,
// GUI thread.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "ui/models/tune/tuning.h"

namespace stillcut::ui {

class Sensitivity {
 public:
  static constexpr int kMost = 6;  // steps either way
  using Values = std::vector<std::pair<const config::ParamDecl*, double>>;

  Sensitivity() = default;
  explicit Sensitivity(const TunableComponent& detector);

  bool known() const { return !limits_.empty(); }
  // What the limits are at a step, as far as their ranges reach.
  Values at(int step) const;
  // The step whose values these are; empty: somebody has set them otherwise.
  std::optional<int> stepOf(const std::function<double(const config::ParamDecl&)>& value) const;

 private:
  std::vector<const config::ParamDecl*> limits_;
};

// "As delivered", "2 steps more sensitive".
QString sensitivityText(std::optional<int> step);

// "In your last 4 recordings it would have alarmed 3 times, 1 of them marked false; ..."
QString trialText(const SensitivityTrial& trial);

}  // namespace stillcut::ui
