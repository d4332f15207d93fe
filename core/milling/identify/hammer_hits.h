// Finding and judging the hits in a hammer record; used by analyseHammer(). Pure: any thread; set-up, not real-time.
#pragma once

#include "core/milling/identify/hammer.h"

namespace stillcut::identify {

struct FoundHit {
  Hit hit;
  std::size_t peak = 0;       // sample of the force peak
  std::size_t begin = 0;      // first sample analysed: a little before the pulse rises
  std::size_t end = 0;        // one past the last
  std::size_t quietFrom = 0;  // from here to `quietEnd` nothing moves but what the hit before has left
  std::size_t quietEnd = 0;
};

// Hits in order of time, with their checks done; force already has the push positive and no offset.
std::vector<FoundHit> findHits(const HammerRecord& record, const HammerOptions& options);

}  // namespace stillcut::identify
