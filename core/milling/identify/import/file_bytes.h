// Whole-file reading with a bound.
// Thread: any, set-up path only. Errors name the file and the cause.
#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"

namespace stillcut::identify {

inline constexpr std::size_t kMaxImportBytes = std::size_t{1} << 30;

// The file's bytes; an error when it cannot be read, is no regular file, is empty or is larger than `limit`.
Result<std::string> readFileBytes(const std::string& path, std::size_t limit = kMaxImportBytes);

}  // namespace stillcut::identify
