// Unit labels of measured functions, as files carry them: what quantity, and the factor to SI.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <optional>
#include <string_view>

#include "core/milling/identify/frf.h"

namespace stillcut::identify {

struct ResponseUnit {
  FrfQuantity quantity = FrfQuantity::Compliance;
  double factor = 1.0;  // to m, m/s or m/s^2 (per N where a force is part of the label)
};

// "mm", "m/s", "g", "(m/s^2)" ...; empty when not known.
std::optional<ResponseUnit> responseUnit(std::string_view label);
// Factor of a force unit to N: "N", "kN", "lbf".
std::optional<double> forceUnit(std::string_view label);
// A whole FRF unit: "m/N", "(m/s^2)/N", "1/N*(m/s2)", "g/lbf" ...
std::optional<ResponseUnit> frfUnit(std::string_view label);

}  // namespace stillcut::identify
