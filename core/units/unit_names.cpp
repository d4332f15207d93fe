#include "core/units/unit_names.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/conversions.h"
#include "core/units/time_names.h"

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
    {"Newton", K::Sensor, Q::Force, 1.0},
    {"Newtons", K::Sensor, Q::Force, 1.0},
    {"newton", K::Sensor, Q::Force, 1.0},
    {"newtons", K::Sensor, Q::Force, 1.0},
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
    {"secs", K::Time, Q::Acceleration, 1.0},
    {"second", K::Time, Q::Acceleration, 1.0},
    {"ms", K::Time, Q::Acceleration, 1e-3},
    {"msec", K::Time, Q::Acceleration, 1e-3},
    {"msecs", K::Time, Q::Acceleration, 1e-3},
    {"sekunde", K::Time, Q::Acceleration, 1.0},
    {"sekunden", K::Time, Q::Acceleration, 1.0},
    {"millisekunden", K::Time, Q::Acceleration, 1e-3},
    {"mikrosekunden", K::Time, Q::Acceleration, 1e-6},
    {"millisec", K::Time, Q::Acceleration, 1e-3},
    {"microsec", K::Time, Q::Acceleration, 1e-6},
    {"nanosec", K::Time, Q::Acceleration, 1e-9},
    {"millis", K::Time, Q::Acceleration, 1e-3},
    {"millisecond", K::Time, Q::Acceleration, 1e-3},
    {"milliseconds", K::Time, Q::Acceleration, 1e-3},
    {"us", K::Time, Q::Acceleration, 1e-6},
    {"usec", K::Time, Q::Acceleration, 1e-6},
    {"usecs", K::Time, Q::Acceleration, 1e-6},
    {"micros", K::Time, Q::Acceleration, 1e-6},
    {"microsecond", K::Time, Q::Acceleration, 1e-6},
    {"microseconds", K::Time, Q::Acceleration, 1e-6},
    {"ns", K::Time, Q::Acceleration, 1e-9},
    {"nsec", K::Time, Q::Acceleration, 1e-9},
    {"nsecs", K::Time, Q::Acceleration, 1e-9},
    {"nanos", K::Time, Q::Acceleration, 1e-9},
    {"nanosecond", K::Time, Q::Acceleration, 1e-9},
    {"nanoseconds", K::Time, Q::Acceleration, 1e-9},
    {"min", K::Time, Q::Acceleration, 60.0},
    {"minutes", K::Time, Q::Acceleration, 60.0},
    {"h", K::Time, Q::Acceleration, 3600.0},
    {"hours", K::Time, Q::Acceleration, 3600.0},
    {"Sequence", K::Other, Q::Acceleration, 1.0},  // what Rigol's oscilloscopes call the number of a row
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
  const std::string small = lower(unit);
  for (const UnitRow& row : kUnits) {
    // A word is one however it begins; of short signs a capital makes another unit.
    const bool word = row.kind == UnitKind::Time && row.text.size() >= 3 && row.text != "min";
    if (row.text != (word ? small : unit)) continue;
    UnitMeaning meaning{row.kind, std::nullopt, row.toSi};
    if (row.kind == UnitKind::Sensor) meaning.quantity = row.quantity;
    return meaning;
  }
  return std::nullopt;
}

namespace {

// "Hammer [V] (2.25 mV/N)", "Accel (V) 10.2 mV/g": the unit is in the middle, a sensitivity behind it.
std::optional<NameAndUnit> splitAtVolts(std::string_view text) {
  for (const std::string_view volts : {"(V)", "[V]", "(mV)", "[mV]"}) {
    const std::size_t at = text.find(volts);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view behind = trimmed(text.substr(at + volts.size()));
    if (behind.find("V/") == std::string_view::npos) continue;
    return NameAndUnit{std::string(trimmed(text.substr(0, at))) + " " + std::string(behind),
                       std::string(volts.substr(1, volts.size() - 2))};
  }
  return std::nullopt;
}

// "Y[0]", "Channel (1)": one of several of a name.
bool isIndex(std::string_view inside) {
  return !inside.empty() && std::all_of(inside.begin(), inside.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Where the bracket that closes at the end of `text` opens: "Accel (10.2 mV/(m/s^2))".
std::size_t openingOfLast(std::string_view text) {
  const char closing = text.back(), opening = closing == ')' ? '(' : '[';
  int depth = 0;
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == closing) ++depth;
    if (text[i] == opening && --depth == 0) return i;
  }
  return std::string_view::npos;
}

}  // namespace

NameAndUnit splitNameAndUnit(std::string_view text) {
  const std::string_view t = trimmed(text);
  if (auto both = splitAtVolts(t)) return *both;
  if (t.size() >= 3 && (t.back() == ')' || t.back() == ']')) {
    const std::size_t open = openingOfLast(t);
    if (open != std::string_view::npos && open > 0 && !isIndex(t.substr(open + 1, t.size() - open - 2))) {
      return {std::string(trimmed(t.substr(0, open))), std::string(trimmed(t.substr(open + 1, t.size() - open - 2)))};
    }
  }
  return {std::string(t), ""};
}

NameMeaning meaningOfName(std::string_view text) {
  const std::string n = lower(trimmed(text));
  const auto is = [&n](auto... words) { return ((n == words) || ...); };
  const auto has = [&n](auto... parts) { return ((n.find(parts) != std::string::npos) || ...); };
  if (isTimeName(n)) return NameMeaning::Time;
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
