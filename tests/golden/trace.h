// Trace: a small table of numbers over time, kept as CSV in tests/golden, so that a change of behaviour is a change
// that a reviewer sees line by line.
#pragma once

#include <string>
#include <vector>

namespace stillcut::test {

struct Trace {
  std::vector<std::string> names;         // the first is the time [s]
  std::vector<std::vector<double>> rows;  // as long as `names`

  std::string text() const;  // CSV, six digits
  static Trace parse(const std::string& csv);
};

// Where `now` departs from `kept`: one line each, ten at most; empty where nowhere. A number may differ by `share` of
// the largest in its column; a column of whole numbers (a state) may turn one row earlier or later.
std::string departures(const Trace& kept, const Trace& now, double share);

// Compares with tests/golden/NAME.csv, or writes that file where the environment has STILLCUT_GOLDEN=write.
// What departs, what is missing, or empty.
std::string holdToGolden(const std::string& name, const Trace& now);

}  // namespace stillcut::test
