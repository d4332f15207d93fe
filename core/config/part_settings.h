// PartSettings: the settings of one device or machine link, text in a profile, read key by key with their ranges.
// Every fault is kept until finish(): the first one, or a key that nobody read.
// Thread: set-up.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace stillcut::config {

class PartSettings {
 public:
  // `where` names the part in errors: "link 'linuxcnc'".
  PartSettings(const std::map<std::string, std::string>& settings, std::string where)
      : settings_(settings), where_(std::move(where)) {}

  std::string text(std::string_view key, const std::string& fallback);
  // Outside [lowest, highest], or no number: a fault, and the fallback.
  double number(std::string_view key, double fallback, double lowest, double highest);
  int whole(std::string_view key, int fallback, int lowest, int highest);
  bool flag(std::string_view key, bool fallback);
  // The place of one of `words`; a fault names them all.
  std::size_t choice(std::string_view key, std::size_t fallback, const std::vector<std::string_view>& words);
  bool has(std::string_view key) const { return settings_.contains(std::string(key)); }
  // A fault the part itself has found.
  void fault(std::string_view key, const std::string& what, const std::string& why);

  Status finish() const;

 private:
  const std::string* find(std::string_view key);

  const std::map<std::string, std::string>& settings_;
  std::string where_;
  std::vector<std::string_view> read_;
  std::optional<Error> first_;
};

}  // namespace stillcut::config
