#include "core/milling/identify/unit_label.h"

#include <array>
#include <string>
#include <utility>

namespace stillcut::identify {
namespace {

constexpr double kGravity = 9.80665;     // [m/s^2]
constexpr double kInch = 0.0254;         // [m]
constexpr double kPound = 4.4482216153;  // [N]

void replaceAll(std::string& s, std::string_view from, std::string_view to) {
  for (std::size_t at = s.find(from); at != std::string::npos; at = s.find(from, at + to.size())) {
    s.replace(at, from.size(), to);
  }
}

// Lower case, without brackets and blanks, squares as a plain 2, micro as u.
std::string normal(std::string_view label) {
  std::string s(label);
  replaceAll(s, "\xC2\xB2", "2");  // superscript two
  replaceAll(s, "\xC2\xB5", "u");  // micro sign
  replaceAll(s, "\xCE\xBC", "u");  // Greek mu
  replaceAll(s, "**", "^");
  std::string out;
  for (const char c : s) {
    if (std::string_view(" \t()[]^").find(c) != std::string_view::npos) continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  replaceAll(out, "/s/s", "/s2");
  replaceAll(out, "sec", "s");
  return out;
}

}  // namespace

std::optional<ResponseUnit> responseUnit(std::string_view label) {
  using enum FrfQuantity;
  static constexpr std::array<std::pair<std::string_view, ResponseUnit>, 13> kKnown = {{
      {"m", {Compliance, 1.0}},
      {"mm", {Compliance, 1e-3}},
      {"um", {Compliance, 1e-6}},
      {"in", {Compliance, kInch}},
      {"m/s", {Mobility, 1.0}},
      {"mm/s", {Mobility, 1e-3}},
      {"in/s", {Mobility, kInch}},
      {"m/s2", {Accelerance, 1.0}},
      {"mm/s2", {Accelerance, 1e-3}},
      {"in/s2", {Accelerance, kInch}},
      {"g", {Accelerance, kGravity}},
      {"gn", {Accelerance, kGravity}},
      {"mg", {Accelerance, 1e-3 * kGravity}},
  }};
  const std::string name = normal(label);
  for (const auto& [known, unit] : kKnown) {
    if (name == known) return unit;
  }
  return std::nullopt;
}

std::optional<double> forceUnit(std::string_view label) {
  const std::string name = normal(label);
  if (name == "n") return 1.0;
  if (name == "kn") return 1e3;
  if (name == "lbf" || name == "lb") return kPound;
  return std::nullopt;
}

std::optional<ResponseUnit> frfUnit(std::string_view label) {
  std::string name = normal(label);
  if (name.starts_with("1/")) {  // "1/N*(m/s2)"
    const std::size_t star = name.find('*');
    if (star == std::string::npos) return std::nullopt;
    name = name.substr(star + 1) + "/" + name.substr(2, star - 2);
  }
  const std::size_t slash = name.rfind('/');
  if (slash == std::string::npos) return std::nullopt;
  auto unit = responseUnit(name.substr(0, slash));
  const auto force = forceUnit(name.substr(slash + 1));
  if (!unit || !force) return std::nullopt;
  unit->factor /= *force;
  return unit;
}

}  // namespace stillcut::identify
