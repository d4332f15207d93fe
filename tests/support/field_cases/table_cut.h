// The cut that the tables of user_tables.h hold: two flutes, three axes of acceleration, stable from 1.5 s on, with
// chatter from 4 s to the end.
// Thread: any; no state.
#pragma once

#include <cstdint>
#include <vector>

#include "tests/support/field_cases/field_case.h"

namespace stillcut::field {

struct TableCut {
  double spindle = 100.0;  // Hz
  double chatter = 743.7;  // Hz
  std::uint64_t seed = 1;
};

inline constexpr double kTableRate = 3200.0;  // Hz; some tables announce it in their head
inline constexpr double kTableLength = 8.0;   // s
inline constexpr std::size_t kTableRows = 25600;

struct TableSamples {
  std::vector<double> t;        // s
  std::vector<double> x, y, z;  // m/s^2; z with gravity
};
TableSamples tableSamples(const TableCut& s);

// Its first `axes` axes.
FieldCase tableCase(const TableCut& s, const TableSamples& samples, int axes);

}  // namespace stillcut::field
