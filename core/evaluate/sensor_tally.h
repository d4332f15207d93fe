// What can be said of the sensors from what they delivered. Thread: one; not real-time.
#pragma once

#include <vector>

#include "core/formats/recording_reader.h"
#include "core/model/sample_block.h"
#include "core/model/session_summary.h"

namespace stillcut::evaluate {

class SensorTally {
 public:
  explicit SensorTally(const std::vector<record::RecordedChannel>& channels);
  void add(const SampleBlock& block);
  // Of the first channel in the block last added, without its mean [SI units].
  double blockRms() const { return blockRms_; }
  std::vector<SensorSummary> finish() const;

 private:
  struct Sums {
    record::RecordedChannel channel;
    double count = 0.0;
    double mean = 0.0;  // running, as is what deviates from it: sums of squares would lose a small signal on an offset
    double m2 = 0.0;
    double lowest = 0.0;
    double highest = 0.0;
    std::uint64_t atLimit = 0;  // samples in runs that stay at the lowest or highest value of all
    double limitValue = 0.0;
    int run = 0;
  };
  void addSample(Sums& sums, double value);

  std::vector<Sums> all_;
  bool clipped_ = false;  // by the driver's own word
  double blockRms_ = 0.0;
};

}  // namespace stillcut::evaluate
