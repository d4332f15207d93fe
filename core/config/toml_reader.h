// TomlReader: strict reading of our own files. Every value is asked for by key; whatever nobody asked for is an error
// at finish(), with the nearest key that was asked for. Errors collect as one line with file and line; the first one
// counts. toml++ does the parsing (a complete, maintained TOML 1.0 parser) and stays inside toml_reader.cpp.
//
//   TomlReader in = TomlReader::file("mill3.toml");
//   TomlTable tool = in.root().table("tool");
//   setup.teeth = tool.integer("teeth", 1, 12);
//   setup.toolDiameter = Metres(tool.number("diameter_mm", 0.1, 500.0) * 1e-3);
//   if (Status s = in.finish(); !s) return s.error();
//
// Thread: set-up. Getters never throw; after an error they give the fallback or the lowest allowed value.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stillcut::config {

namespace detail {
struct TomlDocument;
}

inline constexpr double kAnyNumber = std::numeric_limits<double>::max();

// One table of the file. Cheap to copy; good as long as its reader. A table that is missing but optional is empty.
class TomlTable {
 public:
  bool has(std::string_view key) const;
  bool isTable(std::string_view key) const;
  bool present() const { return node_ != nullptr; }

  // Required values: missing is an error. Numbers outside lowest..highest, non-finite ones and wrong types are errors.
  double number(std::string_view key, double lowest = -kAnyNumber, double highest = kAnyNumber) const;
  int integer(std::string_view key, int lowest = std::numeric_limits<int>::min(),
              int highest = std::numeric_limits<int>::max()) const;
  bool boolean(std::string_view key) const;
  std::string text(std::string_view key) const;
  // One of `words`; gives its index.
  int choice(std::string_view key, const std::vector<std::string_view>& words) const;
  std::vector<double> numbers(std::string_view key) const;
  std::vector<std::string> texts(std::string_view key) const;
  // Arrays of arrays of numbers ([[0, 0.5], [1, 2.0]]).
  std::vector<std::vector<double>> rows(std::string_view key) const;
  TomlTable table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  // [[key]]

  // The same with a fallback for a missing key.
  double numberOr(std::string_view key, double fallback, double lowest = -kAnyNumber,
                  double highest = kAnyNumber) const;
  int integerOr(std::string_view key, int fallback, int lowest = std::numeric_limits<int>::min(),
                int highest = std::numeric_limits<int>::max()) const;
  bool booleanOr(std::string_view key, bool fallback) const;
  std::string textOr(std::string_view key, std::string_view fallback) const;
  int choiceOr(std::string_view key, int fallback, const std::vector<std::string_view>& words) const;
  std::vector<double> numbersOr(std::string_view key, std::vector<double> fallback) const;
  TomlTable tableOr(std::string_view key) const;                // empty when missing
  std::vector<TomlTable> tablesOr(std::string_view key) const;  // empty when missing

  // All keys, for tables whose keys are free (parameters); asking for them counts as asking.
  std::vector<std::string> keys() const;
  // A value of any scalar type as the text set() of ParamSet understands ("0.2", "true", "auto").
  std::string scalarText(std::string_view key) const;

  // "file:line" of a key (or of the table), for errors about meaning found later.
  std::string place(std::string_view key = {}) const;
  // Reports an error about `key`; the first of all counts.
  void refuse(std::string_view key, const Message& what, const Message& why = {}) const;

 private:
  friend class TomlReader;
  TomlTable(detail::TomlDocument* document, const void* node, std::string path)
      : document_(document), node_(node), path_(std::move(path)) {}
  const void* find(std::string_view key, bool required) const;

  detail::TomlDocument* document_;
  const void* node_;  // toml::table
  std::string path_;  // "tool.", for messages
};

class TomlReader {
 public:
  static TomlReader file(const std::string& path);
  // `name` stands for the file in messages.
  static TomlReader text(std::string_view content, const std::string& name);
  ~TomlReader();
  TomlReader(TomlReader&&) noexcept;
  TomlReader& operator=(TomlReader&&) noexcept;

  TomlTable root() const;
  // The first error so far: unreadable file, syntax, value. Later ones follow from it.
  std::optional<Error> error() const;
  // Also refuses what nobody asked for.
  Status finish() const;

 private:
  explicit TomlReader(std::unique_ptr<detail::TomlDocument> document);
  std::unique_ptr<detail::TomlDocument> document_;
};

}  // namespace stillcut::config
