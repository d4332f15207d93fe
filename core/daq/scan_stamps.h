// ScanStamps: what the time stamps tell that a driver puts on each scan (IIO's timestamp channel): where scans are
// missing, to the scan, and when the others were taken. Stamps are believed once the last half hundred came a period
// apart; a device that empties a queue stamps by the batch, and tells nothing. Their clock need not be ours: the least
// delay from stamp to arrival ties them, and may grow as crystals part.
// Thread: driver; real-time.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/time.h"
#include "core/base/units.h"

namespace stillcut::daq {

class ScanStamps {
 public:
  void prepare(Hertz rate) noexcept;
  // Stamps [ns] of scans in order: how many of them follow each other, and those before, without a loss. 0: scans are
  // missing before the first; asked again, it is the first of a new run.
  int run(std::span<const std::int64_t> stamps) noexcept;
  // The newest stamp of a batch that was seen at `seen`.
  void arrived(std::int64_t newest, Instant seen) noexcept;
  bool believed() const noexcept { return score_ >= kBelieved; }
  // Once believed: when the scan of this stamp was taken, by our clock.
  Instant taken(std::int64_t stamp) const noexcept { return instantFromNs(stamp + delay_); }

 private:
  static constexpr int kBelieved = 48;

  double period_ = 0.0;  // ns
  int score_ = 0;
  bool any_ = false, tied_ = false;
  std::int64_t last_ = 0;                // of the run
  std::int64_t delay_ = 0, tiedAt_ = 0;  // ns
};

}  // namespace stillcut::daq
