// A text as a file that appears whole or not at all (PartFile).
// Thread: set-up and end of a run; never the sample path.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/result.h"

namespace stillcut {

// Creates or replaces `path`. On failure the old file, if any, is untouched and nothing new is left behind.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view content);

}  // namespace stillcut
