#include "core/units/unit_names.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/conversions.h"

namespace stillcut::record {
namespace {

struct UnitRow {
  std::string_view text;
  UnitKind kind;
  SensorQuantity quantity;  // only for UnitKind::Sensor
  double toSi;
};

using Q = SensorQuantity;
using K = UnitKind;

constexpr auto kUnits = std::to_array<UnitRow>({
    {"m/s2", K::Sensor, Q::Acceleration, 1.0},
    {"m/s/s", K::Sensor, Q::Acceleration, 1.0},
    {"ms-2", K::Sensor, Q::Acceleration, 1.0},
    {"mm/s2", K::Sensor, Q::Acceleration, 1e-3},
    {"g", K::Sensor, Q::Acceleration, kStandardGravity},
    {"G", K::Sensor, Q::Acceleration, kStandardGravity},
    {"gn", K::Sensor, Q::Acceleration, kStandardGravity},
    {"mg", K::Sensor, Q::Acceleration, 1e-3 * kStandardGravity},
    {"m/s", K::Sensor, Q::Velocity, 1.0},
    {"mm/s", K::Sensor, Q::Velocity, 1e-3},
    {"um/s", K::Sensor, Q::Velocity, 1e-6},
    {"in/s", K::Sensor, Q::Velocity, kInch},
    {"in/s2", K::Sensor, Q::Acceleration, kInch},
    {"m", K::Sensor, Q::Displacement, 1.0},
    {"mm", K::Sensor, Q::Displacement, 1e-3},
    {"um", K::Sensor, Q::Displacement, 1e-6},
    {"micron", K::Sensor, Q::Displacement, 1e-6},
    {"nm", K::Sensor, Q::Displacement, 1e-9},
    {"in", K::Sensor, Q::Displacement, kInch},
    {"mil", K::Sensor, Q::Displacement, 1e-3 * kInch},
    {"Pa", K::Sensor, Q::Sound, 1.0},
    {"mPa", K::Sensor, Q::Sound, 1e-3},
    {"N", K::Sensor, Q::Force, 1.0},
    {"kN", K::Sensor, Q::Force, 1e3},
    {"mN", K::Sensor, Q::Force, 1e-3},
    {"lbf", K::Sensor, Q::Force, kPoundForce},
    {"lb", K::Sensor, Q::Force, kPoundForce},
    {"A", K::Sensor, Q::Current, 1.0},
    {"mA", K::Sensor, Q::Current, 1e-3},
    {"rpm", K::Sensor, Q::SpindleSpeed, 1.0},
    {"RPM", K::Sensor, Q::SpindleSpeed, 1.0},
    {"rev/min", K::Sensor, Q::SpindleSpeed, 1.0},
    {"r/min", K::Sensor, Q::SpindleSpeed, 1.0},
    {"1/min", K::Sensor, Q::SpindleSpeed, 1.0},
    {"V", K::Voltage, Q::Acceleration, 1.0},
    {"mV", K::Voltage, Q::Acceleration, 1.0},
    {"Volt", K::Voltage, Q::Acceleration, 1.0},
    {"Volts", K::Voltage, Q::Acceleration, 1.0},
    {"s", K::Time, Q::Acceleration, 1.0},
    {"sec", K::Time, Q::Acceleration, 1.0},
    {"seconds", K::Time, Q::Acceleration, 1.0},
    {"ms", K::Time, Q::Acceleration, 1e-3},
    {"us", K::Time, Q::Acceleration, 1e-6},
    {"min", K::Time, Q::Acceleration, 60.0},
    {"Hz", K::Other, Q::Acceleration, 1.0},
    {"kHz", K::Other, Q::Acceleration, 1.0},
    {"deg", K::Other, Q::Acceleration, 1.0},
    {"degC", K::Other, Q::Acceleration, 1.0},
    {"\xC2\xB0"
     "C",
     K::Other, Q::Acceleration, 1.0},
    {"C", K::Other, Q::Acceleration, 1.0},
    {"%", K::Other, Q::Acceleration, 1.0},
    {"bar", K::Other, Q::Acceleration, 1.0},
    {"W", K::Other, Q::Acceleration, 1.0},
    {"kW", K::Other, Q::Acceleration, 1.0},
    {"Nm", K::Other, Q::Acceleration, 1.0},
});

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return out;
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// One spelling for the many: no blanks, no '^', "2" for a raised two, "u" for both Greek mus, no brackets around it.
std::string normalUnit(std::string_view text) {
  std::string unit(trimmed(text));
  if (unit.size() >= 2 &&
      ((unit.front() == '[' && unit.back() == ']') || (unit.front() == '(' && unit.back() == ')'))) {
    unit = unit.substr(1, unit.size() - 2);
  }
  replaceAll(unit, " ", "");
  replaceAll(unit, "^", "");
  replaceAll(unit, "**", "");
  replaceAll(unit, "\xC2\xB2", "2");  // superscript two
  replaceAll(unit, "\xC2\xB5", "u");  // micro sign
  replaceAll(unit, "\xCE\xBC", "u");  // Greek mu
  replaceAll(unit, "/sec", "/s");
  return unit;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n\"";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::optional<UnitMeaning> unitFromText(std::string_view text) {
  const std::string unit = normalUnit(text);
  for (const UnitRow& row : kUnits) {
    if (row.text != unit) continue;
    UnitMeaning meaning{row.kind, std::nullopt, row.toSi};
    if (row.kind == UnitKind::Sensor) meaning.quantity = row.quantity;
    return meaning;
  }
  return std::nullopt;
}

NameAndUnit splitNameAndUnit(std::string_view text) {
  const std::string_view t = trimmed(text);
  if (t.size() >= 3 && (t.back() == ')' || t.back() == ']')) {
    const std::size_t open = t.rfind(t.back() == ')' ? '(' : '[');
    if (open != std::string_view::npos && open > 0) {
      return {std::string(trimmed(t.substr(0, open))), std::string(trimmed(t.substr(open + 1, t.size() - open - 2)))};
    }
  }
  return {std::string(t), ""};
}

NameMeaning meaningOfName(std::string_view text) {
  const std::string n = lower(trimmed(text));
  const auto is = [&n](auto... words) { return ((n == words) || ...); };
  const auto has = [&n](auto... parts) { return ((n.find(parts) != std::string::npos) || ...); };
  if (is("t", "time", "times", "timestamp", "x_value", "zeit", "tiempo", "seconds", "sec") || n.starts_with("time ") ||
      n.starts_with("time_") || is("t_s", "t_ms", "t_us")) {
    return NameMeaning::Time;
  }
  if (is("n", "no", "#", "index", "idx", "row", "sample", "samples", "frame", "label", "class", "state", "comment",
         "ci", "ci value") ||
      has("indicator", "tacho", "taco", "trigger", "label", "keyphasor")) {
    return NameMeaning::NoSignal;
  }
  if (has("rpm", "spindle speed", "spindle_speed")) return NameMeaning::SpindleSpeed;
  if (has("acc", "vib")) return NameMeaning::Acceleration;
  if (has("mic", "audio", "sound")) return NameMeaning::Sound;
  if (has("force") || is("fx", "fy", "fz")) return NameMeaning::Force;
  return NameMeaning::Unknown;
}

std::string axisOfName(std::string_view text) {
  const std::string n = lower(trimmed(text));
  if (n.empty()) return "";
  const char last = n.back();
  if (last < 'x' || last > 'z') return "";
  const char before = n.size() >= 2 ? n[n.size() - 2] : ' ';
  const bool alone = n.size() == 1 || before == ' ' || before == '_' || before == '-' || before == '.';
  const bool sensorLetter = n.size() == 2 && (before == 'f' || before == 'a' || before == 'v' || before == 'd');
  return alone || sensorLetter ? std::string(1, last) : "";
}

}  // namespace stillcut::record
