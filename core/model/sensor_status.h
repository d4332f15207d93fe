// What is known of the sensors from what they deliver: for screens and the reason of an invalid verdict. Any thread.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/units.h"
#include "core/model/reason.h"

namespace stillcut {

inline constexpr int kMaxChannels = 32;

struct ChannelStatus {
  double rms = 0.0;     // over about a tenth of a second, without offset [SI]
  double peak = 0.0;    // largest magnitude over the same time [SI]
  double offset = 0.0;  // mean of what the device delivers [SI]
  Reason fault;         // None: can be believed
};

struct SensorStatus {
  int channels = 0;
  std::array<ChannelStatus, kMaxChannels> channel{};
  Hertz nominalRate{};
  Hertz actualRate{};            // against the clock that stamps the blocks; 0: not known yet
  Hertz actualRateSd{};          // its standard deviation
  std::uint64_t lostFrames = 0;  // since the start, as the device reports them
  Reason fault;  // of the signal as a whole, or of the first channel that is left out; None: all can be believed
};

}  // namespace stillcut
