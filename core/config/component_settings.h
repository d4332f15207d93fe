// ComponentSettings: the settings of one device or machine link, text in a profile, read key by key with their ranges.
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

// One setting as a part asks for it: what a form is made of.
struct SettingDecl {
  enum class Kind { Text, Number, Whole, Flag, Choice };
  std::string key;
  Kind kind = Kind::Text;
  std::string fallback;  // as text
  double lowest = 0.0, highest = 0.0;
  std::vector<std::string> words;  // of a choice
};

// How a form shows a key: "lowest_speed_percent" is "Lowest speed" in "%".
struct SettingName {
  std::string words, unit;  // no unit: empty
};
SettingName settingName(std::string_view key);

class ComponentSettings {
 public:
  // `where` names the part in errors: "link 'linuxcnc'".
  // `asked`, where given, receives every setting the component asks for.
  ComponentSettings(const std::map<std::string, std::string>& settings, std::string where,
                    std::vector<SettingDecl>* asked = nullptr)
      : settings_(settings), where_(std::move(where)), asked_(asked) {}

  std::string text(std::string_view key, const std::string& fallback);
  // Outside [lowest, highest], or no number: a fault, and the fallback.
  double number(std::string_view key, double fallback, double lowest, double highest);
  int whole(std::string_view key, int fallback, int lowest, int highest);
  bool flag(std::string_view key, bool fallback);
  // The place of one of `words`; a fault names them all.
  std::size_t choice(std::string_view key, std::size_t fallback, const std::vector<std::string_view>& words);
  bool has(std::string_view key) const {
    if (asked_ != nullptr) tell({std::string(key), SettingDecl::Kind::Text, "", 0.0, 0.0, {}});
    return settings_.contains(std::string(key));
  }
  // A fault the part itself has found.
  void fault(std::string_view key, const Message& what, const Message& why);

  Status finish() const;

 private:
  const std::string* find(std::string_view key);
  // A later question about the same key says more than has().
  void tell(SettingDecl setting) const;

  const std::map<std::string, std::string>& settings_;
  std::string where_;
  std::vector<SettingDecl>* asked_;
  std::vector<std::string_view> read_;
  std::optional<Error> first_;
};

}  // namespace stillcut::config
