// ConditionedBlock: what the conditioner hands to every detector. Views into the conditioner's own storage, good until
// its next block. Thread: worker.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/machine_state.h"
#include "core/model/reason.h"
#include "core/model/sensor_status.h"
#include "core/model/verdict.h"
#include "core/spindle/series_watch.h"

namespace stillcut::detect {

struct ConditionedBlock {
  std::uint64_t sequence = 0;
  Instant firstSample{};
  Hertz rate{};
  int channels = 0;
  int frames = 0;
  bool valid = false;       // false: detectors hold their state and say `reason`
  bool afterGap = false;    // samples were lost just before: filters must restart
  Reason reason;            // why not valid
  bool overloaded = false;  // a sensor is at its limit: chatter is heard all the same, that a cut is stable is not
  CutPhase phase = CutPhase::AirCutting;
  Seconds alarmWait{};         // evidence must last so long: what seems to grow may be a drive's tone that glides
  double levelTrend = 1.0;     // mean square of the last turn over that of the last few
  Hertz spindle{};             // best estimate at the end of the block; 0: unknown
  Hertz spindleSd{};           // its doubt
  SeriesLook series;           // the lines of every channel, as of a few times a second
  Hertz isolatedLine{};        // holds most of the vibration and cannot be forced (speed_tracker.h); 0: none
  bool speedChanging = false;  // the angle follows a machine that changes its speed
  bool revolutionsComparable = true;  // false: its speed changes too fast to compare one turn with the next
  const double* samples = nullptr;    // [channel * stride + frame], SI units, high-passed; 0 of a channel left out
  std::ptrdiff_t stride = 0;
  const double* angle = nullptr;      // [frame], integrated spindle angle in rad, wrapped to 0..2 pi
  const double* angleStep = nullptr;  // [frame], rad per sample: 2 pi f_sp / F_s
  MetresPerSecond feed{};             // actual feed, 0: unknown

  std::span<const double> channel(int c) const { return {samples + c * stride, static_cast<std::size_t>(frames)}; }
  // A told speed that the signal does not confirm is no speed to judge a cut by; while the spindle runs up there is
  // nothing to judge, and it is the reason.
  bool speedKnown() const { return spindle.value > 0.0 && phase != CutPhase::RunUp; }
  Instant end() const { return firstSample + toDuration(Seconds(frames / rate.value)); }
};

}  // namespace stillcut::detect
