// What is known about the cut before it starts: the tool, the programmed values, the channels. Any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/units.h"
#include "core/model/channel.h"

namespace stillcut {

// Stable speeds at the cut's depth, worked out at set-up where modes and material are known.
struct StableSpeeds {
  struct Range {
    Rpm from{}, to{};
    Rpm best{};  // carries the largest depth
  };
  Metres depth{};               // that they were worked out for
  std::vector<Range> ranges;    // by speed; empty: no speed in reach carries this depth
  Rpm largestDepthSpeed{};      // where `ranges` is empty: the speed that carries most,
  Metres largestStableDepth{};  // and how much
};

struct CutSetup {
  std::string machine;            // "Mill 3"
  std::string tool;               // "T12 D12 Z4 HSK63 stick-out 48"
  int teeth = 0;                  // 0: unknown
  Metres toolDiameter{};          // 0: unknown
  Rpm nominalSpeed{};             // as programmed or given; 1 to 2 % wrong in practice; 0: unknown
  MetresPerSecond nominalFeed{};  // 0: unknown
  Hertz rate{};                   // of every channel
  int blockFrames = 0;            // frames per block, largest
  std::vector<ChannelInfo> channels;
  std::optional<StableSpeeds> stableSpeeds;  // empty: the modes are not known
};

}  // namespace stillcut
