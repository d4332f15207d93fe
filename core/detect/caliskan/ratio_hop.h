// What the energy-ratio detector hands to its judges (ratio_judge.h, entry_chatter.h, chatter_line.h) with every hop of
// an eighth of a turn: what it knows of each channel and of the cut. Thread: worker; real-time.
#pragma once

#include "core/detect/caliskan/forced_resonance.h"
#include "core/detect/caliskan/line_finder.h"
#include "core/detect/caliskan/load_watch.h"
#include "core/detect/caliskan/order_growth.h"
#include "core/detect/caliskan/turn_marks.h"
#include "core/detect/caliskan/usual_ratio.h"
#include "core/detect/growth/energy_growth.h"
#include "core/detect/growth/new_line.h"
#include "core/model/channel.h"
#include "core/model/sensor_status.h"
#include "core/model/verdict.h"
#include "core/spindle/series_watch.h"

namespace stillcut::detect {

inline constexpr double kLineTurns = 16.0;  // window of the line finder
// A line is looked at every half turn: its spectrum is 16 turns long and the dearest thing here.
inline constexpr int kLookHops = kHopsPerTurn / 2;
inline constexpr double kSettleTurns = 6.0;  // after a restart the filters are not believed
inline constexpr double kHysteresis = 0.5;   // chatter ends at this part of the ratio at which it began

struct RatioChannel {
  EnergyGrowth growth;  // of the turn difference
  EnergyGrowth news;    // of the news (turn_difference.h)
  OrderGrowth orders;
  ForcedResonance forced;
  LoadWatch load;
  double ratio = 0.0;  // ER, smoothed
  UsualRatio usual;    // ... and what it is in the calm cut
  SensorQuantity quantity = SensorQuantity::Acceleration;
};

// One hop, as the detector saw it.
struct RatioHop {
  CutPhase phase = CutPhase::AirCutting;
  Seconds length{};
  Hertz rate{};
  Hertz spindle{};
  Hertz spindleSd{};
  int teeth = 0;                      // 0: nobody told
  Hertz highest{};                    // up to which harmonics are removed
  double steadyTurns = 0.0;           // since the cut became steady
  bool revolutionsComparable = true;  // false: the speed changes too fast to compare turns
  double levelTrend = 1.0;            // of the vibration (conditioned_block.h)
  const EnergyChain* chain = nullptr;
  const NewLine* newLine = nullptr;    // has heard the vibration
  const TurnMarks* marks = nullptr;    // while a machine tells a change; null: none
  const SeriesLook* series = nullptr;  // the lines of the cut
  bool isolatedLine = false;           // a line that cannot be forced holds most of the vibration
  Seconds alarmWait{};                 // evidence must last so long (conditioned_block.h)
};

// Does it hear an integral of the spindle's torque?
inline bool isIntegral(SensorQuantity q) {
  return q == SensorQuantity::SpindleSpeed || q == SensorQuantity::Current;
}

}  // namespace stillcut::detect
