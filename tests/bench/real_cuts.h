// The shared real recordings with what is known about them: TRUTH.csv where there is one, "nothing here may alarm"
// where there is none. For tests and measurements; absent folders give an empty list.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/model/channel.h"

namespace stillcut::bench {

struct TruthSegment {
  double from = 0.0, to = 0.0;  // s from the first sample
  std::string label;            // as TRUTH.csv has it
  bool chatter() const { return label == "chatter"; }
};

struct RealCut {
  std::filesystem::path file;
  int teeth = 0;
  double rpm = 0.0;  // as programmed
  SensorQuantity quantity = SensorQuantity::Acceleration;
  double rate = 0.0;  // Hz, where the file does not say; 0: it does
  std::vector<int> channels;
  std::vector<TruthSegment> segments;  // empty: silent from end to end
};

// recordings: the folder that holds hurco_end_mill and so on.
std::vector<RealCut> realCuts(const std::filesystem::path& recordings);

}  // namespace stillcut::bench
