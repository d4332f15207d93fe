// RunTimes: the time of day of what the samples' clock has stamped, and the time since the first sample.
// Thread: the one that looks at the run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/model/snapshot.h"

namespace stillcut::app {

std::int64_t utcNowMs();
// "14:03:22.120", of this computer's time zone.
std::string timeOfDay(std::int64_t utcMs);

class RunTimes {
 public:
  // `live`: stamps are of this computer's steady clock. Else they are of a recording or a simulation, and what is seen
  // now is taken to happen now.
  explicit RunTimes(bool live) : live_(live) {}

  void look(const Snapshot& snapshot);
  std::int64_t utcMs(Instant t) const;
  // Empty before the first sample.
  std::optional<Seconds> sinceBegin(Instant t) const;

 private:
  bool live_;
  std::optional<Instant> begin_;  // of the first block, as a recording counts
  std::int64_t offsetMs_ = 0;     // from stream time to UTC
};

}  // namespace stillcut::app
