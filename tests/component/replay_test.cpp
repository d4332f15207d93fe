// Live, replayed and simulated cuts run the same code with the same results (house rule 4): a cut recorded from its
// threads, and one recorded from a deterministic run, are decided again from their files. Every verdict, request,
// command and event must come out with the same bits.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <semaphore>
#include <thread>
#include <vector>

#include "app/compose/recording_rig.h"
#include "app/compose/run_text.h"
#include "core/cnc/simulated_machine.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/session/open_recording.h"
#include "tests/component/same_bits.h"
#include "tests/support/demo_cut.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

// A source that loses a few blocks on the way, as an overflowing ring does.
class LosingSource final : public daq::DaqSource {
 public:
  LosingSource(std::unique_ptr<daq::DaqSource> source, std::uint64_t from, int count)
      : source_(std::move(source)), from_(from), count_(count) {}
  Result<daq::SourceFormat> open() override { return source_->open(); }
  bool read(SampleBlock& block) noexcept override {
    if (!source_->read(block)) return false;
    if (block.sequence != from_) return true;
    std::uint64_t lost = 0;
    for (int i = 0; i < count_; ++i) {
      lost += static_cast<std::uint64_t>(block.frames);
      if (!source_->read(block)) return false;
    }
    block.flags |= kBlockGap;
    block.lostFrames += lost;
    return true;
  }
  void stop() noexcept override { source_->stop(); }
  Message fault() const override { return source_->fault(); }

 private:
  std::unique_ptr<daq::DaqSource> source_;
  std::uint64_t from_;
  int count_;
};

// What the threads of a live run are led by, so that the outcome does not hang on how fast they are: the source is at
// most a few blocks ahead of the worker, and the link has looked at the machine since the last block.
struct Lead {
  std::counting_semaphore<> blocks{4};
  std::atomic<int> looks{0};
};

class LedSource final : public daq::DaqSource {
 public:
  LedSource(std::unique_ptr<daq::DaqSource> source, std::shared_ptr<Lead> lead)
      : source_(std::move(source)), lead_(std::move(lead)) {}
  Result<daq::SourceFormat> open() override { return source_->open(); }
  bool read(SampleBlock& block) noexcept override {
    lead_->blocks.acquire();
    lead_->looks.wait(looks_);
    looks_ = lead_->looks.load();
    return source_->read(block);
  }
  void stop() noexcept override {
    source_->stop();
    lead_->blocks.release();
  }
  Message fault() const override { return source_->fault(); }

 private:
  std::unique_ptr<daq::DaqSource> source_;
  std::shared_ptr<Lead> lead_;
  int looks_ = 0;
};

// The simulated machine, told the stream's time: a cut that runs faster or slower than the clock has its own.
class LedLink final : public cnc::CncLink {
 public:
  LedLink(std::unique_ptr<cnc::CncLink> link, std::shared_ptr<Lead> lead)
      : link_(std::move(link)), lead_(std::move(lead)) {}
  cnc::LinkInfo describe() const override { return link_->describe(); }
  Status open() override { return link_->open(); }
  MachineState read(Instant now) noexcept override {
    const MachineState state = link_->read(now);
    time_ = state.time;
    lead_->looks.fetch_add(1);
    lead_->looks.notify_all();
    return state;
  }
  void apply(const OverrideCommand& command, Instant /*now*/) noexcept override {
    link_->apply(command, command.time());
  }
  void release(Instant /*now*/) noexcept override { link_->release(time_); }

 private:
  std::unique_ptr<cnc::CncLink> link_;
  std::shared_ptr<Lead> lead_;
  Instant time_{};
};

// The demo's simulated machine at another pace, with a limit of our own.
RigSpec demoSpec(const daq::SimulatedPace& pace) {
  const milling::Scenario cut = test::demoCut();
  auto port = std::make_shared<milling::PlantPort>();
  RigSpec spec;
  spec.device = std::make_unique<daq::SimulatedSource>(cut, 0, port, pace);
  spec.link = std::make_unique<cnc::SimulatedMachine>(cut, port);
  spec.setup = cut.cutSetup();
  spec.autoAllowed = true;
  EXPECT_TRUE(spec.params.set(config::kLowestSpeedOverride, 61.3, "test").ok());
  return spec;
}

