#include "core/milling/identify/unit_label.h"

#include <algorithm>
#include <string>

#include "core/units/unit_names.h"

namespace stillcut::identify {
namespace {

// Universal files write labels in capitals, and brackets and blanks anywhere: "MM", "(m/s^2) / N".
std::optional<record::UnitMeaning> sensorUnit(std::string_view label) {
  std::string name;
  for (const char c : label) {
    if (std::string_view(" \t()[]").find(c) == std::string_view::npos) name += c;
  }
  auto unit = record::unitFromText(name);
  if (!unit) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    unit = record::unitFromText(name == "n" ? "N" : name == "kn" ? "kN" : name);
  }
  return unit && unit->quantity ? unit : std::nullopt;
}

}  // namespace

std::optional<ResponseUnit> responseUnit(std::string_view label) {
  const auto unit = sensorUnit(label);
  if (!unit) return std::nullopt;
  switch (*unit->quantity) {
    case SensorQuantity::Displacement:
      return ResponseUnit{FrfQuantity::Compliance, unit->toSi};
    case SensorQuantity::Velocity:
      return ResponseUnit{FrfQuantity::Mobility, unit->toSi};
    case SensorQuantity::Acceleration:
      return ResponseUnit{FrfQuantity::Accelerance, unit->toSi};
    default:
      return std::nullopt;
  }
}

std::optional<double> forceUnit(std::string_view label) {
  const auto unit = sensorUnit(label);
  if (!unit || *unit->quantity != SensorQuantity::Force) return std::nullopt;
  return unit->toSi;
}

std::optional<ResponseUnit> frfUnit(std::string_view label) {
  std::string name(label);
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
