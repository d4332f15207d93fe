// soak_acquisition [SECONDS]: SECONDS (600 unless told) of 8 channels at 102.4 kHz from the simulated device, paced to
// the clock, through the whole pipeline on its threads. Prints blocks, losses, the rate against the clock, the time of
// a block and memory. Exit code 0: nothing dropped, no gap, its end within two seconds of the clock's, and memory flat
// after the first tenth (5 % or 8 MB, the larger).

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/compose/scenario_rig.h"
#include "core/milling/simulation/chatter_truth.h"
#include "core/rt/wakeup.h"
#include "tests/soak/resident.h"

namespace stillcut::app {
namespace {

constexpr double kBehind = 2.0;  // s: what the ring holds

int run(double seconds) {
  auto loaded = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/production-stable.toml");
  if (!loaded) return std::fprintf(stderr, "%s\n", loaded.error().line().c_str()), 2;
  milling::Scenario cut = std::move(loaded).value();
  cut.rate = Hertz(102400.0);
  cut.blockFrames = 1024;
  cut.programme.duration = Seconds(seconds);
  while (cut.sensors.size() < 8) cut.sensors.push_back(cut.sensors[cut.sensors.size() % 2]);
  for (std::size_t i = 0; i < cut.sensors.size(); ++i) cut.sensors[i].name = std::to_string(i);
  auto built = buildScenarioRig(cut, {.methods = {}, .params = {}, .live = true, .watched = true});
  if (!built) return std::fprintf(stderr, "%s\n", built.error().line().c_str()), 2;
  // As a rig starts a device that is live, which the simulated one is not.
  pipeline::EngineOptions options;
  options.worker.scheduling = rt::Scheduling::Fifo;
  options.ringBlocks = static_cast<int>(2.0 * cut.rate.value / cut.blockFrames);
  const SteadyClock clock;
  const Instant begin = clock.now();
  built->rig->start(options);
  Snapshot last;
  double early = 0.0;
  rt::Wakeup never;  // only its time-out is used
  while (!built->rig->finished()) {
    never.waitFor(Seconds(0.1));
    if (const Snapshot* s = built->rig->read()) last = *s;
    if (early == 0.0 && sinceEpoch(last.time).value > 0.0 && static_cast<double>(last.health.blocks) > seconds * 10.0) {
      early = testing::residentMegabytes();
    }
  }
  // The simulated device waits for whoever reads it: what cannot keep up ends late, and drops nothing.
  const double behind = secondsBetween(begin, clock.now()).value - seconds;
  // The simulated cut keeps its truth of every millisecond; what is left is the path's.
  const double truth = 0.9 * seconds * 1e3 * sizeof(milling::ChatterTruth::LogEntry) / 1048576.0;
  const double late = testing::residentMegabytes() - truth;
  const Status stopped = built->rig->stop();
  std::printf("%llu blocks, %llu dropped, %llu gaps, %llu overruns; %.3f Hz against the clock (sd %.3f)\n",
              static_cast<unsigned long long>(last.health.blocks),
              static_cast<unsigned long long>(last.health.droppedBlocks),
              static_cast<unsigned long long>(last.health.gaps), static_cast<unsigned long long>(last.health.overruns),
              last.sensors.actualRate.value, last.sensors.actualRateSd.value);
  std::printf("worst block %.2f ms of %.2f; sensors: %s; memory %.1f MB at a tenth, %.1f MB at the end\n",
              last.health.worstProcessing.value * 1e3, last.health.blockLength.value * 1e3,
              last.sensors.fault.code == ReasonCode::None ? "sound" : sentence(last.sensors.fault).c_str(), early,
              late);
  std::printf("ended %.2f s after the clock's %.0f s\n", behind, seconds);
  return stopped && std::abs(behind) < kBehind && last.health.droppedBlocks == 0 && last.health.gaps == 0 &&
                 testing::flat(early, late)
             ? 0
             : 1;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  return stillcut::app::run(argc > 1 ? std::atof(argv[1]) : 600.0);
}
