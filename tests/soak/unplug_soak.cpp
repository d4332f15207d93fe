// soak_unplug [TIMES [DEVICE...]]: a device is pulled and put back TIMES (100 unless told) under the whole pipeline on
// its threads; one after the other unless named: alsa (ALSA's pulse plugin on a server of our own), serial (a pty), tcp
// (a bridge that closes), iio (an iiod that closes). Exit code 0: after every one the samples go on by themselves, each
// with one gap of known length, and memory is flat after the first tenth (5 % or 8 MB, the larger); 77: no PulseAudio
// here, and nothing else failed.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/rt/wakeup.h"
#include "tests/soak/heard_device.h"
#include "tests/soak/resident.h"
#include "tests/soak/unplug_peers.h"
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

class SoundPeer final : public testing::Peer {
 public:
  std::string plug() override { return std::exchange(started_, true) ? sink_.plug() : sink_.start(kRate, 2); }
  void unplug() override { sink_.unplug(); }
  const char* source() const override { return "alsa"; }
  std::map<std::string, std::string> settings() const override {
    return {{"device", "heard"}, {"rate_hz", std::to_string(kRate)}};
  }

 private:
  testing::NullSink sink_;
  bool started_ = false;
};

std::unique_ptr<testing::Peer> peerOf(const std::string& name) {
  if (name == "alsa") return std::make_unique<SoundPeer>();
  if (name == "serial") return std::make_unique<testing::SerialPeer>();
  if (name == "tcp") return std::make_unique<testing::SocketPeer>();
  if (name == "iio") return std::make_unique<testing::IioPeer>();
  return nullptr;
}

int run(const std::string& name, int times) {
  const auto peer = peerOf(name);
  if (!peer) return std::fprintf(stderr, "%s is not known: alsa, serial, tcp, iio\n", name.c_str()), 2;
  if (const std::string missing = peer->plug(); !missing.empty()) {
    return std::fprintf(stderr, "%s\n", missing.c_str()), 77;
  }
  const auto clock = std::make_shared<SteadyClock>();
  auto device = deviceOf(peer->source(), peer->settings(), *clock);
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
    peer->unplug();
    const std::string unplugged = peer->plug();
    if (!unplugged.empty()) std::fprintf(stderr, "%s\n", unplugged.c_str());
    alive = unplugged.empty() && goesOn(gaps + 1);
    back += alive ? 1 : 0;
    if (early == 0.0 && 10 * back >= times) early = testing::residentMegabytes();
  }
  const double late = testing::residentMegabytes();
  const bool whole = !rig.finished();
  const Status stopped = rig.stop();
  std::printf(
      "%s: %d of %d times back; %llu gaps, %llu samples lost, %llu dropped; memory %.1f MB at a tenth, %.1f MB at "
      "the end\n",
      name.c_str(), back, times, static_cast<unsigned long long>(last.health.gaps),
      static_cast<unsigned long long>(last.sensors.lostFrames),
      static_cast<unsigned long long>(last.health.droppedBlocks), early, late);
  return stopped && whole && back == times && testing::flat(early, late) ? 0 : 1;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // of the peers, whose wire is let go of while they write
  const auto events = stillcut::app::wireEvents();
  const int times = argc > 1 ? std::atoi(argv[1]) : 100;
  std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  if (names.empty()) names = {"alsa", "serial", "tcp", "iio"};
  int worst = 0;
  for (const std::string& name : names) {
    const int code = stillcut::app::run(name, times);
    if (worst == 0 || (worst == 77 && code != 0)) worst = code;
  }
  return worst;
}
