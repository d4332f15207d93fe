// SimulationReport: what became of a simulated cut under control, measured with the plant's own truth and compared with
// the same cut left alone.
// Thread: one; not the sample path.
#pragma once

#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/milling/simulation/simulated_cut.h"
#include "core/model/step_record.h"

namespace stillcut::evaluate {

// What the report needs to remember of each block of one run.
class SimulationHistory {
 public:
  void observe(const StepInput& input, const StepOutput& output, const milling::SimulatedCut& plant);
  // The cut is over: what its truth tells only afterwards.
  void finish(const milling::SimulatedCut& plant);

  struct Point {
    double t = 0.0;           // [s] since the first sample
    double vibration = 0.0;   // rms of the tip's acceleration [m/s^2]
    bool chattering = false;  // truth
    bool cutting = false;
    bool usable = false;  // verdict in charge valid
    bool alarming = false;
    bool commandMoves = false;  // a Set away from 100 % was issued
    double speedFactor = 1.0;   // commanded
  };
  const std::vector<Point>& points() const { return points_; }
  // Of the last block in the cut.
  const MachineState& lastMachine() const { return lastMachine_; }
  ReasonCode lastRequestReason() const { return lastRequest_; }
  MetresPerSecond nominalFeed() const { return nominalFeed_; }
  double onset() const { return onset_; }  // [s] chatter is 20 % of the vibration, by truth; NaN: never

 private:
  std::vector<Point> points_;
  MachineState lastMachine_;
  ReasonCode lastRequest_ = ReasonCode::None;
  MetresPerSecond nominalFeed_{};
  double onset_ = std::numeric_limits<double>::quiet_NaN();
};

struct SimulationReport {
  std::string scenario, strategy;
  std::string outcome;  // stable, no-stable-speed, hold, chatter
  // [s] from the true 20 % onset of the cut left alone, which is the same cut until the first command, to the first
  // alarm; NaN: none of the two. Negative: the alarm came before.
  double alarmDelay = 0.0;
  double commandDelay = 0.0;  // [s] from the alarm to the first command that moves
  double quietDelay = 0.0;    // [s] from that command to the end of the true chatter
  double marked = 0.0;        // [mm] of path cut in true chatter
  double peakRatio = 0.0;     // strongest vibration, against the cut left alone
  double finalRatio = 0.0;    // vibration over the last second in the cut, against the cut left alone
  double finalSpeed = 0.0;    // [rpm]
  double finalFeed = 0.0;     // [mm/min]
  double mrrRatio = 0.0;      // removal rate at the end against the programmed one
  int speedChanges = 0;       // moves of the commanded speed that start from rest or reverse
};

SimulationReport report(const SimulationHistory& controlled, const SimulationHistory& alone,
                        const milling::SimulatedCut& plant);

nlohmann::json toJson(const SimulationReport& report);
std::string toText(const SimulationReport& report);

}  // namespace stillcut::evaluate
