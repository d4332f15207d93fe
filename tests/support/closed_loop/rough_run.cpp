#include "tests/support/closed_loop/rough_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "core/control/registry.h"
#include "core/detect/registry.h"
#include "core/safety/gate_limits.h"

namespace stillcut::test {
namespace {

template <class T>
T must(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().line());
  return std::move(result).value();
}

constexpr double kRest = 0.5;  // [s] without a change: what follows is another move
constexpr double kTiny = 1e-6;

}  // namespace

RoughRun::RoughRun(const milling::Scenario& scenario, Roughness roughness)
    : scenario_(scenario),
      rough_(std::move(roughness)),
      port_(std::make_shared<milling::PlantPort>()),
      source_(scenario_, 0, port_),
      machine_(scenario_, port_),
      feed_(states_, inputs_) {
  const CutSetup setup = scenario_.cutSetup();
  pipeline::ChainParts parts;
  parts.detectors.push_back(must(detect::makeDetector(detect::kDefaultDetector)));
  parts.strategy = must(control::makeStrategy(rough_.strategy));
  chain_ = std::make_unique<pipeline::Chain>(std::move(parts));
  safety::GateLimits limits = must(safety::gateLimits({}, setup, "settings"));
  limits.autoAllowed = true;
  chain_->prepare(setup, {}, limits);
  loop_ = std::make_unique<pipeline::StepLoop>(
      pipeline::StepLoopParts{*chain_, feed_, commands_, nullptr, nullptr, clock_});
  link_ = std::make_unique<pipeline::LinkRunner>(machine_, commands_, states_);
  must(source_.open());
  const double block = scenario_.blockFrames / scenario_.rate.value;
  waiting_.resize(1 + static_cast<std::size_t>(std::ceil(rough_.burst.value / block)));
  for (StepInput& input : waiting_) {
    input.block.allocate(static_cast<int>(setup.channels.size()), scenario_.blockFrames);
  }
  inputs_.push({OperatorAction::SetAuthority, Authority::Auto});
}

void RoughRun::toEnd() {
  while (source_.read(waiting_[waits_].block)) {
    SampleBlock& block = waiting_[waits_].block;
    const double t = sinceEpoch(block.firstSample).value;
    if (rough_.spoil) rough_.spoil(block, t);
    if (rough_.speedFreezesAt && t >= *rough_.speedFreezesAt && !feed_.frozen) {
      feed_.frozen = port_->state()->actualSpeed;
    }
    if (++waits_ == waiting_.size()) deliver();
    link_->tick(block.end());
  }
}

void RoughRun::deliver() {
  for (std::size_t i = 0; i < waits_; ++i) process(waiting_[i]);
  waits_ = 0;
}

void RoughRun::process(StepInput& input) {
  done_ = &loop_->step(input);
  const StepOutput& out = done_->output;
  for (int i = 0; i < out.eventCount; ++i) {
    const Reason& why = out.events[static_cast<std::size_t>(i)].reason;
    said_.push_back(why.code);
    char when[32];
    std::snprintf(when, sizeof when, "%8.3f s  ", sinceEpoch(input.block.end()).value);
    story_ += when + sentence(why) + "\n";
  }
  if (out.hasCommand) countSwing(out.command);
}

void RoughRun::countSwing(const CommandRecord& command) {
  const double speed = command.kind == CommandKind::Set ? command.speed.value : 1.0;
  const double further = std::abs(speed - 1.0) - std::abs(last_ - 1.0);
  last_ = speed;
  if (std::abs(further) < kTiny) return;
  const bool rested = secondsBetween(moved_, command.time).value > kRest;
  moved_ = command.time;
  if (further > 0.0 && (rested || !outward_)) ++swings_;
  outward_ = further > 0.0;
}

int RoughRun::events(ReasonCode code) const {
  return static_cast<int>(std::count(said_.begin(), said_.end(), code));
}

}  // namespace stillcut::test
