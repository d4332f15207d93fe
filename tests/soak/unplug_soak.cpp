// soak_unplug [TIMES]: an audio-class device (ALSA's pulse plugin on a server of our own) is pulled and put back TIMES
// (100 unless told) under the whole pipeline on its threads. Exit code 0: after every one the samples go on by
// themselves, each with one gap of known length, and memory is flat after the first tenth (5 % and 8 MB at most); 77:
// no PulseAudio here.

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <utility>

#include "core/rt/wakeup.h"
#include "tests/soak/heard_device.h"
#include "tests/soak/resident.h"
#include "tests/support/null_sink.h"

namespace stillcut::app {
namespace {

constexpr int kRate = 25600;
constexpr std::uint64_t kWhole = 20;  // blocks that come through between two pulls

bool until(const Clock& clock, const std::function<bool()>& done) {
  rt::Wakeup never;  // only its time-out is used
  for (const Instant end = clock.now() + std::chrono::seconds(15); clock.now() < end;) {
    if (done()) return true;
    never.waitFor(Seconds(0.01));
  }
  return false;
}

int run(int times) {
  testing::NullSink sink;
  if (const std::string missing = sink.start(kRate, 2); !missing.empty()) {
    return std::fprintf(stderr, "%s\n", missing.c_str()), 77;
  }
  const auto clock = std::make_shared<SteadyClock>();
  auto device = heardDevice(kRate, *clock);
  if (!device) return std::fprintf(stderr, "%s\n", device.error().line().c_str()), 2;
  auto built = rigOn(std::move(device).value(), clock);
  if (!built) return std::fprintf(stderr, "%s\n", built.error().line().c_str()), 2;
  Rig& rig = **built;
  rig.start({});
  Snapshot last;
  const auto look = [&] {
    if (const Snapshot* s = rig.read()) last = *s;
  };
  const auto goesOn = [&](std::uint64_t gaps) {
    const std::uint64_t from = last.health.blocks + kWhole;
    return until(*clock, [&] {
      look();
      return last.health.gaps >= gaps && last.health.blocks >= from;
    });
  };
  int back = 0;
  double early = 0.0;
  bool alive = goesOn(0);
  while (alive && back < times) {
    const std::uint64_t gaps = last.health.gaps;
    sink.unplug();
    const std::string unplugged = sink.plug();
    if (!unplugged.empty()) std::fprintf(stderr, "%s\n", unplugged.c_str());
    alive = unplugged.empty() && goesOn(gaps + 1);
    back += alive ? 1 : 0;
    if (early == 0.0 && 10 * back >= times) early = testing::residentMegabytes();
  }
  const double late = testing::residentMegabytes();
  const bool whole = !rig.finished();
  const Status stopped = rig.stop();
  std::printf(
      "%d of %d times back; %llu gaps, %llu samples lost, %llu dropped; memory %.1f MB at a tenth, %.1f MB at "
      "the end\n",
      back, times, static_cast<unsigned long long>(last.health.gaps),
      static_cast<unsigned long long>(last.sensors.lostFrames),
      static_cast<unsigned long long>(last.health.droppedBlocks), early, late);
  return stopped && whole && back == times && testing::flat(early, late) ? 0 : 1;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  return stillcut::app::run(argc > 1 ? std::atoi(argv[1]) : 100);
}
