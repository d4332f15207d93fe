#include "core/milling/identify/import/uff_units.h"

#include <cmath>

#include "core/units/number_scan.h"

namespace stillcut::identify {

std::optional<UffUnits> unitsOfUff(std::string_view bytes) {
  bool begins = false;
  while (!bytes.empty()) {
    const std::string_view line = uff::trimmed(uff::takeLine(bytes));
    if (begins && line == "164") {
      uff::takeLine(bytes);  // the name of the units and how temperatures are meant
      std::string_view factors = uff::trimmed(uff::takeLine(bytes));
      const auto length = uff::takeNumber(factors);
      factors = uff::trimmed(factors);
      const auto force = uff::takeNumber(factors);
      const auto sound = [](const std::optional<double>& v) { return v && std::isfinite(*v) && *v > 0.0; };
      if (!sound(length) || !sound(force)) return std::nullopt;
      return UffUnits{*length, *force};
    }
    begins = line == "-1";
  }
  return std::nullopt;
}

}  // namespace stillcut::identify