struct Content {
  std::vector<StepOutput> outputs;
  std::vector<int> inputCounts;
  int sets = 0, alarms = 0, gaps = 0;
};

Content readBack(const std::string& path) {
  Content content;
  auto reader = record::openRecording(path);
  EXPECT_TRUE(reader.ok()) << reader.error().line();
  if (!reader) return content;
  const record::RecordingFormat& format = (*reader)->format();
  SampleBlock block;
  block.allocate(static_cast<int>(format.channels.size()), format.blockFrames);
  while ((*reader)->read(block).value()) {
    const StepRecord* step = (*reader)->recordedStep();
    content.outputs.push_back(step->output);
    content.inputCounts.push_back(step->input.inputCount);
    content.gaps += block.has(kBlockGap) ? 1 : 0;
    content.sets += step->output.hasCommand && step->output.command.kind == CommandKind::Set ? 1 : 0;
    content.alarms += step->output.verdicts[0].alarming() ? 1 : 0;
  }
  return content;
}

void expectSame(const std::vector<StepOutput>& a, const std::vector<StepOutput>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::string differs = test::difference(a[i], b[i]);
    ASSERT_TRUE(differs.empty()) << "step " << i << ": " << differs;
  }
}

// Decides the recorded run again, recording that too, and compares the two files step by step.
void expectReplayTheSame(const std::string& path, const std::string& second) {
  auto replay = buildReplayRig(path);
  ASSERT_TRUE(replay.ok()) << replay.error().line();
  EXPECT_FALSE(replay->rig->hasLink());
  ASSERT_TRUE(replay->rig->recordTo(second, "").ok());
  replay->rig->runToEnd({});
  EXPECT_TRUE(replay->rig->device().fault().empty());
  ASSERT_TRUE(replay->rig->recorder()->finish().ok());
  expectSame(readBack(path).outputs, readBack(second).outputs);
}

TEST(Replay, ACutRunLiveOnItsThreadsIsDecidedTheSameAgain) {
  const record::TempFolder folder;
  const std::string path = folder / "live.h5";
  {
    const auto lead = std::make_shared<Lead>();
    RigSpec spec = demoSpec({.realTime = true, .multiplier = 1e6});
    spec.device = std::make_unique<LedSource>(std::move(spec.device), lead);
    spec.link = std::make_unique<LedLink>(std::move(spec.link), lead);
    spec.watched = true;
    auto rig = Rig::build(std::move(spec));
    ASSERT_TRUE(rig.ok()) << rig.error().line();
    ASSERT_TRUE((*rig)->recordTo(path, "").ok());
    ASSERT_TRUE((*rig)->send({OperatorAction::SetAuthority, Authority::Auto}));
    pipeline::EngineOptions options;
    options.ringBlocks = 1024;  // the whole cut: whatever the scheduler does, nothing is lost
    options.linkPeriod = Seconds(0.001);
    (*rig)->start(options);
    for (std::uint64_t shown = 0; !(*rig)->finished(); std::this_thread::yield()) {
      const Snapshot* picture = (*rig)->read();
      if (picture == nullptr || picture->number == shown) continue;
      lead->blocks.release(static_cast<std::ptrdiff_t>(picture->number - shown));
      shown = picture->number;
    }
    ASSERT_TRUE((*rig)->stop().ok());
    ASSERT_EQ((*rig)->recorder()->status().dropped, 0U);
  }
  const Content live = readBack(path);
  EXPECT_EQ(live.outputs.size(), 500U);
  EXPECT_GT(live.alarms, 0);
  EXPECT_GT(live.sets, 0);
  expectReplayTheSame(path, folder / "again.h5");
}

