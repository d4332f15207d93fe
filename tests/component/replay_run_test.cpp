// A replay led by hand: the same bits at every pace, paused and stepped, looped, gone to a place, and across gaps.
#include "app/compose/replay_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <semaphore>
#include <thread>

#include "app/compose/recording_rig.h"
#include "core/cnc/simulated_machine.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/detect/registry.h"
#include "core/formats/sound/wav_reader.h"
#include "core/session/convert_recording.h"
#include "tests/component/same_bits.h"
#include "tests/support/demo_cut.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

// The demo's cut, recorded; after block 300 the samples of two blocks are missing.
std::string recorded(const record::TempFolder& folder) {
  std::string path = folder / "cut.h5";
  class Losing final : public daq::DaqSource {
   public:
    explicit Losing(std::unique_ptr<daq::DaqSource> source) : source_(std::move(source)) {}
    Result<daq::SourceFormat> open() override { return source_->open(); }
    bool read(SampleBlock& block) noexcept override {
      if (!source_->read(block)) return false;
      if (block.sequence != 300) return true;
      const auto lost = static_cast<std::uint64_t>(2 * block.frames);
      if (!source_->read(block) || !source_->read(block)) return false;
      block.flags |= kBlockGap;
      block.lostFrames += lost;
      return true;
    }
    void stop() noexcept override { source_->stop(); }
    Message fault() const override { return {}; }

   private:
    std::unique_ptr<daq::DaqSource> source_;
  };
  const milling::Scenario cut = test::demoCut();
  auto port = std::make_shared<milling::PlantPort>();
  RigSpec spec;
  spec.device = std::make_unique<Losing>(std::make_unique<daq::SimulatedSource>(cut, 0, port, daq::SimulatedPace{}));
  spec.link = std::make_unique<cnc::SimulatedMachine>(cut, port);
  spec.setup = cut.cutSetup();
  spec.autoAllowed = true;
  auto rig = Rig::build(std::move(spec));
  EXPECT_TRUE(rig.ok());
  EXPECT_TRUE((*rig)->recordTo(path, "").ok());
  (*rig)->send({OperatorAction::SetAuthority, Authority::Auto});
  (*rig)->runToEnd({});
  EXPECT_TRUE((*rig)->recorder()->finish().ok());
  return path;
}

// Always far enough ahead: no test waits for the time.
class HurryingClock final : public Clock {
 public:
  Instant now() const noexcept override {
    return instantFromNs(3'600'000'000'000 * reads_.fetch_add(1, std::memory_order_relaxed));
  }

 private:
  mutable std::atomic<std::int64_t> reads_{0};
};

struct Seen {
  std::vector<StepOutput> outputs;
  std::vector<Instant> begins;
  std::vector<std::uint64_t> sequences;
  std::vector<bool> gaps;
};

// A run of `path` whose steps are counted by a semaphore. A session is decided again; on anything else all detectors
// run.
class Led {
 public:
  explicit Led(const std::string& path) : control(std::make_shared<daq::ReplayControl>()) {
    auto built = path.ends_with(".h5") ? buildReplayRig(path, {control, &clock_}) : [&] {
      RecordingOptions options;
      options.teeth = 4;
      options.methods.detectors.clear();
      for (const auto& row : detect::detectorTable()) options.methods.detectors.emplace_back(row.id);
      options.hand = {control, &clock_};
      return buildRecordingRig(path, options);
    }();
    EXPECT_TRUE(built.ok()) << built.error().line();
    run = std::make_unique<ReplayRun>(std::move(built->rig), control);
  }
  void start() {
    run->start([this](const StepInput& in, const StepOutput& out) {
      seen.outputs.push_back(out);
      seen.begins.push_back(in.block.firstSample);
      seen.sequences.push_back(in.block.sequence);
      seen.gaps.push_back(in.block.has(kBlockGap));
      steps.release();
    });
  }
  void await(int count) {
    for (int i = 0; i < count; ++i) steps.acquire();
  }
  void awaitEnd() {
    while (!run->finished()) std::this_thread::yield();
    run->stop();
    EXPECT_TRUE(run->fault().empty());
  }

  std::shared_ptr<daq::ReplayControl> control;
  std::counting_semaphore<> steps{0};
  Seen seen;

 private:
  HurryingClock clock_;

 public:
  std::unique_ptr<ReplayRun> run;  // last: stopped before what it uses goes
};

void expectSame(const Seen& a, const Seen& b, std::size_t count) {
  ASSERT_GE(a.outputs.size(), count);
  ASSERT_GE(b.outputs.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(test::difference(a.outputs[i], b.outputs[i]), "") << "step " << i;
    ASSERT_EQ(a.begins[i], b.begins[i]);
  }
}

TEST(ReplayRun, EveryPaceGivesTheSameBits) {
  const record::TempFolder folder;
  const std::string path = recorded(folder);
  Led fast(path);
  fast.start();
  fast.awaitEnd();
  ASSERT_EQ(fast.seen.outputs.size(), 498U);
  EXPECT_EQ(std::count(fast.seen.gaps.begin(), fast.seen.gaps.end(), true), 1) << "the gap of the cut";
  int alarms = 0;
  for (const StepOutput& o : fast.seen.outputs) alarms += o.verdicts[0].alarming() ? 1 : 0;
  EXPECT_GT(alarms, 0);
  for (const double pace : {0.1, 1.0, 37.5, 1000.0}) {
    Led paced(path);
    paced.control->setPace(pace);
    EXPECT_EQ(paced.control->pace(), pace);
    paced.start();
    paced.awaitEnd();
    ASSERT_EQ(paced.seen.outputs.size(), fast.seen.outputs.size()) << pace;
    expectSame(paced.seen, fast.seen, fast.seen.outputs.size());
    EXPECT_NEAR(paced.control->position().value, 5.0, 0.02);
  }
}

