// SessionSummary: a whole recording as a reader of a report sees it: what was cut, what happened, what we did about it,
// how the sensors were. Of bounded size however long the recording: curves and spectrogram are thinned, keeping the
// largest of what they merge. Plain values: any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/base/units.h"
#include "core/model/cut_setup.h"
#include "core/model/event.h"
#include "core/model/marker.h"
#include "core/model/operator_input.h"
#include "core/model/recording_answer.h"
#include "core/model/snapshot.h"
#include "core/model/verdict.h"

namespace stillcut {

enum class SensorHealth : std::uint8_t {
  InOrder,
  Dead,     // never moved
  Clipped,  // reached the limit of its input
  Offset,   // a constant part larger than what moves
  Faint,    // far weaker than its strongest neighbour of the same quantity
};

struct SensorSummary {
  ChannelInfo info;
  bool calibrated = false;  // quantity and unit are known, not guessed
  double mean = 0.0;        // [SI units]
  double rms = 0.0;         // without the mean [SI units]
  double peak = 0.0;        // largest magnitude without the mean [SI units]
  SensorHealth health = SensorHealth::InOrder;
};

// One step of the curves: what was largest or worst in it.
struct SummaryPoint {
  Seconds time{};          // since the first sample, middle of the step
  double vibration = 0.0;  // rms of the first channel [SI units]
  double severity = 0.0;   // energy ratio, 0..1
  Hertz frequency{};       // chatter frequency while alarming; 0: none
  CutState state = CutState::AirCutting;
  bool valid = false;     // it was judged, or nothing was cut
  bool gap = false;       // samples are missing in it
  Rpm speed{};            // measured, or programmed where nothing is measured; 0: unknown
  double feed_m_s = 0.0;  // as commanded; 0: unknown
};

// A parameter that somebody set during the cut.
struct SettingChange {
  Seconds time{};     // since the first sample
  std::string key;    // "energy-ratio.chatter"; empty: of a program that had others
  std::string value;  // as text
};

// What the detectors say of a recording when it is looked at, and not while it was made.
struct SummaryAnswer {
  Finding finding = Finding::NotJudged;
  std::vector<Message> sentences;  // the finding first, then what to do
};

struct SessionSummary {
  std::string file;
  std::string kind;  // "Stillcut session", "WAV"
  std::string programVersion;
  std::string configuration;      // TOML, as in force
  std::string operatorName, job;  // empty: not given
  std::int64_t started_ns = 0;    // ns since 1970 UTC; 0: not given
  CutSetup setup;
  bool session = false;  // verdicts and decisions are in the file
  bool simulated = false;
  bool closedCleanly = true;
  Seconds length{};
  std::uint64_t gaps = 0;
  std::uint64_t lostFrames = 0;

  std::uint64_t alarms = 0;  // times that onset or chatter began
  Seconds chatterTime{};
  Metres chatterLength{};
  Authority highestAuthority{};             // that was in force
  std::vector<Intervention> interventions;  // the first few hundred of the alarms
  std::vector<Event> events;                // the first few hundred
  std::uint64_t eventCount = 0;
  std::vector<Marker> markers;                // times since the first sample
  std::vector<SettingChange> settingChanges;  // the first few hundred
  std::uint64_t settingChangeCount = 0;

  std::vector<SummaryPoint> curve;
  std::vector<SpectrumColumn> spectrogram;  // of the first channel
  Seconds columnWidth{};
  Hertz spectrumTop{};
  std::vector<SensorSummary> sensors;
  std::optional<SummaryAnswer> answer;  // empty: nobody has asked
};

}  // namespace stillcut
