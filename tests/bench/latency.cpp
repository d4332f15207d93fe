// From the last sample of a block to its command in the link's mailbox, in real time on the demo's simulated machine:
// first with an ordinary worker thread, then with a FIFO one where the system grants it.
//   bench_latency [SECONDS]      each, 5 unless told

#include <cstdio>
#include <cstdlib>
#include <thread>

#include "app/compose/scenario_rig.h"
#include "core/rt/wakeup.h"
#include "tests/support/demo_cut.h"

namespace stillcut::bench {
namespace {

bool measure(rt::Scheduling scheduling, double seconds) {
  auto built = app::buildScenarioRig(test::demoCut(seconds),
                                     {.methods = app::Methods{}, .params = {}, .live = true, .watched = true});
  if (!built) {
    std::fprintf(stderr, "%s\n", built.error().line().c_str());
    return false;
  }
  app::Rig& rig = *built->rig;
  rig.send({OperatorAction::SetAuthority, Authority::Auto});
  pipeline::EngineOptions options;
  options.worker.scheduling = scheduling;
  options.worker.priority = 70;
  rig.start(options);
  rt::Wakeup never;
  while (!rig.finished()) {
    never.waitFor(Seconds(1.0 / 30.0));
    rig.read();  // a screen that looks
  }
  const pipeline::Engine& engine = *rig.engine();
  const rt::DeadlineStats& latency = engine.latency();
  const bool fifo = engine.workerScheduling() == rt::Scheduling::Fifo;
  const auto ms = [](Seconds s) { return s.value * 1e3; };
  std::printf("%-10s %8llu %9.3f %9.3f %9.3f %9.3f %8llu%s\n", fifo ? "FIFO" : "ordinary",
              static_cast<unsigned long long>(latency.count()), ms(latency.quantile(0.5)), ms(latency.quantile(0.99)),
              ms(latency.quantile(0.999)), ms(latency.worst()), static_cast<unsigned long long>(engine.droppedBlocks()),
              scheduling == rt::Scheduling::Fifo && !fifo ? "  (FIFO was asked for and not granted)" : "");
  const Status stopped = rig.stop();
  if (!stopped) std::fprintf(stderr, "%s\n", stopped.error().line().c_str());
  return stopped.ok();
}

}  // namespace
}  // namespace stillcut::bench

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 5.0;
  if (!(seconds >= 5.0 && seconds <= 3600.0)) {
    std::fprintf(stderr, "bench_latency: SECONDS from 5 to 3600\n");
    return 2;
  }
  if (!stillcut::rt::lockMemory()) std::printf("(memory is not locked: not permitted)\n");
  std::printf("block to command, blocks of 10 ms, milliseconds (buckets 12 %% apart)\n");
  std::printf("%-10s %8s %9s %9s %9s %9s %8s\n", "worker", "blocks", "p50", "p99", "p99.9", "worst", "dropped");
  const bool good = stillcut::bench::measure(stillcut::rt::Scheduling::Ordinary, seconds) &&
                    stillcut::bench::measure(stillcut::rt::Scheduling::Fifo, seconds);
  return good ? 0 : 3;
}
