#include "core/config/component_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/config/nearest_word.h"

namespace stillcut::config {
namespace {

std::optional<double> number(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string shortly(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

}  // namespace

SettingName settingName(std::string_view key) {
  struct Unit {
    std::string_view ending, shown;
  };
  constexpr std::array<Unit, 5> kUnits{{{"_percent", "%"}, {"_mm", "mm"}, {"_hz", "Hz"}, {"_ms", "ms"}, {"_s", "s"}}};
  SettingName name{std::string(key), {}};
  for (const Unit& unit : kUnits) {
    if (!key.ends_with(unit.ending)) continue;
    name.unit = unit.shown;
    name.words.resize(key.size() - unit.ending.size());
    break;
  }
  for (char& c : name.words) c = c == '_' || c == '-' ? ' ' : c;
  if (!name.words.empty() && name.words[0] >= 'a' && name.words[0] <= 'z') {
    name.words[0] = static_cast<char>(name.words[0] - 'a' + 'A');
  }
  return name;
}

const std::string* ComponentSettings::find(std::string_view key) {
  read_.push_back(key);
  const auto found = settings_.find(std::string(key));
  return found == settings_.end() ? nullptr : &found->second;
}

void ComponentSettings::tell(SettingDecl setting) const {
  if (asked_ == nullptr) return;
  const auto same = std::find_if(asked_->begin(), asked_->end(), [&](const auto& a) { return a.key == setting.key; });
  if (same == asked_->end()) {
    asked_->push_back(std::move(setting));
  } else {
    *same = std::move(setting);
  }
}

void ComponentSettings::fault(std::string_view key, const Message& what, const Message& why) {
  if (!first_) first_ = Error{where_, message("'%1' %2", key, what), why};
}

std::string ComponentSettings::text(std::string_view key, const std::string& fallback) {
  tell({std::string(key), SettingDecl::Kind::Text, fallback, 0.0, 0.0, {}});
  const std::string* given = find(key);
  if (given != nullptr && given->empty()) fault(key, message("is empty"), message("leave it out for the usual value"));
  return given == nullptr ? fallback : *given;
}

double ComponentSettings::number(std::string_view key, double fallback, double lowest, double highest) {
  tell({std::string(key), SettingDecl::Kind::Number, shortly(fallback), lowest, highest, {}});
  const std::string* given = find(key);
  if (given == nullptr) return fallback;
  const auto value = config::number(*given);
  if (value && *value >= lowest && *value <= highest) return *value;
  fault(key, message("is '%1'", *given), message("must be a number from %1 to %2", shortly(lowest), shortly(highest)));
  return fallback;
}

int ComponentSettings::whole(std::string_view key, int fallback, int lowest, int highest) {
  const double value = number(key, fallback, lowest, highest);
  tell({std::string(key),
        SettingDecl::Kind::Whole,
        std::to_string(fallback),
        static_cast<double>(lowest),
        static_cast<double>(highest),
        {}});
  if (value == std::floor(value)) return static_cast<int>(value);
  fault(key, message("is '%1'", shortly(value)), message("must be a whole number"));
  return fallback;
}

bool ComponentSettings::flag(std::string_view key, bool fallback) {
  tell({std::string(key), SettingDecl::Kind::Flag, fallback ? "true" : "false", 0.0, 1.0, {}});
  const std::string* given = find(key);
  if (given == nullptr) return fallback;
  if (*given == "true" || *given == "false") return *given == "true";
  fault(key, message("is '%1'", *given), message("must be true or false"));
  return fallback;
}

std::size_t ComponentSettings::choice(std::string_view key, std::size_t fallback,
                                      const std::vector<std::string_view>& words) {
  tell({std::string(key),
        SettingDecl::Kind::Choice,
        std::string(words[fallback]),
        0.0,
        static_cast<double>(words.size()) - 1.0,
        {words.begin(), words.end()}});
  const std::string* given = find(key);
  if (given == nullptr) return fallback;
  const auto found = std::find(words.begin(), words.end(), *given);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string known;
  for (const std::string_view word : words) known += (known.empty() ? "" : ", ") + std::string(word);
  fault(key, message("is '%1'", *given), message("one of %1", known));
  return fallback;
}

Status ComponentSettings::finish() const {
  if (first_) return *first_;
  for (const auto& [key, value] : settings_) {
    if (std::find(read_.begin(), read_.end(), key) != read_.end()) continue;
    Message why = didYouMean(key, read_);
    if (why.empty()) {
      std::string known;
      for (const std::string_view k : read_) known += (known.empty() ? "" : " ") + std::string(k);
      why = message("known: %1", known);
    }
    return Error{where_, message("'%1' is not known", key), why};
  }
  return Done{};
}

}  // namespace stillcut::config
