// Formats that are known and not read: which one it is, and the way out. Thread: its caller's; not real-time.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace stillcut::record {

// Nothing: the file, which begins with `head`, is none of them.
std::optional<Error> refusalOf(const std::string& path, std::string_view head);

}  // namespace stillcut::record
