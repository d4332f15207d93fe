// soak_alsa [SECONDS]: SECONDS (3600 unless told) of 2 channels at 25.6 kHz through ALSA's pulse plugin and the whole
// pipeline on its threads. What is played is a noise whose every sample follows from the one before, so that each frame
// that is lost, doubled, altered or on the wrong channel shows, across a silence too, which is only the player's where
// that says that it was late. Exit code 0: every sample of the run arrived, in order, no gap, nothing dropped, and
// memory flat after the first tenth (5 % or 8 MB, the larger); 77: no PulseAudio here.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/rt/wakeup.h"
#include "tests/soak/heard_device.h"
#include "tests/soak/resident.h"
#include "tests/support/null_sink.h"

namespace stillcut::app {
namespace {

constexpr int kRate = 25600;
constexpr int kChannels = 2;
constexpr double kClocks = 5e-4;
constexpr double kAhead = 8.0;  // s: so that a silence or a gap is never the player's
// A full-period congruence of 22 bits: a quarter of full scale, and never twice the same within 164 s.
constexpr std::int32_t kPeriod = 1 << 22;
constexpr std::int32_t kMiddle = kPeriod / 2;

std::int32_t after(std::int32_t value) {
  const auto state = static_cast<std::uint32_t>(value + kMiddle);
  return static_cast<std::int32_t>((state * 1664525U + 1013904223U) % kPeriod) - kMiddle;
}

// What the other channel carries at the same time: the same numbers in an order of their own.
std::int32_t beside(std::int32_t value) {
  const auto state = static_cast<std::uint32_t>(value + kMiddle);
  return static_cast<std::int32_t>((state * 2891336453U + 12345U) % kPeriod) - kMiddle;
}

// The device, and whether each of its frames is the one that has to follow.
class Follows final : public daq::DaqSource {
 public:
  explicit Follows(std::unique_ptr<daq::DaqSource> device) : device_(std::move(device)) {}
  Result<daq::SourceFormat> open() override {
    const testing::OnTime transport;  // the thread of ALSA's plugin is what interrupts are in a device's driver
    return device_->open();
  }
  bool read(SampleBlock& block) noexcept override {
    if (!device_->read(block)) return false;
    told(block);
    for (std::size_t f = 0; f < static_cast<std::size_t>(block.frames); ++f) {
      check(static_cast<std::int32_t>(block.channel(0)[f] * 8388608.0F),
            static_cast<std::int32_t>(block.channel(1)[f] * 8388608.0F));
    }
    return true;
  }
  void stop() noexcept override { device_->stop(); }
  Message fault() const override { return device_->fault(); }
  bool live() const override { return true; }

  // Read once the run is over.
  long followed = 0, silent = 0, broken = 0, swapped = 0;

 private:
  // A gap as it comes: what the block says of it, and what the samples do.
  void told(const SampleBlock& block) noexcept {
    if (blocks_++ == 0) begin_ = block.firstSample;
    const double at = secondsBetween(begin_, block.firstSample).value;
    if (block.has(kBlockGap)) {
      std::printf("gap at %.3f s: %llu frames told, %.3f s after the last block's end; %ld not in order, %ld silent\n",
                  at, static_cast<unsigned long long>(block.lostFrames), secondsBetween(end_, block.firstSample).value,
                  broken, silent);
      std::fflush(stdout);
    }
    end_ = block.end();
  }
  void check(std::int32_t left, std::int32_t right) noexcept {
    if (left == 0 && right == 0) {
      if (any_) ++silent;  // the player was late, and then goes on where it was
      return;
    }
    if (right != beside(left)) ++swapped;
    if (any_) ++(left == after(last_) ? followed : broken);
    last_ = left;
    any_ = true;
  }
  std::unique_ptr<daq::DaqSource> device_;
  std::int32_t last_ = 0;
  bool any_ = false;
  long blocks_ = 0;
  Instant begin_{}, end_{};
};

int run(double seconds) {
  testing::NullSink sink;
  if (const std::string missing = sink.start(kRate, kChannels); !missing.empty()) {
    return std::fprintf(stderr, "%s\n", missing.c_str()), 77;
  }
  const auto clock = std::make_shared<SteadyClock>();
  auto device = heardDevice(kRate, *clock);
  if (!device) return std::fprintf(stderr, "%s\n", device.error().line().c_str()), 2;
  auto follows = std::make_unique<Follows>(std::move(device).value());
  const Follows& heard = *follows;
  auto built = rigOn(std::move(follows), clock);
  if (!built) return std::fprintf(stderr, "%s\n", built.error().line().c_str()), 2;
  std::int32_t next = 1;
  const testing::NullSinkPlayer player(
      kRate, kChannels,
      [&next](std::span<std::int32_t> out) {
        for (std::size_t i = 0; i < out.size(); i += kChannels, next = after(next)) {
          out[i] = next * 256;
          out[i + 1] = beside(next) * 256;
        }
      },
      kAhead);
  Rig& rig = **built;
  rig.start({});
  rt::Wakeup never;  // only its time-out is used
  Snapshot last;
  double early = 0.0;
  const Instant begin = clock->now();
  while (secondsBetween(begin, clock->now()).value < seconds && !rig.finished()) {
    never.waitFor(Seconds(0.1));
    if (const Snapshot* s = rig.read()) last = *s;
    if (early == 0.0 && secondsBetween(begin, clock->now()).value > seconds / 10.0)
      early = testing::residentMegabytes();
  }
  const double late = testing::residentMegabytes();
  const bool whole = !rig.finished();
  const Status stopped = rig.stop();
  std::printf("%ld frames in order, %ld not, %ld on the wrong channel, %ld silent (%d underruns of the player)\n",
              heard.followed, heard.broken, heard.swapped, heard.silent, player.underruns());
  std::printf(
      "%llu blocks, %llu dropped, %llu gaps, %llu lost frames, %llu overruns; %.3f Hz (sd %.3f)\n",
      static_cast<unsigned long long>(last.health.blocks), static_cast<unsigned long long>(last.health.droppedBlocks),
      static_cast<unsigned long long>(last.health.gaps), static_cast<unsigned long long>(last.sensors.lostFrames),
      static_cast<unsigned long long>(last.health.overruns), last.sensors.actualRate.value,
      last.sensors.actualRateSd.value);
  std::printf("worst block %.2f ms of %.2f; sensors: %s; memory %.1f MB at a tenth, %.1f MB at the end\n",
              last.health.worstProcessing.value * 1e3, last.health.blockLength.value * 1e3,
              last.sensors.fault.code == ReasonCode::None ? "sound" : sentence(last.sensors.fault).c_str(), early,
              late);
  // All of the run but its begin and end, within what the player's and this computer's clock may differ by.
  const auto arrived = static_cast<double>(heard.followed + heard.silent);
  const bool all = arrived > (1.0 - kClocks) * seconds * kRate - 4.0 * kRate;
  const bool played = heard.silent == 0 || player.underruns() > 0;
  const bool sound =
      played && heard.broken == 0 && heard.swapped == 0 && last.health.droppedBlocks == 0 && last.health.gaps == 0;
  return stopped && whole && all && sound && testing::flat(early, late) ? 0 : 1;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  return stillcut::app::run(argc > 1 ? std::atof(argv[1]) : 3600.0);
}