// Sound, a table and a cut that is simulated while it is replayed: every detector says the same at every pace, paused
// and stepped.
TEST(ReplayRun, SoundTablesAndScenariosGiveTheSameBitsAtEveryPace) {
  const record::TempFolder folder;
  ASSERT_TRUE(milling::saveScenario(test::demoCut(3.0), folder / "cut.toml").ok());
  ASSERT_TRUE(record::convertRecording(recorded(folder), folder / "cut.wav", {}, {Seconds(1.0), Seconds(4.0)}).ok());
  ASSERT_TRUE(record::convertRecording(folder / "cut.h5", folder / "cut.csv", {}, {Seconds(1.0), Seconds(2.0)}).ok());
  for (const char* name : {"cut.wav", "cut.csv", "cut.toml"}) {
    Led fast(folder / name);
    fast.start();
    fast.awaitEnd();
    ASSERT_GT(fast.seen.outputs.size(), 150U) << name;
    for (const double pace : {0.1, 1.0, 1000.0}) {
      Led paced(folder / name);
      paced.control->setPace(pace);
      paced.control->pause();
      paced.start();
      paced.control->step(10);
      paced.await(10);
      paced.control->resume();
      paced.awaitEnd();
      ASSERT_EQ(paced.seen.outputs.size(), fast.seen.outputs.size()) << name << " " << pace;
      expectSame(paced.seen, fast.seen, fast.seen.outputs.size());
    }
  }
}

TEST(ReplayRun, PausedItGivesOneBlockForEachStepAndTheSameBits) {
  const record::TempFolder folder;
  const std::string path = recorded(folder);
  Led fast(path);
  fast.start();
  fast.awaitEnd();
  Led led(path);
  led.control->pause();
  led.start();
  for (int i = 0; i < 40; ++i) {
    led.control->step();
    led.await(1);
    EXPECT_FALSE(led.steps.try_acquire()) << "one step, one block";
  }
  led.control->step(10);
  led.await(10);
  EXPECT_NEAR(led.control->position().value, 0.5, 1e-6);
  EXPECT_NE(led.run->read(), nullptr) << "the screen sees it";
  led.control->setPace(100.0);
  led.control->resume();
  led.awaitEnd();
  expectSame(led.seen, fast.seen, fast.seen.outputs.size());
}

TEST(ReplayRun, ALoopGoesOnInTimeWithAGapWhereItBeginsAgain) {
  const record::TempFolder folder;
  const std::string path = recorded(folder);
  Led led(path);
  led.control->loopBetween(Seconds(1.0), Seconds(1.5));
  led.start();
  led.await(400);
  led.run->stop();
  const Seen& seen = led.seen;
  int rounds = 0;
  for (std::size_t i = 1; i < 400; ++i) {
    ASSERT_GT(seen.begins[i], seen.begins[i - 1]) << i;
    ASSERT_EQ(seen.sequences[i], seen.sequences[i - 1] + 1) << i;
    if (seen.gaps[i]) ++rounds;
    if (i > 150) {
      EXPECT_EQ(seen.gaps[i], (i - 150) % 50 == 0) << i;
    }
  }
  EXPECT_EQ(rounds, 5);
  EXPECT_LE(led.control->position().value, 1.5 + 0.01);
  EXPECT_GT(led.control->position().value, 1.0);
}

TEST(ReplayRun, GoesToAnyPlaceAlsoBackAlsoInAnImport) {
  const record::TempFolder folder;
  const std::string path = recorded(folder);
  Led led(path);
  led.control->pause();
  led.control->goTo(Seconds(4.0));
  led.start();
  led.control->step();
  led.await(1);
  EXPECT_NEAR(led.control->position().value, 4.01, 1e-3);
  led.control->goTo(Seconds(0.5));
  led.control->step();
  led.await(1);
  EXPECT_NEAR(led.control->position().value, 0.51, 1e-3);
  led.run->stop();

  // A sound file: read again from its beginning to go back.
  SampleBlock block;
  block.allocate(1, 8000);
  block.frames = 8000;
  auto wav = record::WavWriter::create(folder / "cut.wav", 1, Hertz(8000.0));
  ASSERT_TRUE(wav.ok());
  for (int s = 0; s < 3; ++s) ASSERT_TRUE((*wav)->write(block).ok());
  ASSERT_TRUE((*wav)->finish().ok());
  const SteadyClock clock;
  RecordingOptions options;
  options.hand = {std::make_shared<daq::ReplayControl>(), &clock};
  options.hand.control->pause();
  auto built = buildRecordingRig(folder / "cut.wav", options);
  ASSERT_TRUE(built.ok()) << built.error().line();
  ReplayRun run(std::move(built->rig), options.hand.control);
  std::counting_semaphore<> steps{0};
  run.start([&](const StepInput&, const StepOutput&) { steps.release(); });
  for (const double place : {2.0, 0.25, 1.0}) {
    run.control().goTo(Seconds(place));
    run.control().step();
    steps.acquire();
    EXPECT_NEAR(run.control().position().value, place + 0.005, 1e-6);
  }
  run.stop();
  EXPECT_TRUE(run.fault().empty());
}

TEST(ReplayControl, KeepsThePaceInsideItsRange) {
  daq::ReplayControl control;
  for (const auto& [wanted, given] : std::vector<std::pair<double, double>>{
           {0.0, 0.0}, {-3.0, 0.0}, {std::nan(""), 0.0}, {0.01, 0.1}, {7.0, 7.0}, {1e9, 1000.0}}) {
    control.setPace(wanted);
    EXPECT_EQ(control.pace(), given);
  }
}

}  // namespace
}  // namespace stillcut::app
