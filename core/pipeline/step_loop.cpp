#include "core/pipeline/step_loop.h"

#include <algorithm>

#include "core/model/event_slots.h"

namespace stillcut::pipeline {
namespace {

constexpr Seconds kBetweenLosses{1.0};

}  // namespace

const Chain::Step& StepLoop::step(StepInput& input) noexcept {
  const Instant began = parts_.clock.now();
  parts_.feed.complete(input);

  const Chain::Step& done = parts_.chain.process(input);
  // No command: the last one stays, and its lease runs.
  if (done.gate.command) parts_.commands.post(*done.gate.command);

  const Seconds length(input.block.frames / input.block.rate.value);
  output_ = done.output;
  tellLosses(input.block.end());
  tellLostEvents(input.block.end());
  log_.follow(input, output_, {done.vibrationRms, done.feed, done.gate.judged},
              started_ ? secondsBetween(previous_, input.block.end()) : length);
  eventsLost_ += static_cast<std::uint64_t>(done.eventsLost);
  previous_ = input.block.end();
  started_ = true;

  if (parts_.tap != nullptr) tap(input);
  measure(input, done, began);
  if (parts_.publisher != nullptr) parts_.publisher->publish(input, output_, done, log_, health_);
  return done;
}

void StepLoop::tap(const StepInput& input) noexcept {
  if (!tapStopTold_ && parts_.tap->stopped()) {
    tapStopTold_ = true;
    const Reason why{ReasonCode::RecorderStopped, {}};
    keep({input.block.end(), 0, EventLevel::Fault, why});
    parts_.chain.flights().capture(why, input.block.end());
  }
  if (!parts_.tap->push(input, output_)) ++health_.tapDropped;
}

// Blocks that were lost are reported, at most once a second.
void StepLoop::tellLosses(Instant now) noexcept {
  if (health_.droppedBlocks <= saidDropped_) return;
  if (saidDropped_ > 0 && secondsBetween(saidAt_, now) < kBetweenLosses) return;
  const auto lost = static_cast<double>(health_.droppedBlocks - saidDropped_);
  keep({now, 0, EventLevel::Warning, {ReasonCode::DroppedBlocks, {lost}}});
  saidDropped_ = health_.droppedBlocks;
  saidAt_ = now;
}

// Lines of earlier steps that found no room.
void StepLoop::tellLostEvents(Instant now) noexcept {
  const std::uint64_t all = eventsLost_ + log_.eventsLost();
  if (all <= saidEventsLost_) return;
  const auto lost = static_cast<double>(all - saidEventsLost_);
  saidEventsLost_ = all;
  keep({now, 0, EventLevel::Warning, {ReasonCode::EventsLost, {lost}}});
}

void StepLoop::keep(const Event& event) noexcept {
  eventsLost_ += static_cast<std::uint64_t>(addEvent(output_.events, output_.eventCount, event));
}

void StepLoop::measure(const StepInput& input, const Chain::Step& done, Instant began) noexcept {
  const Instant now = parts_.clock.now();
  ++health_.blocks;
  if (input.block.has(kBlockGap)) ++health_.gaps;
  if (done.detectorFailed) ++health_.detectorFaults;
  health_.blockLength = Seconds(input.block.frames / input.block.rate.value);
  health_.processing = secondsBetween(began, now);
  health_.worstProcessing = std::max(health_.worstProcessing, health_.processing);
  if (health_.processing > health_.blockLength) ++health_.overruns;
  health_.blockAge = std::max(Seconds(), secondsBetween(input.block.end(), now));
  health_.worstBlockAge = std::max(health_.worstBlockAge, health_.blockAge);
}

}  // namespace stillcut::pipeline
