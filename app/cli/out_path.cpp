#include "app/cli/out_path.h"

#include <filesystem>

namespace stillcut::app {

namespace fs = std::filesystem;

Status checkOutPath(const std::string& path, const std::string& input) {
  if (path.empty()) return Done{};
  std::error_code problem;
  const fs::path folder = fs::path(path).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, problem)) {
    return Error{path, message("cannot be written"), message("there is no folder '%1'", folder.string())};
  }
  const fs::file_status there = fs::status(path, problem);
  if (fs::is_directory(there)) return Error{path, message("cannot be written"), message("it is a folder")};
  if (fs::exists(there) && !fs::is_regular_file(there)) {
    return Error{path, message("cannot be written"), message("it is no regular file")};
  }
  if (!input.empty() && fs::exists(there) && fs::equivalent(path, input, problem)) {
    return Error{path, message("cannot be written"), message("it is the file that is read")};
  }
  return Done{};
}

}  // namespace stillcut::app
