// The units of a universal file that holds dataset 164: what a number of the file has to be divided by to be SI.
// Source: Universal File Formats for Modal Analysis Testing, dataset 164, records 1 and 2. Any thread.
#pragma once

#include <optional>
#include <string_view>

namespace stillcut::identify {

struct UffUnits {
  double perMetre = 1.0;   // of the file's length in a metre: 1000 for mm
  double perNewton = 1.0;  // of the file's force in a newton
};

// Of the first dataset 164 in the file; empty where there is none or its numbers are none.
std::optional<UffUnits> unitsOfUff(std::string_view bytes);

}  // namespace stillcut::identify
