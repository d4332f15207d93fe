#include "core/cnc/simulated_machine.h"

#include <optional>

namespace stillcut::cnc {

SimulatedMachine::SimulatedMachine(const milling::Scenario& scenario, std::shared_ptr<milling::PlantPort> port)
    : ranges_(scenario.overrides), block_(scenario.blockFrames / scenario.rate.value), port_(std::move(port)) {}

LinkInfo SimulatedMachine::describe() const {
  LinkInfo info;
  info.id = "simulated";
  info.label = "Simulated mill";
  info.simulated = true;
  info.machineWatchdog = true;
  info.lowestSpeed = ranges_.lowestSpeed;
  info.highestSpeed = ranges_.highestSpeed;
  info.lowestFeed = ranges_.lowestFeed;
  info.highestFeed = ranges_.highestFeed;
  info.period = block_;  // the plant moves on a block at a time
  return info;
}

Status SimulatedMachine::open() {
  if (!port_) return Error{message("simulated machine"), message("there is no plant to drive")};
  return Done{};
}

MachineState SimulatedMachine::read(Instant) noexcept {
  const std::optional<MachineState> state = linkUp_ ? port_->state() : std::nullopt;
  if (!state) {
    MachineState nothing;
    nothing.time = lastTime_;
    nothing.linkUp = linkUp_;
    return nothing;
  }
  lastTime_ = state->time;
  MachineState seen = *state;
  seen.controlOurs = controlOurs_;
  if (!seen.programRunning) seen.block = OverrideInhibit::NoProgram;
  if (!seen.overridesEnabled) seen.block = OverrideInhibit::OverridesLocked;
  if (!seen.controlOurs) seen.block = OverrideInhibit::OtherClient;
  seen.link.acknowledged = order_.when;  // a port takes an order at once
  seen.link.overrides = seen.link.speed = seen.link.feed = seen.link.program = seen.time;
  return seen;
}

void SimulatedMachine::post(Ratio speed, Ratio feed, Instant when) noexcept {
  order_.speed = speed;
  order_.feed = feed;
  order_.when = when;
  port_->order(order_);
}

void SimulatedMachine::apply(const OverrideCommand& command, Instant now) noexcept {
  if (!linkUp_ || !controlOurs_) return;
  engagement_ = command.engagement();
  if (engagement_ <= resetEngagement_) return;
  if (command.kind() == CommandKind::Release) {
    post(Ratio(1.0), Ratio(1.0), now);
  } else {
    post(command.speed(), command.feed(), now);
  }
}

void SimulatedMachine::release(Instant now) noexcept {
  // Without a link the machine's own watchdog has done it.
  if (linkUp_) post(Ratio(1.0), Ratio(1.0), now);
}

void SimulatedMachine::turnKnobs(Ratio speed, Ratio feed) noexcept {
  order_.operatorSpeedFactor = speed;
  order_.operatorFeedFactor = feed;
  port_->order(order_);
}

void SimulatedMachine::enableOverrides(bool enabled) noexcept {
  order_.overridesEnabled = enabled;
  port_->order(order_);
}

void SimulatedMachine::resetOverrides() noexcept {
  resetEngagement_ = engagement_;
  post(Ratio(1.0), Ratio(1.0), order_.when);
}

void SimulatedMachine::loseLink(bool lost) noexcept {
  linkUp_ = !lost;
  if (lost) post(Ratio(1.0), Ratio(1.0), order_.when);
}

}  // namespace stillcut::cnc