TEST(Replay, ADeterministicCutWithAGapAndOperatorInputsIsDecidedTheSameAgain) {
  const record::TempFolder folder;
  const std::string path = folder / "run.h5";
  RigSpec spec = demoSpec({});
  spec.device = std::make_unique<LosingSource>(std::move(spec.device), 330, 4);
  auto rig = Rig::build(std::move(spec));
  ASSERT_TRUE(rig.ok()) << rig.error().line();
  ASSERT_TRUE((*rig)->recordTo(path, "name = \"demo\"\n[tool]\nteeth = 4\n").ok());
  ASSERT_TRUE((*rig)->send({OperatorAction::SetAuthority, Authority::Auto}));
  std::vector<StepOutput> seen;
  (*rig)->runToEnd([&](const StepInput&, const StepOutput& output) {
    seen.push_back(output);
    if (seen.size() == 380) (*rig)->send({OperatorAction::Hold});
    if (seen.size() == 420) (*rig)->send({OperatorAction::EndHold});
    if (seen.size() == 450) (*rig)->send({OperatorAction::BackToProgrammed});
  });

  const Content recorded = readBack(path);
  EXPECT_GT(recorded.alarms, 0);
  EXPECT_GT(recorded.sets, 0);
  EXPECT_EQ(recorded.gaps, 1);
  int inputs = 0;
  for (const int n : recorded.inputCounts) inputs += n;
  EXPECT_EQ(inputs, 4);
  // The file says what the run said; the worker's own events (chatter began, ended) come on top of the gate's.
  ASSERT_EQ(recorded.outputs.size(), seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    StepOutput stored = recorded.outputs[i];
    ASSERT_GE(stored.eventCount, seen[i].eventCount);
    stored.eventCount = seen[i].eventCount;
    ASSERT_EQ(test::difference(stored, seen[i]), "") << "step " << i;
  }
  expectReplayTheSame(path, folder / "again.h5");
}

TEST(Replay, TwoDeterministicRunsHaveTheSameBits) {
  std::vector<StepOutput> runs[2];
  for (auto& outputs : runs) {
    auto rig = Rig::build(demoSpec({}));
    ASSERT_TRUE(rig.ok());
    (*rig)->send({OperatorAction::SetAuthority, Authority::Auto});
    (*rig)->runToEnd([&](const StepInput&, const StepOutput& output) { outputs.push_back(output); });
  }
  EXPECT_EQ(runs[0].size(), 500U);
  expectSame(runs[0], runs[1]);
}

TEST(Replay, TheComparisonSeesOneBit) {
  StepOutput a, b;
  a.verdictCount = b.verdictCount = 1;
  EXPECT_EQ(test::difference(a, b), "");
  b.verdicts[0].frequency = Hertz(-0.0);
  EXPECT_EQ(test::difference(a, b), "verdict 0");
  b = a;
  b.hasCommand = a.hasCommand = true;
  b.command.speed = Ratio(std::nextafter(1.0, 2.0));
  EXPECT_EQ(test::difference(a, b), "command");
}

TEST(RunText, SaysHowARunWasWiredAndIsReadBack) {
  RunText run;
  run.methods = {{"energy-ratio"}, "", "extremum-seek"};
  run.autoAllowed = true;
  ASSERT_TRUE(run.params.set(config::kLowestSpeedOverride, 100.0 / 3.0, "test").ok());
  const auto back = parseRunText(runText(run, "name = \"demo\"\n[[sensor]]\n"), "text");
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(back->methods.detectors, run.methods.detectors);
  EXPECT_EQ(back->methods.fallback, "");
  EXPECT_EQ(back->methods.strategy, "extremum-seek");
  EXPECT_TRUE(back->autoAllowed);
  EXPECT_EQ(back->params.values(), run.params.values());
}

TEST(RunText, WhatIsMissingOrUnknownIsNamed) {
  const auto empty = parseRunText("", "cut.h5 (configuration)");
  ASSERT_FALSE(empty.ok());
  EXPECT_NE(empty.error().line().find("cut.h5"), std::string::npos) << empty.error().line();
  const auto unknown = parseRunText(
      "[methods]\ndetectors = \"energy-ratio\"\nstrategy = \"monitor\"\nallow_auto = false\n[parameters.gate]\nlese = "
      "1\n",
      "cut.h5");
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().line().find("lese"), std::string::npos) << unknown.error().line();
}

}  // namespace
}  // namespace stillcut::app
