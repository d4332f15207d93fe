// RunTuning: the parameters of one rig as the Tune page shows them, and where to keep changed ones. Thread: GUI.
#pragma once

#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "ui/models/tune/tuning.h"

namespace stillcut::app {

// Every part there is; those the rig runs say what they chose for automatic parameters.
std::vector<ui::TunableComponent> tunableParts(const Rig& rig);

// What the rig has set itself by now, of one of its parts.
std::vector<ui::AutoReading> ownReadings(const Rig& rig, const ui::TunableComponent& part);

struct ValuesToKeep {
  const config::ParamSet& values;
  const config::ParamSet& started;  // what differs from it is kept
};
// Into the profile itself where there is one, else into `folder`/parameters.toml, which --config reads.
Result<QString> keepValues(const ValuesToKeep& keep, const std::string& profile, const QString& folder);

}  // namespace stillcut::app
