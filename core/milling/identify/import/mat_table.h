// The variables of a MATLAB file (version 5 to 7.2) as columns of one table, complex ones included, which recordings
// have no place for. Thread: any, set-up path. Errors: one line.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/milling/identify/import/number_table.h"

namespace stillcut::identify {

// Numeric vectors of the length that most have; a matrix gives a column for each of its columns. Text variables
// "x_unit" give the unit of "x". Structs are looked into. Error when there is no such file, or fewer than two vectors
// of one length.
Result<NumberTable> readMatTable(const std::string& path);

}  // namespace stillcut::identify
