// A profile tried out step by step, without a cut: its settings, its device, samples, its link, the machine's answer.
// Thread: any one; takes up to a few seconds. What it opened is closed again; nothing is commanded.
#pragma once

#include <string>
#include <vector>

#include "core/config/profile.h"
#include "ui/models/setup_desk.h"

namespace stillcut::app {

std::vector<ui::TrialStep> tryProfile(const config::Profile& profile, const std::string& path);

}  // namespace stillcut::app
