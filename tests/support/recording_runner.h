// Runs a recording through the conditioner and one detector, block by block, as the worker does.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/detect/detector.h"
#include "core/model/cut_setup.h"
#include "core/sensing/conditioner.h"

namespace stillcut::detect::testing {

struct Recording {
  double rate = 0.0;
  std::vector<std::vector<float>> channels;
  std::size_t frames() const { return channels.empty() ? 0 : channels[0].size(); }
};

// Float or PCM .wav by libsndfile; every channel. Fails the test when it cannot be read.
Recording readWav(const std::filesystem::path& path);

// A table with a column of times; every channel, in SI units. Fails the test when it cannot be read.
Recording readTable(const std::filesystem::path& path);

struct RunOptions {
  int teeth = 0;
  double rpm = 0.0;  // told
  SensorQuantity quantity = SensorQuantity::Acceleration;
  int blockFrames = 64;
  std::vector<int> channels;  // empty: all
  std::vector<std::pair<std::string, double>> params;
  // Called after every block.
  std::function<void(const ConditionedBlock&, const Verdict&)> onBlock;
  // The machine's read-back at a time; empty: no machine.
  std::function<MachineState(double)> machine;
};

struct RunResult {
  std::vector<Verdict> verdicts;
  double firstAlarm = -1.0;  // s, -1: none
  double alarmTime = 0.0;    // s spent in onset or chatter
  // First verdict at or after t.
  const Verdict& at(double t) const;
  // Alarm time inside t0..t1.
  double alarmTimeIn(double t0, double t1) const;
  double firstAlarmAfter(double t0) const;
};

CutSetup setupFor(const Recording& recording, const RunOptions& options);
RunResult run(const Recording& recording, const RunOptions& options, Detector& detector);
RunResult run(const Recording& recording, const RunOptions& options, const std::string& detector = "energy-ratio");

inline std::filesystem::path sharedDir() {
  return STILLCUT_SHARED_DIR;
}

}  // namespace stillcut::detect::testing

// Skips the test where the reference material is absent.
#define STILLCUT_NEEDS(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "reference material not found: " << (path)
