// The shared real recordings with what is known about them: TRUTH.csv where there is one, "nothing here may alarm"
// where there is none. For tests and measurements; absent folders give an empty list.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/detect/detector.h"
#include "core/model/channel.h"

namespace stillcut::bench {

struct TruthSegment {
  double from = 0.0, to = 0.0;  // s from the first sample
  std::string label;            // as TRUTH.csv has it
  bool chatter() const { return label == "chatter"; }
  // Where nothing may alarm: not while the tool leaves or the spindle changes its speed.
  bool silent() const { return label == "stable" || label == "idle" || label.starts_with("entry"); }
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

// What one detector did on one of them.
struct Tally {
  std::unique_ptr<detect::Detector> detector;
  std::string id;
  double delay = -1.0;                         // s, of the first alarm in the chatter segment; -1: no alarm
  double alarm = 0.0, chatter = 0.0;           // s in alarm and in full chatter there
  double falseAlarm = 0.0, firstFalse = -1.0;  // s in alarm outside, and where the first one began
  double falseInSegment = 0.0;  // s of it in what is labelled stable, idle or entry, or anywhere if nothing is
  double invalid = 0.0;
};

// Through the conditioner and every detector wanted (all where none is named), told speed off by `error` as a ratio;
// -1: not told. channels: of the file; empty: all. begin: s, from where on it is listened to.
Result<std::vector<Tally>> judgeRealCut(const RealCut& cut, const std::vector<int>& channels, double error,
                                        const std::vector<std::string>& wanted, double begin = 0.0,
                                        const std::function<void(const detect::ConditionedBlock&)>& observe = {});
// s, labelled chatter.
double chatterLength(const RealCut& cut);

// recordings: the folder that holds hurco_end_mill and so on.
std::vector<RealCut> realCuts(const std::filesystem::path& recordings);
// Those that came later, on which the default detector still falls short of the rest in places.
std::vector<RealCut> laterCuts(const std::filesystem::path& recordings);

}  // namespace stillcut::bench
