// soak_recording [KILLS] [POWER_LOSSES] [SEED]: kills a recording child at random moments, and cuts the power of a
// recording at random moments with any of its last pages torn; prints what was found each way. Exit code 0: every file
// opened, whole up to its last second (killed) or its last flush (power).

#include <cstdio>
#include <cstdlib>

#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

constexpr int kStepsPerSecond = 400;
constexpr int kMostSteps = 4000;  // ten seconds of stream

struct Tally {
  int rounds = 0, opened = 0, damaged = 0, tooShort = 0;
  int worst = 0;       // steps missing
  double missing = 0;  // sum of them

  bool good() const { return opened == rounds && damaged == 0 && tooShort == 0; }
  void add(const WhatIsLeft& left, int expected, int allowed) {
    ++rounds;
    opened += left.opens ? 1 : 0;
    damaged += left.damaged ? 1 : 0;
    const int gone = std::max(0, expected - left.steps);
    tooShort += gone > allowed ? 1 : 0;
    worst = std::max(worst, gone);
    missing += gone;
    if (!left.error.empty()) std::printf("  %s\n", left.error.c_str());
  }
  void print(const char* what) const {
    std::printf("%-12s %d files, %d open, %d damaged, %d too short; missing %.3f s on average, %.3f s at worst\n", what,
                rounds, opened, damaged, tooShort, missing / std::max(1, rounds) / kStepsPerSecond,
                static_cast<double>(worst) / kStepsPerSecond);
  }
};

Tally killed(int rounds, std::mt19937& random) {
  Tally tally;
  for (int round = 0; round < rounds; ++round) {
    const TempFolder folder;
    const int added = recordUntilKilled(folder / "cut.h5", std::uniform_int_distribution<int>(0, kMostSteps)(random));
    tally.add(look(folder / "cut.h5"), added, kStepsPerSecond);
  }
  return tally;
}

Tally powerLost(int rounds, std::mt19937& random) {
  const TempFolder folder;
  RememberingDisk disk;
  SessionWriterOptions options;
  options.powerSafe = true;
  options.disk = &disk;
  std::vector<std::pair<std::size_t, int>> flushed;
  {
    auto writer = SessionWriter::create(folder / "cut.h5", exampleHeader(), options);
    if (!writer) return {1};
    flushed.emplace_back(disk.operations(), 0);
    for (int i = 0; i < kMostSteps; ++i) {
      const StepRecord step = exampleStep(i);
      if (!(*writer)->add(step.input, step.output)) return {1};
      if (disk.operations() != flushed.back().first) flushed.emplace_back(disk.operations(), i + 1);
    }
  }
  flushed.emplace_back(disk.operations(), kMostSteps);
  Tally tally;
  for (int round = 0; round < rounds; ++round) {
    const std::size_t at = std::uniform_int_distribution<std::size_t>(flushed.front().first, disk.operations())(random);
    disk.powerLoss(at, random, folder / "image.h5");
    int expected = 0;
    for (const auto& [operations, steps] : flushed) expected = operations <= at ? steps : expected;
    tally.add(look(folder / "image.h5"), expected, 0);
  }
  return tally;
}

}  // namespace
}  // namespace stillcut::record

int main(int argc, char** argv) {
  const int kills = argc > 1 ? std::atoi(argv[1]) : 200;
  const int losses = argc > 2 ? std::atoi(argv[2]) : 200;
  std::mt19937 random(argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1U);
  const auto byKill = stillcut::record::killed(kills, random);
  byKill.print("killed");
  const auto byPower = stillcut::record::powerLost(losses, random);
  byPower.print("power lost");
  return byKill.good() && byPower.good() ? 0 : 1;
}
