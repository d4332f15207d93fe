// TomlWriter: composes a TOML file line by line and saves it whole or not at all. What it writes, TomlReader reads
// back. Thread: set-up and the settings pages; never the sample path.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace stillcut::config {

class TomlWriter {
 public:
  void comment(std::string_view line);
  // "[path]" and "[[path]]"; `path` joins its keys with dots, each key made of letters, digits, '-' and '_'.
  void table(std::string_view path);
  void arrayElement(std::string_view path);

  // Twelve significant digits: what a unit conversion leaves in the last bits is not written. Finite values only.
  void number(std::string_view key, double value);
  void numbers(std::string_view key, std::span<const double> values);
  void integer(std::string_view key, int value);
  void boolean(std::string_view key, bool value);
  void text(std::string_view key, std::string_view value);
  // A value kept as text ("0.2", "true", "auto"): written bare where it reads back as the same text, else quoted.
  void scalar(std::string_view key, std::string_view value);

  const std::string& content() const { return content_; }
  Status save(const std::filesystem::path& path) const;

 private:
  void line(std::string_view key, std::string_view value);

  std::string content_;
};

}  // namespace stillcut::config
