#include "core/pipeline/snapshot_publisher.h"

namespace stillcut::pipeline {

void SnapshotPublisher::prepare(const CutSetup& setup, bool simulated, bool autoAllowed) {
  spectrum_.prepare(setup);
  signal_.prepare(setup);
  simulated_ = simulated;
  autoAllowed_ = autoAllowed;
}

void SnapshotPublisher::collectEvents(const StepOutput& output) noexcept {
  for (int i = 0; i < output.eventCount; ++i) {
    Event event = output.events[static_cast<std::size_t>(i)];
    event.number = eventCount_;
    events_[eventCount_ % kEventsShown] = event;
    ++eventCount_;
  }
}

void SnapshotPublisher::publish(const StepInput& input, const StepOutput& output, const Chain::Step& step,
                                const InterventionLog& log, const PathHealth& health) noexcept {
  spectrum_.feed(input.block, output.verdicts[static_cast<std::size_t>(output.inCharge)]);
  signal_.feed(input.block);
  collectEvents(output);
  if (output.hasCommand) {
    lastCommand_ = output.command;
    commanding_ = output.command.kind == CommandKind::Set;
  }

  Snapshot& s = buffer_.back();
  s.number = ++number_;
  s.time = input.block.end();
  s.running = !input.block.has(kBlockEnd);
  s.simulated = simulated_;
  s.autoAllowed = autoAllowed_;
  s.detectorCount = output.verdictCount;
  s.inCharge = output.inCharge;
  s.verdicts = output.verdicts;
  s.request = output.request;
  s.adviceOpen = step.gate.adviceOpen;
  s.adviceNumber = step.gate.adviceNumber;
  s.advice = step.advice;
  s.command = lastCommand_;
  s.commanding = commanding_;
  s.authority = step.gate.authority;
  s.authoritySince = step.gate.authoritySince;
  s.operatorHold = step.gate.operatorHold;
  s.machine = input.machine;
  s.vibrationRms = step.vibrationRms;
  s.cutTime = log.cutTime();
  s.judgedTime = log.judgedTime();
  s.chatterTime = log.chatterTime();
  s.chatterLength = log.chatterLength();
  s.health = health;
  if (step.sensors != nullptr) s.sensors = *step.sensors;
  s.columnCount = spectrum_.count();
  s.spectrumTop = spectrum_.top();
  for (std::uint64_t c = 0; c < kSpectrumColumns; ++c) s.columns[c] = spectrum_.column(c);
  s.eventCount = eventCount_;
  s.events = events_;
  s.interventionCount = log.count();
  for (std::uint64_t c = 0; c < kInterventionsShown; ++c) s.interventions[c] = log.card(c);
  buffer_.publish();
}

}  // namespace stillcut::pipeline
