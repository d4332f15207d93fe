// Hands on the spectrogram columns that are new since the last look, in order. What the ring of the snapshot has
// already lost shows as a jump in the numbers, never as a shorter time.
#pragma once

#include <algorithm>

#include "core/model/snapshot.h"

namespace stillcut::ui {

class SpectrumColumnReader {
 public:
  template <class Sink>  // void(const SpectrumColumn&)
  void read(const Snapshot& snapshot, Sink&& sink) {
    if (snapshot.columnCount < next_) next_ = 0;  // a new run counts from 0 again
    const std::uint64_t kept = std::min<std::uint64_t>(snapshot.columnCount, kSpectrumColumns);
    for (std::uint64_t n = std::max(next_, snapshot.columnCount - kept); n < snapshot.columnCount; ++n) {
      sink(snapshot.columns[n % kSpectrumColumns]);
    }
    next_ = snapshot.columnCount;
  }

 private:
  std::uint64_t next_ = 0;
};

}  // namespace stillcut::ui
