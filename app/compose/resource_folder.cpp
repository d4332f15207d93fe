#include "app/compose/resource_folder.h"

#include <cstdlib>
#include <system_error>

namespace stillcut::app {

namespace fs = std::filesystem;

fs::path resourceFolder() {
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  fs::path installed = program.parent_path().parent_path() / "share" / "stillcut";
  if (!program.empty() && fs::is_directory(installed, none)) return installed;
  return STILLCUT_SOURCE_RESOURCES;
}

std::string foundFile(const std::string& path, const fs::path& folder) {
  std::error_code none;
  const fs::path given = folder / path;  // an absolute path stays itself, here and below
  const fs::path ours = resourceFolder() / path;
  return !fs::exists(given, none) && fs::is_regular_file(ours, none) ? ours.string() : given.string();
}

std::filesystem::path userFolder(const char* variable, const char* usual) {
  const char* said = std::getenv(variable);
  const char* home = std::getenv("HOME");
  const bool absolute = said != nullptr && std::filesystem::path(said).is_absolute();  // others are to be ignored
  return (absolute ? std::filesystem::path(said) : std::filesystem::path(home != nullptr ? home : ".") / usual) /
         "stillcut";
}

}  // namespace stillcut::app
