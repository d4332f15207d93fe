// What sensors deliver over some seconds, in one piece, to be judged as a whole: a calibrator's tone, knocks.
// Thread: set-up; hear() waits for the device.
#pragma once

#include <atomic>
#include <vector>

#include "core/base/result.h"
#include "core/daq/daq_source.h"

namespace stillcut::daq {

struct MeasuredSamples {
  std::vector<std::vector<float>> samples;  // by channel: the longest stretch without a gap
  Hertz rate{};
  std::vector<ChannelInfo> channels;
};

// Keeps the longest stretch of blocks without a gap, or the latest where it is as long.
class LongestStretch {
 public:
  explicit LongestStretch(std::size_t channels) : now_(channels), best_(channels) {}
  void take(const SampleBlock& block);
  std::size_t length() const { return now_.front().size(); }  // of the present one [frames]
  std::size_t longest() const;
  bool broken() const { return broken_; }
  std::vector<std::vector<float>> samples() &&;

 private:
  std::vector<std::vector<float>> now_, best_;
  bool broken_ = false;
};

struct MeasureRequest {
  Seconds length{};                             // in one piece
  std::vector<ChannelInfo> told{};              // the profile's channels; empty: the device knows them alone
  const std::atomic<bool>* ended = nullptr;     // set by whoever does not want it any more
  Duration patience = std::chrono::seconds(5);  // beyond twice the length: then it is given up
};

// Of a device that has been opened, and is stopped. Samples are in the units that the profile's scales take: what the
// device knows of its own scale is in them, so that a scale found from them can be saved in the profile. Error: one
// line, within `length` and patience.
Result<MeasuredSamples> measure(DaqSource& device, const SourceFormat& format, const MeasureRequest& request);

}  // namespace stillcut::daq
