#include "core/milling/identify/import/unit_label.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/base/conversions.h"
#include "core/base/units.h"
#include "core/formats/utf_text.h"
#include "core/units/number_scan.h"
#include "core/units/unit_names.h"

namespace stillcut::identify {
namespace {

struct Spelling {
  std::string_view written, known;
};
// Words for units, in small letters.
constexpr auto kSpellings = std::to_array<Spelling>({
    {"n", "N"},           {"newton", "N"},        {"newtons", "N"},      {"kn", "kN"},         {"kilonewton", "kN"},
    {"lbs", "lbf"},       {"lbsf", "lbf"},        {"pound", "lbf"},      {"pounds", "lbf"},    {"poundforce", "lbf"},
    {"gs", "g"},          {"g's", "g"},           {"g_n", "g"},          {"meter", "m"},       {"metre", "m"},
    {"meters", "m"},      {"metres", "m"},        {"inch", "in"},        {"inches", "in"},     {"inch/s", "in/s"},
    {"inch/s2", "in/s2"}, {"inch/s^2", "in/s^2"}, {"in/s/s", "in/s^2"},  {"ips", "in/s"},      {"mils", "mil"},
    {"microns", "um"},    {"micrometer", "um"},   {"micrometers", "um"}, {"micrometre", "um"}, {"mm/s/s", "mm/s^2"},
    {"v", "V"},           {"volt", "V"},          {"volts", "V"},        {"mv", "mV"},         {"millivolt", "mV"},
    {"uv", "uV"},
});

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

// Without blanks and brackets, which files put anywhere: "(m/s^2) / N".
std::string bare(std::string_view label) {
  std::string name;
  for (const char c : record::utf8Of(label)) {
    if (std::string_view(" \t()[]\"").find(c) == std::string_view::npos) name += c;
  }
  return name;
}

std::string spelled(const std::string& name) {
  const std::string small = lower(name);
  for (const Spelling& s : kSpellings) {
    if (s.written == small) return std::string(s.known);
  }
  return name;
}

std::optional<record::UnitMeaning> sensorUnit(std::string_view label) {
  const std::string name = spelled(bare(label));
  auto unit = record::unitFromText(name);
  if (!unit) unit = record::unitFromText(lower(name));  // universal files write capitals: "MM"
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
  const std::string name = lower(bare(label));
  if (name == "kgf" || name == "kp") return kStandardGravity;
  const auto unit = sensorUnit(label);
  if (!unit || *unit->quantity != SensorQuantity::Force) return std::nullopt;
  return unit->toSi;
}

std::optional<ResponseUnit> frfUnit(std::string_view label) {
  std::string name = bare(label);
  if (name == "1/kg" || name == "kg-1" || name == "kg^-1") return ResponseUnit{FrfQuantity::Accelerance, 1.0};
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

std::optional<ResponseUnit> inverseFrfUnit(std::string_view label) {
  const std::string name = bare(label);
  if (name == "kg") return ResponseUnit{FrfQuantity::Accelerance, 1.0};
  for (const std::string_view impedance : {"Ns/m", "N*s/m", "N.s/m", "N\xC2\xB7s/m"}) {
    if (name == impedance) return ResponseUnit{FrfQuantity::Mobility, 1.0};
  }
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const auto force = forceUnit(name.substr(0, slash));
  auto unit = responseUnit(name.substr(slash + 1));
  if (!unit || !force) return std::nullopt;
  unit->factor /= *force;
  return unit;
}

std::optional<Decibels> decibels(std::string_view label) {
  std::string_view rest = uff::trimmed(label);
  if (lower(std::string(rest.substr(0, 2))) != "db") return std::nullopt;
  rest.remove_prefix(2);
  for (const std::string_view word : {"ref", "rel", "re"}) {
    const std::string_view next = uff::trimmed(rest);
    if (!next.starts_with(word)) continue;
    rest = next.substr(word.size());
    break;
  }
  while (!rest.empty() && std::string_view(" .:/").find(rest.front()) != std::string_view::npos) rest.remove_prefix(1);
  if (rest.empty()) return Decibels{};
  const double size = uff::takeNumber(rest).value_or(1.0);
  auto unit = frfUnit(rest);
  if (!unit || !(size > 0.0)) return std::nullopt;
  unit->factor *= size;
  return Decibels{unit};
}

std::optional<double> frequencyUnit(std::string_view label) {
  const std::string name = lower(bare(label));
  if (name == "hz" || name == "hertz" || name == "cps" || name == "1/s") return 1.0;
  if (name == "khz") return 1e3;
  if (name == "rad/s" || name == "rad/sec" || name == "rads/s") return 1.0 / kTwoPi;
  if (name == "rpm" || name == "1/min" || name == "rev/min" || name == "cpm") return 1.0 / 60.0;
  return std::nullopt;
}

std::optional<double> voltageUnit(std::string_view label) {
  const std::string name = spelled(bare(label));
  if (name == "V") return 1.0;
  if (name == "mV") return 1e-3;
  if (name == "uV" || name == "\xC2\xB5V" || name == "\xCE\xBCV") return 1e-6;
  return std::nullopt;
}

std::optional<double> angleUnit(std::string_view label) {
  const std::string name = lower(bare(label));
  if (name == "deg" || name == "degree" || name == "degrees" || name == "\xC2\xB0" || name == "grad") {
    return kTwoPi / 360.0;
  }
  if (name == "rad" || name == "radian" || name == "radians") return 1.0;
  return std::nullopt;
}

std::optional<Sensitivity> sensitivityFromText(std::string_view text) {
  std::string_view rest = uff::trimmed(text);
  const auto number = uff::takeNumber(rest);
  if (!number || !std::isfinite(*number) || *number == 0.0) return std::nullopt;
  const std::size_t slash = rest.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto volts = voltageUnit(rest.substr(0, slash));
  const std::string_view per = rest.substr(slash + 1);
  if (!volts) return std::nullopt;
  if (const auto force = forceUnit(per)) return Sensitivity{*number * *volts / *force, std::nullopt};
  if (const auto unit = responseUnit(per)) return Sensitivity{*number * *volts / unit->factor, unit->quantity};
  return std::nullopt;
}

}  // namespace stillcut::identify
