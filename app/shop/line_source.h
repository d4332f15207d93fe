// LineSource: where the lines of a run come from, and how far they were read. Reading never blocks. Thread: one.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace stillcut::shop {

struct SourceLine {
  std::string text;    // one JSON object
  std::string cursor;  // where to go on after it, as resume() takes it
};

class LineSource {
 public:
  virtual ~LineSource() = default;
  // What came since the last call, `atMost` lines. An error ends the program: there is nothing to follow.
  virtual Result<std::vector<SourceLine>> read(std::size_t atMost) = 0;
  // Readable or changed: read() may have more. -1: nothing tells, look every second.
  virtual int descriptor() const = 0;
  // Reading goes on at a place of before, within the run that was read then. False: it began somewhere, perhaps
  // earlier.
  virtual bool goesOn() const = 0;
  // All that is there was read; of standard input: and nothing more can come.
  virtual bool atEnd() const = 0;
};

}  // namespace stillcut::shop
