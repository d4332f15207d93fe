#include "app/embed/block_run.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/evaluate/judged_samples.h"
#include "core/milling/cut_model.h"
#include "core/safety/gate_limits.h"

namespace stillcut::app {
namespace {

constexpr const char* kWhere = "samples";

Status check(const CutSetup& setup) {
  if (setup.channels.empty()) return Error{kWhere, message("have no channel")};
  if (setup.channels.size() > kMaxChannels) {
    return Error{kWhere, message("have %1 channels, more than are judged at once", setup.channels.size()),
                 message("at most 32")};
  }
  if (!(setup.rate >= evaluate::kSlowestSampling && setup.rate <= evaluate::kFastestSampling))
    return Error{kWhere, message("have a rate that no vibration is judged at"), message("100 to 1000000 a second")};
  if (setup.teeth < 0 || setup.teeth > milling::kMostTeeth)
    return Error{"teeth", message("must be 0 (not known) to 200")};
  if (!(setup.nominalSpeed.value >= 0.0 && setup.nominalSpeed.value <= 1e6))
    return Error{"speed", message("must be 0 (not known) to 1e6 rpm")};
  for (const ChannelInfo& channel : setup.channels) {
    if (!(channel.scale > 0.0) || !isFinite(Ratio(channel.scale)))
      return Error{"scale", message("must be above 0 and finite")};
  }
  return Done{};
}

Result<pipeline::ChainParts> partsOf(const std::vector<std::string>& detectors) {
  if (detectors.empty() || detectors.size() > kMaxDetectors)
    return Error{"detectors", message("one to %1 run at once", kMaxDetectors)};
  pipeline::ChainParts parts;
  for (const std::string& id : detectors) {
    auto detector = detect::makeDetector(id);
    if (!detector) return detector.error();
    parts.detectors.push_back(std::move(detector).value());
  }
  auto strategy = control::makeStrategy("monitor");
  if (!strategy) return strategy.error();
  parts.strategy = std::move(strategy).value();
  return parts;
}

}  // namespace

int BlockRun::framesOf(Hertz rate) {
  return std::max(1, static_cast<int>(rate.value * evaluate::kJudgedBlock.value));
}

Result<std::unique_ptr<BlockRun>> BlockRun::build(BlockRunOptions options) {
  if (const Status usable = check(options.setup); !usable) return usable.error();
  auto parts = partsOf(options.detectors);
  if (!parts) return parts.error();
  std::unique_ptr<BlockRun> run(new BlockRun());
  run->setup_ = std::move(options.setup);
  run->setup_.blockFrames = framesOf(run->setup_.rate);
  const auto limits = safety::gateLimits(options.params, run->setup_, "settings");
  if (!limits) return limits.error();
  run->chain_ = std::make_unique<pipeline::Chain>(std::move(parts).value());
  try {
    run->chain_->prepare(run->setup_, options.params, *limits);
  } catch (const std::exception& fault) {  // as Chain::prepare() says
    return Error{"settings", foreign(fault.what())};
  }
  run->input_.block.allocate(static_cast<int>(run->setup_.channels.size()), run->setup_.blockFrames);
  run->input_.block.rate = run->setup_.rate;
  return run;
}

void BlockRun::feed(std::span<const float> samples, Rpm measured, const Took& took) {
  measured_ = measured;
  SampleBlock& block = input_.block;
  const auto channels = static_cast<std::size_t>(block.channels);
  for (std::size_t at = 0; at + channels <= samples.size(); at += channels) {
    const auto frame = static_cast<std::size_t>(block.frames);
    for (std::size_t c = 0; c < channels; ++c)
      block.samples[c * static_cast<std::size_t>(block.capacityFrames) + frame] = samples[at + c];
    if (++block.frames == block.capacityFrames) step(took);
  }
}

void BlockRun::finish(const Took& took) {
  input_.block.flags |= kBlockEnd;
  if (input_.block.frames > 0) step(took);
}

void BlockRun::step(const Took& took) {
  SampleBlock& block = input_.block;
  block.firstSample = Instant(toDuration(Seconds(static_cast<double>(frames_) / block.rate.value)));
  input_.machine = MachineState{};
  if (measured_.value > 0.0) {
    input_.machine.time = block.end();
    input_.machine.valid = true;
    input_.machine.linkUp = true;  // whoever feeds stands for the machine; without a link nobody believes its speed
    input_.machine.programmedSpeed = input_.machine.actualSpeed = measured_;
  }
  took(input_, chain_->process(input_).output);
  frames_ += static_cast<std::uint64_t>(block.frames);
  ++block.sequence;
  block.frames = 0;
}

}  // namespace stillcut::app
