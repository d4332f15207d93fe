// SampleWatch: tells when samples stop and when they come again. It counts what was judged, so that a worker that hangs
// is reported as a device that has gone silent is.
// Thread: the one that looks at the run.
#pragma once

#include <cstdint>

#include "core/base/time.h"

namespace stillcut::app {

class SampleWatch {
 public:
  enum class Turn { None, Stopped, Resumed };

  explicit SampleWatch(Instant now) : last_(now) {}
  // `blocks`: judged so far, of `length` each. Silence is reported after a second, or a few blocks where they are long.
  Turn look(std::uint64_t blocks, Seconds length, Instant now);
  Seconds silent(Instant now) const { return secondsBetween(last_, now); }
  // How long it was silent before the newest block.
  Seconds was() const { return was_; }

 private:
  std::uint64_t blocks_ = 0;
  Instant last_;  // a block came
  Seconds was_{};
  bool stopped_ = false;
};

}  // namespace stillcut::app
