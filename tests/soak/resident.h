// How much memory this process has, and whether that is flat.
#pragma once

#include <algorithm>
#include <fstream>

namespace stillcut::testing {

inline double residentMegabytes() {
  std::ifstream status("/proc/self/statm");
  double all = 0.0;
  double resident = 0.0;
  status >> all >> resident;
  return resident * 4096.0 / 1e6;
}

// After the first tenth of a run: 5 % or 8 MB, the larger.
inline bool flat(double early, double late) {
  return late < std::max(1.05 * early, early + 8.0);
}

}  // namespace stillcut::testing
