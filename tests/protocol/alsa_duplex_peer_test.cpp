// The audio-class device of the active work-holder on ALSA's own streams: a PulseAudio null sink, whose output is heard
// at its input, stands in for an interface whose amplifier drives what its sensor hears. Waits are in real time, and
// each is bounded.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/io/alsa_duplex.h"
#include "core/active/active_engine.h"
#include "core/active/pcm_duplex.h"
#include "core/rt/wakeup.h"
#include "tests/support/null_sink.h"

namespace stillcut::active {
namespace {

constexpr int kRate = 4000;
constexpr int kFrames = 800;
// The server then moves one period at a time, as a converter does; left alone it moves two seconds at a time.
constexpr const char* kOnePeriodMs = "200";

// What goes over the driver's boundary, kept; a block is lost when the test wants it.
struct Wire {
  std::vector<std::int32_t> read, written;  // first channel, since the last opening
  std::atomic<bool> lose{false};
  std::atomic<std::int32_t> largest{0};
};

class Watched final : public PcmDuplexDriver {
 public:
  Watched(std::unique_ptr<PcmDuplexDriver> driver, Wire& wire) : driver_(std::move(driver)), wire_(wire) {}
  Result<PcmDuplexFormat> open(const PcmDuplexRequest& request) override {
    wire_.read.clear();
    wire_.written.clear();
    auto opened = driver_->open(request);
    if (opened) format_ = *opened;
    return opened;
  }
  int read(std::int32_t* into) noexcept override {
    if (wire_.lose.exchange(false)) return kDuplexLost;
    const int said = driver_->read(into);
    if (said != 0) return said;
    for (int f = 0; f < format_.frames; ++f) {
      wire_.read.push_back(into[f * format_.inputs]);
      // A converter's input is never digitally still.
      for (int c = 0; c < format_.inputs; ++c) into[f * format_.inputs + c] ^= f & 1;
    }
    return said;
  }
  int write(const std::int32_t* from) noexcept override {
    std::int32_t largest = 0;
    for (int f = 0; f < format_.frames; ++f) {
      wire_.written.push_back(from[f * format_.outputs]);
      for (int c = 0; c < format_.outputs; ++c) largest = std::max(largest, std::abs(from[f * format_.outputs + c]));
    }
    wire_.largest = largest;
    return driver_->write(from);
  }
  bool restart() noexcept override { return driver_->restart(); }
  void close() noexcept override { driver_->close(); }

 private:
  std::unique_ptr<PcmDuplexDriver> driver_;
  Wire& wire_;
  PcmDuplexFormat format_;
};

class AlsaDuplex : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string missing = sink_.start(kRate, 2, "front-left,front-right");
    if (!missing.empty()) GTEST_SKIP() << missing;
    PcmDuplexSettings settings;
    ::setenv("PULSE_LATENCY_MSEC", kOnePeriodMs, 1);
    settings.request = {"looped", Hertz(kRate), kFrames, 2, 2};
    settings.sensor = {100.0, 100.0};
    settings.stroke = {3e-6, 3e-6};
    ActiveEngineOptions options;
    options.record.duration = Seconds(4.0);
    options.path.mostDelay = kMostDelay - 2;
    for (safety::ActuatorLimits& l : options.limits) {
      l.amplitude = 3e-6;
      l.slew = 1.0;
    }
    engine_ = std::make_unique<ActiveEngine>(
        std::make_unique<PcmDuplex>(settings, std::make_unique<Watched>(app::makeAlsaDuplexDriver(), wire_)), options,
        clock_);
  }
  template <class Done>
  bool within(double seconds, Done done) {
    const Instant end = clock_.now() + toDuration(Seconds(seconds));
    rt::Wakeup never;  // only its time-out is used
    while (!done() && clock_.now() < end) {
      engine_->renew();
      never.waitFor(Seconds(0.005));
    }
    return done();
  }
  // On a busy computer a period may really be lost: then the record is made again.
  bool identified() {
    for (int attempt = 0; attempt < 5; ++attempt) {
      const Status opened = engine_->open();
      EXPECT_TRUE(opened.ok()) << opened.error().line();
      if (!opened || !engine_->identify()) return false;
      if (!within(25.0, [&] { return engine_->recorded(); })) continue;
      found_ = engine_->fit();
      if (found_->ok()) return true;
      std::printf("%s\n", found_->error().line().c_str());
    }
    return false;
  }

