#include "app/cli/run/run_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/cli/command.h"
#include "app/compose/ending/interruption.h"
#include "app/compose/ending/orderly_end.h"
#include "app/compose/flight_log.h"
#include "app/compose/left_overrides.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/wakeup.h"

namespace stillcut::app {
namespace {

// For the flight log, the evidence and the last lines, also on a slow disk; a service is killed after 15 s.
constexpr Seconds kLeaves{10.0};
constexpr Seconds kLook{0.02};
constexpr Duration kStatusEvery = std::chrono::seconds(1);
constexpr double kSameFrequency = 0.02;

bool closesCard(ReasonCode code) {
  return code == ReasonCode::ChatterEnded || code == ReasonCode::ChatterLeftCut;
}

// The card that an event of this snapshot has closed.
const Intervention* closedCard(const Snapshot& s, const Event& event) {
  if (!closesCard(event.reason.code) || s.interventionCount == 0) return nullptr;
  const Intervention& card = s.interventions[(s.interventionCount - 1) % kInterventionsShown];
  return card.finished ? &card : nullptr;
}

}  // namespace

RunWatch::RunWatch(Rig& rig, const RunWatchOptions& options, const ProgramLog& log, RunReporter& reporter)
    : rig_(rig),
      options_(options),
      reporter_(reporter),
      log_(log),
      times_(rig.device().live()),
      samples_(clock_.now()) {}

int RunWatch::run(const RunBegin& begin) {
  FlightLog flights(rig_.flights(),
                    options_.flights.empty() ? defaultFlightsFolder() : std::filesystem::path(options_.flights));
  flights.start();
  Status recorded = Done{};
  // A console that takes no more lines (a terminal on hold, a pipe that nobody empties) holds up this thread, and not
  // the end.
  OrderlyEnd orderly([&] { recorded = rig_.stop(); }, interrupted, kLeaves);
  reporter_.start(begin);
  // A page that has to come back from the disk would keep the worker waiting.
  if (!rt::lockMemory())
    reporter_.note("memory is not locked: not permitted (the package's limits allow it to the group stillcut)");
  log_.begin(rig_, begin.profilePath);
  rig_.start({});
  if (rig_.device().live() && rig_.engine()->workerScheduling() != rt::Scheduling::Fifo) {
    reporter_.note("at ordinary priority: real-time priority is for members of the group stillcut");
  }
  service_.ready();
  samples_ = SampleWatch(clock_.now());
  nextStatus_ = clock_.now() + kStatusEvery;
  rt::Wakeup never;  // only its time-out is used
  RunEnd end;
  while (end.why.empty()) {
    never.waitFor(kLook);
    look();
    end = ending();
  }
  service_.stopping();
  orderly.endNow();
  look();
  keepCuts();
  log_.end(rig_, recorded);
  if (const Status written = flights.finish(); !written) fail(written.error());
  if (!recorded) end = {kExitDevice, end.why + "; the recording has stopped"};
  if (!recorded && !recordingTold_) fail(recorded.error());
  return finish(std::move(end));
}

void RunWatch::keepCuts() {
  if (options_.cuts == nullptr) return;
  options_.cuts->finish();
  if (!options_.cuts->problem().empty()) fail(Error{{}, options_.cuts->problem()});
}

int RunWatch::finish(RunEnd end) {
  if (const Message fault = rig_.device().fault(); !fault.empty()) {
    fail(Error{{}, fault});
    end = {kExitDevice, text(fault)};
  }
  const RunLook last{snapshot_ != nullptr ? *snapshot_ : Snapshot(), times_};
  reporter_.end(end, snapshot_ != nullptr ? &last : nullptr);
  return end.exitCode;
}

RunEnd RunWatch::ending() const {
  if (interrupted()) return {kExitDone, "it was asked to"};
  if (unread()) return {kExitDone, "nobody reads what it says any more"};
  if (rig_.finished()) return {kExitDone, "the source has no more samples"};
  if (snapshot_ != nullptr && options_.length.value > 0.0 &&
      times_.sinceBegin(snapshot_->time).value_or(Seconds()) >= options_.length) {
    return {kExitDone, "as many seconds as were asked for"};
  }
  if (options_.giveUp.value > 0.0 && samples_.silent(clock_.now()) >= options_.giveUp)
    return {kExitDevice, "no samples come any more"};
  return {};
}

// Tells what has happened since the last look.
void RunWatch::look() {
  if (const Snapshot* newest = rig_.read()) snapshot_ = newest;
  log_.look(rig_, snapshot_);
  if (snapshot_ != nullptr) {
    times_.look(*snapshot_);
    if (options_.cuts != nullptr) options_.cuts->look(*snapshot_);
    if (!modeAsked_) askMode(*snapshot_);
    tellEvents(*snapshot_);
    tellState(*snapshot_);
  }
  tellSilence(snapshot_);
  watchRecording();
  watchLeft();
  const std::string status = snapshot_ != nullptr ? std::string(shownState(inCharge(*snapshot_))) : "no samples yet";
  service_.alive(clock_.now(), status);
}

// Not before the machine was read once: what may be moved is known then.
void RunWatch::askMode(const Snapshot& snapshot) {
  if (rig_.hasLink() && !snapshot.machine.valid) return;
  modeAsked_ = true;
  if (options_.mode != Authority::Off) rig_.send({OperatorAction::SetAuthority, options_.mode});
}

void RunWatch::tellEvents(const Snapshot& snapshot) {
  const std::uint64_t oldest = snapshot.eventCount > kEventsShown ? snapshot.eventCount - kEventsShown : 0;
  if (oldest > events_) reporter_.note(std::to_string(oldest - events_) + " lines passed unseen");
  for (events_ = std::max(events_, oldest); events_ < snapshot.eventCount; ++events_) {
    const Event& event = snapshot.events[events_ % kEventsShown];
    reporter_.event({snapshot, times_}, event, closedCard(snapshot, event));
  }
}

void RunWatch::tellState(const Snapshot& snapshot) {
  const Verdict& v = inCharge(snapshot);
  const Shown now{shownState(v),
                  v.reason.code,
                  v.kind,
                  v.frequency.value,
                  snapshot.authority,
                  snapshot.advice.kind,
                  std::round(snapshot.advice.speed.value)};
  const bool same = now.state == shown_.state && now.reason == shown_.reason && now.kind == shown_.kind &&
                    now.mode == shown_.mode && now.advice == shown_.advice && now.advised_rpm == shown_.advised_rpm &&
                    std::abs(now.frequency_Hz - shown_.frequency_Hz) <= kSameFrequency * shown_.frequency_Hz;
  if (!same) {
    shown_ = now;
    reporter_.change({snapshot, times_});
  }
  if (!options_.status || clock_.now() < nextStatus_) return;
  nextStatus_ = std::max(nextStatus_ + kStatusEvery, clock_.now());
  reporter_.status({snapshot, times_});
}

void RunWatch::tellSilence(const Snapshot* snapshot) {
  const PathHealth health = snapshot != nullptr ? snapshot->health : PathHealth();
  const Instant now = clock_.now();
  switch (samples_.look(health.blocks, health.blockLength, now)) {
    case SampleWatch::Turn::Stopped:
      if (!rig_.finished()) reporter_.stopped(samples_.silent(now), text(rig_.device().trouble()));
      break;
    case SampleWatch::Turn::Resumed:
      reporter_.resumed(samples_.was());
      break;
    case SampleWatch::Turn::None:
      break;
  }
}

// Says once that nothing is recorded any more: it has to be known while the cut can still be repeated.
void RunWatch::watchRecording() {
  if (recordingTold_ || rig_.recorder() == nullptr) return;
  const Message stopped = rig_.recorder()->status().fault;
  recordingTold_ = !stopped.empty();
  if (recordingTold_) fail(Error{{}, stopped, message("monitoring goes on")});
}

// The same of what a killed run has left in the machine; without a screen there is no button to bring it back.
void RunWatch::watchLeft() {
  const auto left = rig_.leftInMachine();
  if (!left || std::exchange(leftTold_, true)) return;
  fail(Error{{}, leftSentence(*left)});
  reporter_.note(text(leftSentence(*left)));
}

}  // namespace stillcut::app
