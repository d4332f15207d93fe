// A profile tried out step by step, without a cut: its settings, its device, samples, its link, the machine's answer.
// Thread: any one; takes up to a few seconds. What it opened is closed again; nothing is commanded.
#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/config/profile.h"
#include "ui/models/setup_desk.h"

namespace stillcut::app {

struct ProfileTrial {
  std::vector<ui::TrialStep> steps;
  Seconds look{};  // how long one at the machine takes; 0: its link has not passed
};

ProfileTrial tryProfile(const config::Profile& profile, const std::string& path);

}  // namespace stillcut::app
