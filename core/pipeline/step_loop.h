// StepLoop: everything the worker does with one step, hops 2 to 5 and the hand-over of what came out: the command to
// the link's mailbox, the picture to the screen, the step to the recorder. The threaded engine and the deterministic
// run both consist of calls of step().
// Thread: worker, real-time. The parts it refers to must outlive it.
#pragma once

#include "core/base/time.h"
#include "core/model/step_record.h"
#include "core/pipeline/chain.h"
#include "core/pipeline/intervention_log.h"
#include "core/pipeline/link_runner.h"
#include "core/pipeline/machine_state_source.h"
#include "core/pipeline/snapshot_publisher.h"
#include "core/rt/mailbox.h"

namespace stillcut::pipeline {

// Where finished steps go besides the link: the recorder's ring. False: it had no room.
class StepTap {
 public:
  virtual ~StepTap() = default;
  // Copies the step or drops it; never waits.
  virtual bool push(const StepInput& input, const StepOutput& output) noexcept = 0;
  // It has given up for good; the loop says so once, and goes on.
  virtual bool stopped() const noexcept { return false; }
};

struct StepLoopParts {
  Chain& chain;
  MachineStateSource& feed;
  rt::Mailbox<OverrideCommand>& commands;
  SnapshotPublisher* publisher = nullptr;  // may be absent: nobody watches
  StepTap* tap = nullptr;                  // may be absent: nothing is recorded
  const Clock& clock;                      // measures ages and processing times only; decides nothing
};

class StepLoop {
 public:
  explicit StepLoop(const StepLoopParts& parts) : parts_(parts) {}

  // Completes, processes and hands on one step.
  const Chain::Step& step(StepInput& input) noexcept;

  // Blocks lost before the ring so far. Before step().
  void countDropped(std::uint64_t total) noexcept { health_.droppedBlocks = total; }
  // Of the link thread. Before step().
  void countLink(const LinkTally& tally, Instant now) noexcept {
    health_.leasesExpired = tally.leasesExpired;
    health_.linkStalls = tally.stalls;
    health_.linkThreadAge = tally.lastTick != Instant{} ? secondsBetween(tally.lastTick, now) : Seconds();
  }
  const PathHealth& health() const { return health_; }
  const InterventionLog& interventions() const { return log_; }

 private:
  void tap(const StepInput& input) noexcept;
  void tellLosses(Instant now) noexcept;
  void tellLostEvents(Instant now) noexcept;
  void keep(const Event& event) noexcept;
  void measure(const StepInput& input, const Chain::Step& done, Instant began) noexcept;

  StepLoopParts parts_;
  InterventionLog log_;
  StepOutput output_;
  PathHealth health_;
  std::uint64_t saidDropped_ = 0;  // blocks that have been reported
  Instant saidAt_{};
  std::uint64_t eventsLost_ = 0, saidEventsLost_ = 0;
  bool started_ = false;
  bool tapStopTold_ = false;
  Instant previous_{};
};

}  // namespace stillcut::pipeline
