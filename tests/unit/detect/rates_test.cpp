// Every detector at every rate from 1 to 102.4 kHz, on one, two and eight channels, through a change of speed: it
// prepares, runs, allocates nothing, and says nothing that is not finite.
#include "core/detect/registry.h"
#include "tests/support/path_counter.h"
#include "tests/support/signals.h"

namespace stillcut::detect::testing {
namespace {

struct RateCase {
  double rate;
  int channels;
};
inline void PrintTo(const RateCase& c, std::ostream* out) {  // NOLINT(readability-identifier-naming)
  *out << c.rate << " Hz, " << c.channels << " channels";
}

class Rates : public ::testing::TestWithParam<RateCase> {};

TEST_P(Rates, EveryDetectorRunsThroughASpeedChangeWithoutAllocating) {
  CutSignal s;
  s.rate = GetParam().rate;
  s.spindle = 30.0;
  s.teeth = 3;
  s.harmonics = std::min(32, static_cast<int>(0.45 * s.rate / s.spindle));
  s.seconds = 1.5;
  s.chatterHertz = 215.0;
  s.growthStart = 1.0;
  const Recording recording = makeCut(s);
  RunOptions options;
  options.teeth = s.teeth;
  options.rpm = 60.0 * s.spindle;
  options.blockFrames = std::max(10, static_cast<int>(s.rate / 100.0));
  CutSetup setup = setupFor(recording, options);
  setup.channels.resize(static_cast<std::size_t>(GetParam().channels), setup.channels.front());
  for (const DetectorRow& row : detectorTable()) {
    Conditioner conditioner;
    conditioner.prepare(setup, {});
    const auto detector = std::move(makeDetector(row.id).value());
    detector->prepare(setup, {});
    SampleBlock block;
    block.allocate(GetParam().channels, options.blockFrames);
    block.rate = setup.rate;
    block.frames = options.blockFrames;
    MachineState machine;
    machine.valid = machine.linkUp = true;
    bool finite = true;
    bool valid = false;
    const stillcut::test::PathCounter counter;
    for (std::size_t from = 0; from + static_cast<std::size_t>(block.frames) <= recording.frames();
         from += static_cast<std::size_t>(block.frames)) {
      for (int c = 0; c < GetParam().channels; ++c) {
        std::copy_n(recording.channels[0].begin() + static_cast<std::ptrdiff_t>(from), block.frames,
                    block.channel(c).begin());
      }
      const double t = static_cast<double>(from) / s.rate;
      // A ramp, then leaps: half of it, half as much again, nothing.
      const double leap = t < 1.36 ? 1.1 : t < 1.4 ? 0.5 : t < 1.44 ? 1.5 : t < 1.47 ? 0.0 : 1.0;
      machine.actualSpeed = Rpm(options.rpm * (t < 1.2 ? 1.0 : std::min(1.0 + 0.5 * (t - 1.2), leap)));
      block.firstSample = Instant{} + toDuration(Seconds(t));
      const Verdict v = detector->process(conditioner.process(block, machine));
      ++block.sequence;
      for (const double value : v.indicators) finite = finite && std::isfinite(value);
      finite = finite && isFinite(v.severity) && isFinite(v.frequency) && isFinite(v.frequencySd);
      valid = valid || v.valid;
    }
    if (stillcut::test::PathCounter::works()) {
      EXPECT_TRUE(counter.counts().none()) << row.id;
    }
    EXPECT_TRUE(finite) << row.id;
    EXPECT_EQ(valid, row.id != "coherence" || GetParam().channels > 1) << row.id;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Rates,
                         ::testing::Values(RateCase{1000.0, 1}, RateCase{1000.0, 2}, RateCase{1000.0, 8},
                                           RateCase{8000.0, 1}, RateCase{8000.0, 2}, RateCase{25600.0, 2},
                                           RateCase{25600.0, 8}, RateCase{102400.0, 1}, RateCase{102400.0, 2}));

}  // namespace
}  // namespace stillcut::detect::testing
