#include "core/base/program_place.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace stillcut {

std::string programPlace(std::string_view name, std::string_view built) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (const fs::path& candidate : {here / name, here.parent_path() / "libexec/stillcut" / name, fs::path(built)}) {
    if (::access(candidate.c_str(), X_OK) == 0) return candidate.string();
  }
  return {};
}

}  // namespace stillcut
