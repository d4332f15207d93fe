// Names and units of a table's columns, from the lines above its numbers. Pure: any thread; set-up, not real-time.
#pragma once

#include <string>

#include "core/milling/identify/import/number_table.h"

namespace stillcut::identify {

// From the nearest line that has as many cells as there are columns; a line of units below it gives the units.
void nameColumns(NumberTable& table, char delimiter);

// What the header says of an axis in a line of its own: "Y-Axis unit: (m/s2)/N", "X_Unit_Label<tab>Hz". Empty: nothing.
std::string unitOfAxis(const NumberTable& table, char axis);

// "m/N", "Hz", "deg", "s": any label that a column of a frequency response or of a hammer record may carry.
bool isColumnUnit(std::string_view label);

}  // namespace stillcut::identify
