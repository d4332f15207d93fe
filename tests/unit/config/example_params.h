// A handful of declarations of every kind, as a detector would have them.
#pragma once

#include <array>
#include <string_view>

#include "core/config/param_set.h"

namespace stillcut::config::example {

inline constexpr std::array<std::string_view, 3> kWindows{"hann", "flat-top", "none"};
inline constexpr ParamDecl kThreshold =
    realParam("energy-ratio.threshold", "Threshold", "", 0.2, 0.0, 1.0, "Alarm above this ratio");
inline constexpr ParamDecl kBand = autoParam("energy-ratio.band", "Band", "Hz", 1.0, 5000.0, "Highest frequency used");
inline constexpr ParamDecl kHarmonics =
    integerParam("energy-ratio.harmonics", "Harmonics", 32, 1, 256, "Harmonics removed");
inline constexpr ParamDecl kRelearn = booleanParam("spectral.relearn", "Learn again", false, "After every tool");
inline constexpr ParamDecl kWindow = choiceParam("spectral.window", "Window", 0, kWindows, "Of each segment");
inline constexpr ParamDecl kLimit =
    locked(realParam("gate.highest-speed-override", "Highest", "%", 120.0, 100.0, 200.0, "Limit"));
inline constexpr const ParamDecl* kAll[] = {&kThreshold, &kBand, &kHarmonics, &kRelearn, &kWindow, &kLimit};

inline ParamCatalog catalog() {
  ParamCatalog all;
  all.add(kAll);
  return all;
}

}  // namespace stillcut::config::example
