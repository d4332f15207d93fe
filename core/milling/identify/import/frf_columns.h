// What each column of a table of frequency responses is: frequency, real part, coherence ... and of which response.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <string>
#include <vector>

#include "core/milling/identify/axis.h"
#include "core/milling/identify/import/number_table.h"

namespace stillcut::identify {

enum class ColumnRole { Unknown, RowNumber, Frequency, Real, Imaginary, Complex, Magnitude, Phase, Coherence };

struct ColumnMeaning {
  ColumnRole role = ColumnRole::Unknown;
  std::string response;        // what is left of the name: columns of one response share it ("gxx"); may be empty
  Axis along = Axis::Unknown;  // of the response
  Axis force = Axis::Unknown;  // of the force; Unknown when the name says nothing of axes
};

// One a column. Without any names: frequency, real, imaginary, as far as the numbers fit that.
std::vector<ColumnMeaning> meaningOfColumns(const NumberTable& table);

// What name, unit and numbers of one column by themselves say; Unknown where they say nothing.
ColumnMeaning meaningOfColumn(const TableColumn& column);

}  // namespace stillcut::identify