  testing::NullSink sink_;
  SteadyClock clock_;
  Wire wire_;
  std::unique_ptr<ActiveEngine> engine_;
  std::optional<Result<PathPairFound>> found_;
};

// After how many frames the input is the output, bit by bit; 0: never.
std::size_t delayOf(const Wire& wire) {
  const auto loud = [](std::int32_t v) { return std::abs(v) > 1 << 24; };
  const auto first = std::ranges::find_if(wire.written, loud);
  if (first == wire.written.end()) return 0;
  const auto at = static_cast<std::size_t>(first - wire.written.begin());
  for (std::size_t late = 1; at + late + 1000 < wire.read.size(); ++late) {
    if (std::equal(first, first + 1000, wire.read.begin() + static_cast<std::ptrdiff_t>(at + late))) return late;
  }
  return 0;
}

TEST_F(AlsaDuplex, StreamsBothWaysAndMeasuresItsOwnDelay) {
  ASSERT_TRUE(identified());
  const Status taken = engine_->install(**found_);
  ASSERT_TRUE(taken.ok()) << taken.error().line();
  const std::array<ActivePath, kActiveAxes> paths = engine_->paths();
  engine_->close();  // the wire belongs to this thread now
  const std::size_t late = delayOf(wire_);
  ASSERT_GT(late, 0U);
  std::printf("the input is the output %zu frames before: %.1f ms\n", late, 1e3 * static_cast<double>(late) / kRate);
  EXPECT_GE(late, static_cast<std::size_t>(kFrames));  // what is written after a block is not in that block
  for (std::size_t a = 0; a < kActiveAxes; ++a) {
    EXPECT_NEAR(paths[a].delay.value * kRate, static_cast<double>(late), 0.5) << a;
    // Full scale out is full scale in; what is heard is taken off.
    const std::complex<double> response = (**found_)[a].model.response(Hertz(100.0), Hertz(kRate));
    EXPECT_NEAR(std::abs(response), 100.0 / 3e-6, 0.1 * 100.0 / 3e-6) << a;
    EXPECT_LT(paths[a].residual, 0.1) << a;
  }
}

TEST_F(AlsaDuplex, ALostBlockIsZeroOutputAndCountedAndTheStreamGoesOn) {
  ASSERT_TRUE(identified());
  ASSERT_TRUE(engine_->identify().ok());
  ASSERT_TRUE(within(5.0, [&] { return wire_.largest.load() > 1 << 20; }));
  const ActiveSnapshot* told = engine_->pull();
  ASSERT_NE(told, nullptr);
  const std::uint64_t before = told->underruns;
  wire_.lose = true;
  ASSERT_TRUE(within(5.0, [&] {
    told = engine_->pull();
    return told->underruns > before && wire_.largest.load() == 0;
  }));
  EXPECT_EQ(told->axes[0].state, ActuatorState::Off);
  ASSERT_TRUE(within(5.0, [&] { return engine_->recorded(); }));
  const auto lost = engine_->fit();
  ASSERT_FALSE(lost.ok());
  EXPECT_NE(lost.error().line().find("lost a block"), std::string::npos) << lost.error().line();
  const std::uint64_t blocks = told->blocks;
  EXPECT_TRUE(within(5.0, [&] { return engine_->pull()->blocks > blocks + 10; }));
  EXPECT_EQ(wire_.largest.load(), 0);
}

}  // namespace
}  // namespace stillcut::active
