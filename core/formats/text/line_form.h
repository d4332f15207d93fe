// Lines of loggers that are no plain rows of cells, turned into such: Arduino's serial monitor ("10:11:12.123
// -> 1.2,3.4"), its plotter ("ax:0.10 ay:0.20"), and cells with their units ("0.0001s,0.02V"). Pure: any thread; set-up
// and file reading, not real-time.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillcut::record {

struct LineForm {
  enum class Kind { Plain, Arrow, Labels, Units };
  Kind kind = Kind::Plain;
  std::vector<std::string> words;  // of each cell: its label, or its unit
  char delimiter = ' ';            // between cells with units

  // Turns `line` into cells and numbers, in `store`. One with other labels or units than `words` stays as it is: it is
  // no row.
  void apply(std::string_view& line, std::string& store) const;
};

// The form that most of these lines have; nothing: they are plain.
std::optional<LineForm> findLineForm(std::span<const std::string> lines);

}  // namespace stillcut::record
