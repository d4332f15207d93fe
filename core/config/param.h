// Parameter declarations. A parameter is declared once (house rule 6); its file entry, validation, command-line form,
// tuning panel and line in the manual are all made from the declaration.
//
// Declare beside the code that reads it, as a constant, and list it in that part's table:
//   inline constexpr ParamDecl kHarmonics = integerParam("energy-ratio.harmonics", "Harmonics", 32, 1, 256,
//       "Spindle harmonics the Kalman filter removes (N in eq. 16)");
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace stillcut::config {

enum class ParamKind { Real, Integer, Boolean, Choice };

struct ParamDecl {
  std::string_view key;    // "part.name", lower case, words joined by '-'
  std::string_view label;  // as a panel shows it
  std::string_view unit;   // "Hz", "rpm", "ms", "" for pure numbers
  ParamKind kind = ParamKind::Real;
  double fallback = 0.0;  // default; index for Choice, 0/1 for Boolean, NaN for automatic
  double lowest = 0.0;
  double highest = 0.0;
  bool mayBeAutomatic = false;  // the word "auto" is a legal value: the part finds it itself and says what it found
  bool lockedWhileRunning = false;
  std::span<const std::string_view> choices;
  std::string_view meaning;  // one sentence for the manual and the tool tip
};

inline constexpr double kAutomatic = std::numeric_limits<double>::quiet_NaN();

constexpr ParamDecl realParam(std::string_view key, std::string_view label, std::string_view unit, double fallback,
                              double lowest, double highest, std::string_view meaning) {
  return {key, label, unit, ParamKind::Real, fallback, lowest, highest, false, false, {}, meaning};
}
constexpr ParamDecl autoParam(std::string_view key, std::string_view label, std::string_view unit, double lowest,
                              double highest, std::string_view meaning) {
  return {key, label, unit, ParamKind::Real, kAutomatic, lowest, highest, true, false, {}, meaning};
}
constexpr ParamDecl integerParam(std::string_view key, std::string_view label, int fallback, int lowest, int highest,
                                 std::string_view meaning) {
  return {key,
          label,
          "",
          ParamKind::Integer,
          static_cast<double>(fallback),
          static_cast<double>(lowest),
          static_cast<double>(highest),
          false,
          false,
          {},
          meaning};
}
constexpr ParamDecl booleanParam(std::string_view key, std::string_view label, bool fallback,
                                 std::string_view meaning) {
  return {key, label, "", ParamKind::Boolean, fallback ? 1.0 : 0.0, 0.0, 1.0, false, false, {}, meaning};
}
constexpr ParamDecl choiceParam(std::string_view key, std::string_view label, int fallback,
                                std::span<const std::string_view> choices, std::string_view meaning) {
  return {key,
          label,
          "",
          ParamKind::Choice,
          static_cast<double>(fallback),
          0.0,
          static_cast<double>(choices.size()) - 1.0,
          false,
          false,
          choices,
          meaning};
}
// The same declaration, but only changeable while nothing runs.
constexpr ParamDecl locked(ParamDecl decl) {
  decl.lockedWhileRunning = true;
  return decl;
}

// A key as a number (FNV-1a), for values that cross to the worker and into recordings; it stays as long as the key
// does.
constexpr std::uint32_t parameterId(std::string_view key) {
  std::uint32_t hash = 2166136261U;
  for (const char c : key) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

// Whether ParamSet::set would take the value. Real-time.
inline bool isLegal(const ParamDecl& decl, double value) noexcept {
  if (std::isnan(value)) return decl.mayBeAutomatic;
  if (decl.kind != ParamKind::Real && value != std::round(value)) return false;
  return value >= decl.lowest && value <= decl.highest;
}

using ParamTable = std::span<const ParamDecl* const>;

}  // namespace stillcut::config
