// SeriesLog: the `--series` file. CSV with a header, first column t, then DETECTOR.NAME, one row per block. Of each
// detector its indicators, then state (air, stable, onset, chatter), valid (1, 0: the state of that row was not judged)
// and speed_rpm, the spindle speed it used (empty: unknown).
// Thread: one; not the sample path.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/detect/detector.h"

namespace stillcut::evaluate {

class SeriesLog {
 public:
  // `more`: columns behind the detectors', as many as observe() is given each time.
  SeriesLog(std::span<const detect::DetectorInfo> detectors, Instant begin, std::span<const std::string> more = {});
  void observe(std::span<const Verdict> verdicts, std::span<const double> more = {});
  Status write(const std::string& path) const;

 private:
  std::vector<std::size_t> counts_;  // indicators per detector
  Instant begin_;
  std::string text_;
};

}  // namespace stillcut::evaluate
