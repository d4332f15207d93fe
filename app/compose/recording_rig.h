// A rig on a recording. Either other methods run on what was measured, or the recorded run itself is decided again from
// what went into it. There is no machine: what is commanded goes nowhere.
// Thread: set-up.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/compose/rig.h"
#include "core/daq/replay_control.h"
#include "core/evaluate/recording_judge.h"
#include "core/formats/recording_reader.h"

namespace stillcut::app {

// A replay led by hand: paced, paused, stepped, looped (replay_run.h runs it on a thread of its own). Its rig is
// watched.
struct ReplayPacing {
  std::shared_ptr<daq::ReplayControl> control;  // empty: straight through, as fast as possible
  const Clock* clock = nullptr;                 // with a control; outlives the rig
};

struct RecordingOptions {
  record::ReadOptions read;
  int teeth = 0;                                     // 0: as the recording says, or unknown
  Rpm speed{};                                       // 0: as the recording says, or unknown
  std::vector<pipeline::SpeedLogSource::Point> log;  // measured speed; empty: none
  Methods methods{.detectors = {"energy-ratio"}, .fallback = {}, .strategy = "monitor"};
  config::ParamSet params;
  std::optional<StableSpeeds> stableSpeeds;  // by the lobes, where a profile knows them
  config::SpeedRange reach;                  // of the spindle, where a profile says it
  Metres depthLimit{};                       // of `speed`, by the lobes; 0: not known
  ReplayPacing hand;
};

struct RecordingRig {
  std::unique_ptr<Rig> rig;
  record::RecordingFormat format;
  evaluate::JudgedRecording judged;  // what a RecordingJudge of this rig needs to know
};

// `path`: any recording, or a scenario (.toml), whose cut is then simulated with nobody at the overrides. Channels of
// foreign files that are no vibration by what they hold are left out, unless channels are named in `read`.
Result<RecordingRig> buildRecordingRig(const std::string& path, const RecordingOptions& options);

// A session, decided again: its own methods, parameters, limits and leave for Auto, its machine states and operator
// inputs. The same program gives the same verdicts, requests and commands, bit by bit. An error for a recording that
// does not say how it was made.
Result<RecordingRig> buildReplayRig(const std::string& path, const ReplayPacing& hand = {});

// CSV with the header t,rpm; times rising.
Result<std::vector<pipeline::SpeedLogSource::Point>> readSpeedLog(const std::string& path);

}  // namespace stillcut::app
