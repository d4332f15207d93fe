// In what a file is written, as far as the checks of sizes and shares count it. Thread: any.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace stillcut::lint {

enum class Language { None, Cpp, Script };

// C++ by its ending; Python by its ending, it and shell by their first line; data and lists for CMake are None.
inline Language languageOf(const std::filesystem::path& path) {
  const std::filesystem::path kind = path.extension();
  if (kind == ".h" || kind == ".cpp") return Language::Cpp;
  if (kind == ".py") return Language::Script;
  if (!kind.empty()) return Language::None;
  std::ifstream in(path);
  std::string line;
  std::getline(in, line);
  return line.starts_with("#!") ? Language::Script : Language::None;
}

}  // namespace stillcut::lint
