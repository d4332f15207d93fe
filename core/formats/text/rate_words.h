// The sampling rate as the header or the footer of a table states it: "Sampling rate [Hz]:,10000", "# fs = 51.2 kHz",
// "Sample Interval,Analog:0.0003125", "Rate 3200, overflows 0", "Delta t: 0.1 ms", or an Increment with its number in
// the line below. Pure: any thread; set-up, not real-time.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/text/text_cells.h"

namespace stillcut::record {

struct StatedRates {
  std::vector<double> hertz;
  std::string unclear;  // "102.400" beside decimal commas: a number that could be read in two ways; empty: none is
};

// The rates in one line that is no row.
StatedRates ratesInLine(std::string_view line, const CellFormat& cells);

// The same of several lines; a key without a number behind it has it in the same cell of the next line.
StatedRates ratesInLines(std::span<const std::string> lines, const CellFormat& cells);

}  // namespace stillcut::record
