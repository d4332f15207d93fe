#include "app/compose/resource_folder.h"

#include <system_error>

namespace stillcut::app {

namespace fs = std::filesystem;

fs::path resourceFolder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path().parent_path() / "share" / "stillcut";
  if (!program.empty() && fs::is_directory(installed, none)) return installed;
  return STILLCUT_SOURCE_RESOURCES;
}

}  // namespace stillcut::app
