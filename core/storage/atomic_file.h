// Text files appear whole or not at all: written beside their place, synced, then renamed over it.
// Thread: set-up and end of a run; never the sample path.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace stillcut {

// Creates or replaces `path`. On failure the old file, if any, is untouched and nothing new is left behind.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view content);

}  // namespace stillcut
