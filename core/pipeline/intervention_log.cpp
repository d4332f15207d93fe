#include "core/pipeline/intervention_log.h"

#include <algorithm>
#include <cmath>

#include "core/model/event_slots.h"
#include "core/model/judged_cut.h"

namespace stillcut::pipeline {
namespace {

// A cut counts as quiet again when no alarm came back for this long; shorter pauses are the beat of the same chatter.
constexpr Seconds kQuietFor{0.25};
// A factor nearer to 1 than this is the programmed value.
constexpr double kMoved = 1e-3;

bool moves(const CommandRecord& c) {
  return c.kind == CommandKind::Set &&
         (std::abs(c.speed.value - 1.0) > kMoved || std::abs(c.feed.value - 1.0) > kMoved);
}

// Without a machine the spindle is as fast as its vibration says.
Rpm speedOf(const StepInput& input, const Verdict& verdict) {
  return input.machine.actualSpeed.value > 0.0 ? input.machine.actualSpeed : toRpm(verdict.spindle);
}

}  // namespace

void InterventionLog::append(StepOutput& output, EventLevel level, Instant time, const Reason& reason) noexcept {
  const int lost = addEvent(output.events, output.eventCount, Event{time, eventNumber_++, level, reason});
  eventsLost_ += static_cast<std::uint64_t>(lost);
}

void InterventionLog::follow(const StepInput& input, StepOutput& output, const CutNow& cut, Seconds dt) noexcept {
  const Verdict& verdict = output.verdicts[static_cast<std::size_t>(output.inCharge)];
  alarming_ = verdict.alarming();
  if (inCut(verdict)) cutTime_ += dt;
  if (judges(verdict)) judgedTime_ += dt;
  // Without a verdict nobody knows whether it is quiet. An exit may be one or chatter that dies down: what it was shows
  // in what follows, air or a steady cut.
  if (alarming_) {
    sinceAlarm_ = Seconds();
  } else if (verdict.valid && verdict.phase != CutPhase::Exit) {
    sinceAlarm_ += dt;
  }
  // An onset marks nothing yet: what is counted is the full chatter.
  if (alarming_ && verdict.state == CutState::Chatter) {
    chatterTime_ += dt;
    chatterLength_ += Metres(cut.feed.value * dt.value);
  }
  if (alarming_) {
    lastAlarm_ = verdict.time;
    if (!open_) begin(input, output, verdict, cut);
  }
  if (open_) update(input, output, verdict, cut, dt);
  judge(cut.judged);
}

// It may come after the card was closed: a move has helped when the alarm has stayed away for a while.
void InterventionLog::judge(const safety::GateOutput::Judged& judged) noexcept {
  if (judged.outcome == MoveOutcome::None || count_ == 0) return;
  Intervention& card = cards_[(count_ - 1) % kInterventionsShown];
  if (card.commanded == Instant{}) return;
  card.outcome = judged.outcome;
  card.timesAsLoud = judged.timesAsLoud;
  card.withoutHelp = judged.withoutHelp;
  card.endedAuto = judged.endsAuto;
}

void InterventionLog::begin(const StepInput& input, StepOutput& output, const Verdict& verdict,
                            const CutNow& cut) noexcept {
  Intervention& card = cards_[count_ % kInterventionsShown];
  card = Intervention{};
  card.number = count_++;
  card.began = verdict.time;
  card.frequency = verdict.frequency;
  card.speedBefore = card.speedAfter = speedOf(input, verdict);
  card.feedBefore = card.feedAfter = input.machine.actualFeed;
  card.vibrationBefore = cut.vibrationRms;
  open_ = true;
  append(output, EventLevel::Warning, verdict.time,
         {ReasonCode::ChatterBegan, {verdict.frequency.value, verdict.severity.value, 0.0, 0.0}});
}

void InterventionLog::update(const StepInput& input, StepOutput& output, const Verdict& verdict, const CutNow& cut,
                             Seconds dt) noexcept {
  Intervention& card = cards_[(count_ - 1) % kInterventionsShown];
  if (output.hasCommand && moves(output.command) && card.commanded == Instant{}) card.commanded = output.command.time;
  card.speedAfter = speedOf(input, verdict);
  card.feedAfter = input.machine.actualFeed;
  const MetresPerSecond wanted = input.machine.programmedFeed * input.machine.operatorFeed.value;
  const bool known = wanted.value > 0.0 && card.feedAfter.value > 0.0;
  card.cycleTime = known ? Ratio(wanted / card.feedAfter) : Ratio(1.0);
  card.vibrationAfter = cut.vibrationRms;
  if (verdict.valid) card.severityAfter = verdict.severity;
  if (alarming_) {
    // "Before" ends with our first command: while the spindle changes its speed nothing repeats by revolutions, and
    // the energy ratio says nothing about chatter.
    if (card.commanded == Instant{}) {
      card.severityBefore = std::max(card.severityBefore, verdict.severity);
      card.vibrationBefore = std::max(card.vibrationBefore, cut.vibrationRms);
      if (verdict.state == CutState::Chatter || card.frequency.value <= 0.0) card.frequency = verdict.frequency;
    }
    if (verdict.state == CutState::Chatter) card.marked += Metres(cut.feed.value * dt.value);
    return;
  }
  const bool left = verdict.phase == CutPhase::AirCutting;
  const bool quiet = sinceAlarm_ >= kQuietFor;
  if (!left && !quiet) return;
  card.finished = true;
  card.quiet = quiet && !left;  // a tool that left the cut proves nothing
  card.timeToStable = secondsBetween(card.began, lastAlarm_);
  open_ = false;
  const ReasonCode end = card.quiet ? ReasonCode::ChatterEnded : ReasonCode::ChatterLeftCut;
  append(output, EventLevel::Info, input.block.end(),
         {end, {card.timeToStable.value, card.marked.value * 1e3, 0.0, 0.0}});
}

}  // namespace stillcut::pipeline
