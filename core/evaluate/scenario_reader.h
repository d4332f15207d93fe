// A simulated cut as a recording: its samples and what the machine said, block by block, with nobody at the overrides.
// So a scenario can be paced, paused, stepped and looped as anything that was recorded. Thread: one at a time; not
// real-time.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"

namespace stillcut::evaluate {

bool isScenarioFile(const std::string& path);  // by its suffix, .toml
// A scenario or any recording, by its suffix or content.
Result<std::unique_ptr<record::RecordingReader>> openCut(const std::string& path,
                                                         const record::ReadOptions& options = {});

}  // namespace stillcut::evaluate
