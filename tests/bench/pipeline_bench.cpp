// What one block costs in every hop of its way. `real_time_ratio`: how many seconds of cut that hop gets through in a
// second; 100 means that it needs a hundredth of the block's own length.

#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <string>

#include "core/cnc/simulated_machine.h"
#include "core/control/registry.h"
#include "core/daq/simulated/simulated_source.h"
#include "core/detect/registry.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/snapshot_publisher.h"
#include "core/pipeline/step_loop.h"
#include "core/sensing/conditioner.h"
#include "core/session/recorder.h"
#include "tests/bench/recorded_demo.h"
#include "tests/support/temp_folder.h"

namespace stillcut::bench {
namespace {

void countBlocks(benchmark::State& state, std::int64_t blocks) {
  state.SetItemsProcessed(blocks);
  state.counters["real_time_ratio"] =
      benchmark::Counter(static_cast<double>(blocks) * recordedDemo().blockSeconds(), benchmark::Counter::kIsRate);
}

// Calls `each` with the number of every block, over and over; `again` starts the cut anew, outside the measurement.
template <class Each, class Again>
void overTheCut(benchmark::State& state, const Each& each, const Again& again) {
  const std::size_t count = recordedDemo().inputs.size();
  again();
  std::size_t i = 0;
  for (auto _ : state) {
    each(i);
    if (++i < count) continue;
    state.PauseTiming();
    again();
    i = 0;
    state.ResumeTiming();
  }
  countBlocks(state, state.iterations());
}

void simulatedSource(benchmark::State& state) {
  const RecordedDemo& demo = recordedDemo();
  std::unique_ptr<daq::SimulatedSource> source;
  SampleBlock block;
  block.allocate(static_cast<int>(demo.setup.channels.size()), demo.setup.blockFrames);
  overTheCut(
      state, [&](std::size_t) { benchmark::DoNotOptimize(source->read(block)); },
      [&] {
        source = std::make_unique<daq::SimulatedSource>(demo.scenario, 0, nullptr);
        (void)source->open();
      });
}

void conditioner(benchmark::State& state) {
  const RecordedDemo& demo = recordedDemo();
  detect::Conditioner conditioner;
  conditioner.prepare(demo.setup, {});
  overTheCut(
      state,
      [&](std::size_t i) {
        benchmark::DoNotOptimize(conditioner.process(demo.inputs[i].block, demo.inputs[i].machine));
      },
      [&] { conditioner.reset(); });
}

void detector(benchmark::State& state, const std::string& id) {
  const RecordedDemo& demo = recordedDemo();
  const auto detector = detect::makeDetector(id).value();
  detector->prepare(demo.setup, {});
  overTheCut(
      state, [&](std::size_t i) { benchmark::DoNotOptimize(detector->process(demo.conditioned[i].block)); },
      [&] { detector->reset(); });
}

void strategy(benchmark::State& state, const std::string& id) {
  const RecordedDemo& demo = recordedDemo();
  const auto strategy = control::makeStrategy(id).value();
  strategy->prepare(demo.setup, {});
  overTheCut(
      state,
      [&](std::size_t i) {
        const StepOutput& out = demo.steps[i].output;
        const control::StrategyInput in{demo.inputs[i].block.end(), Seconds(demo.blockSeconds()),
                                        out.verdicts[static_cast<std::size_t>(out.inCharge)], demo.inputs[i].machine};
        benchmark::DoNotOptimize(strategy->decide(in));
      },
      [&] { strategy->reset(); });
}

void gate(benchmark::State& state) {
  const RecordedDemo& demo = recordedDemo();
  safety::OverrideGate gate;
  overTheCut(
      state,
      [&](std::size_t i) {
        const StepInput& in = demo.inputs[i];
        const StepOutput& out = demo.steps[i].output;
        const std::span<const OperatorInput> inputs(in.inputs.data(), static_cast<std::size_t>(in.inputCount));
        benchmark::DoNotOptimize(gate.step({.now = in.block.end(),
                                            .dt = Seconds(demo.blockSeconds()),
                                            .request = out.request,
                                            .verdict = out.verdicts[static_cast<std::size_t>(out.inCharge)],
                                            .machine = in.machine,
                                            .inputs = inputs}));
      },
      [&] { gate.prepare(demo.limits); });
}

void spectrumTap(benchmark::State& state) {
  const RecordedDemo& demo = recordedDemo();
  pipeline::SpectrumTap tap;
  overTheCut(
      state, [&](std::size_t i) { tap.feed(demo.inputs[i].block, demo.steps[i].output.verdicts[0]); },
      [&] { tap.prepare(demo.setup); });
}

void publisherWithSpectrum(benchmark::State& state) {
  const RecordedDemo& demo = recordedDemo();
  pipeline::SnapshotPublisher publisher;
  const pipeline::InterventionLog log;
  const PathHealth health;
  overTheCut(
      state,
      [&](std::size_t i) { publisher.publish(demo.inputs[i], demo.steps[i].output, demo.steps[i], log, health); },
      [&] { publisher.prepare(demo.setup, true, true); });
}

// In batches that the recorder's ring can take; writing them is the recorder thread's affair and not measured.
void recorderPush(benchmark::State& state) {
  constexpr std::size_t kBatch = 100;
  const RecordedDemo& demo = recordedDemo();
  const record::TempFolder folder;
  const auto recorder = record::Recorder::create(folder / "bench.h5", {demo.setup, "", "bench", true}).value();
  for (auto _ : state) {
    const auto began = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < kBatch; ++i) {
      benchmark::DoNotOptimize(recorder->push(demo.inputs[i], demo.steps[i].output));
    }
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    recorder->drain();
  }
  state.SetLabel("100 blocks");
  countBlocks(state, state.iterations() * static_cast<std::int64_t>(kBatch));
}

void linkTick(benchmark::State& state) {
  const RecordedDemo& demo = recordedDemo();
  auto port = std::make_shared<milling::PlantPort>();
  cnc::SimulatedMachine machine(demo.scenario, port);
  milling::SimulatedCut plant(demo.scenario);
  port->publish(plant);
  rt::Mailbox<OverrideCommand> commands;
  rt::Mailbox<MachineState> states;
  std::unique_ptr<pipeline::LinkRunner> link;
  overTheCut(
      state,
      [&](std::size_t i) {
        const auto& command = demo.steps[i].gate.command;
        if (command) commands.post(*command);
        link->tick(demo.inputs[i].block.end());
      },
      [&] { link = std::make_unique<pipeline::LinkRunner>(machine, commands, states); });
}

// Hops 2 to 7 and the recorder's tap, every detector of the table.
void wholeStep(benchmark::State& state) {
  const RecordedDemo& demo = recordedDemo();
  std::unique_ptr<pipeline::Chain> chain;
  std::unique_ptr<pipeline::StepLoop> loop;
  pipeline::SnapshotPublisher publisher;
  publisher.prepare(demo.setup, true, true);
  rt::Mailbox<OverrideCommand> commands;
  pipeline::RecordedStateSource feed;
  const SteadyClock clock;
  std::vector<StepInput> inputs = demo.inputs;
  overTheCut(
      state, [&](std::size_t i) { benchmark::DoNotOptimize(loop->step(inputs[i])); },
      [&] {
        loop.reset();
        chain = std::make_unique<pipeline::Chain>(everyDetector());
        chain->prepare(demo.setup, {}, demo.limits);
        loop = std::make_unique<pipeline::StepLoop>(
            pipeline::StepLoopParts{*chain, feed, commands, &publisher, nullptr, clock});
      });
}

[[maybe_unused]] const bool kRegistered = [] {
  using benchmark::RegisterBenchmark;
  constexpr auto kUnit = benchmark::kMicrosecond;
  RegisterBenchmark("0 simulated source", simulatedSource)->Unit(kUnit);
  RegisterBenchmark("2 conditioner", conditioner)->Unit(kUnit);
  for (const auto& row : detect::detectorTable()) {
    const std::string id(row.id);
    RegisterBenchmark(("3 detector " + id).c_str(), detector, id)->Unit(kUnit);
  }
  for (const auto& entry : control::strategyTable()) {
    const std::string id(entry.id);
    RegisterBenchmark(("4 strategy " + id).c_str(), strategy, id)->Unit(kUnit);
  }
  RegisterBenchmark("5 gate", gate)->Unit(kUnit);
  RegisterBenchmark("6 link tick", linkTick)->Unit(kUnit);
  RegisterBenchmark("7 spectrum tap", spectrumTap)->Unit(kUnit);
  RegisterBenchmark("7 publisher with spectrum", publisherWithSpectrum)->Unit(kUnit);
  RegisterBenchmark("8 recorder push", recorderPush)->Unit(kUnit)->UseManualTime();
  RegisterBenchmark("2-7 whole step, every detector", wholeStep)->Unit(kUnit);
  return true;
}();

}  // namespace
}  // namespace stillcut::bench
