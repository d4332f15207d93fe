// CutTrace: all of one simulated cut that a figure may show: samples, what the detectors said block by block, machine
// and truth.
// Thread: one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "core/detect/detector.h"
#include "core/evaluate/simulation_report.h"
#include "core/milling/simulation/scenario.h"
#include "core/model/rule_tables.h"

namespace stillcut::app {

struct TraceRow {
  double t = 0.0;        // [s] end of the block
  double path_mm = 0.0;  // of feed since the tool met the material
  double depth_mm = 0.0, speed_rpm = 0.0, feed_mm_min = 0.0;
  double asked_rpm = 0.0;     // our command, on the programmed speed
  double vibration = 0.0;     // rms of the tip's acceleration [m/s^2]
  double chatterRatio = 0.0;  // truth
  bool cutting = false;
  std::vector<Verdict> verdicts;  // of each detector
};

struct CutTrace {
  std::string name;  // of the strategy
  Hertz rate{};
  int teeth = 1;
  std::vector<ChannelInfo> channels;
  std::vector<std::vector<double>> samples;  // [channel][frame], SI
  std::vector<TraceRow> rows;
  std::vector<detect::DetectorInfo> detectors;
  evaluate::SimulationHistory history;
  std::optional<RuleTables> rules;  // of a fuzzy strategy, at the end
  double chatterHz = 0.0;           // truth
  double onset20_s = 0.0;           // truth; not a number: never

  // Of the detector with this id; -1: it did not run.
  int detector(std::string_view id) const;
  int indicator(int which, std::string_view id) const;
  // Time of the first alarm of the detector in charge; empty: none.
  const TraceRow* firstAlarm() const;
};

struct TraceRequest {
  std::string strategy = "monitor";
  std::vector<std::string> detectors;  // the first is in charge; empty: the default one
  std::vector<std::string> settings;   // KEY=VALUE
};

Result<CutTrace> traceCut(milling::Scenario scenario, const TraceRequest& request);

}  // namespace stillcut::app
