// The schema of everything that the command line prints as JSON, given in each object as "schema". The number is raised
// where a field changes its meaning or goes; a field that comes is no new number. Fields: resources/manual/scripts.md.
// Any thread.
#pragma once

#include <string_view>

namespace stillcut {

inline constexpr std::string_view kJsonSchema = "stillcut-cli/1";

}  // namespace stillcut
