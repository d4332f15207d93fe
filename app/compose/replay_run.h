// ReplayRun: a rig on a recording, run block by block on a thread of its own and led by a hand on the screen. One
// thread reads, decides and publishes, so that nothing is dropped at any pace and the verdicts are the same at all of
// them. Thread: construction, start() and stop() on the set-up thread; read() on the screen's; finished() on any. The
// rig is the run's from start() to stop().
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include "app/compose/rig.h"
#include "core/daq/replay_control.h"
#include "core/rt/realtime_thread.h"

namespace stillcut::app {

class ReplayRun {
 public:
  // `rig`: made with `control` as its hand.
  ReplayRun(std::unique_ptr<Rig> rig, std::shared_ptr<daq::ReplayControl> control)
      : rig_(std::move(rig)), control_(std::move(control)) {}
  ~ReplayRun() { stop(); }
  ReplayRun(const ReplayRun&) = delete;
  ReplayRun& operator=(const ReplayRun&) = delete;

  // `after`: on the run's thread, after each block; may be empty.
  void start(Rig::After after = {});
  void stop();
  // The recording has ended. One that was paused or loops does not.
  bool finished() const { return finished_.load(std::memory_order_acquire); }
  daq::ReplayControl& control() { return *control_; }
  // What does not change while it runs: set-up, parameters, parts.
  const Rig& rig() const { return *rig_; }
  const Snapshot* read() { return rig_->read(); }
  pipeline::SignalTap& signal() { return rig_->signal(); }
  void showChannel(int channel) { rig_->showChannel(channel); }
  // To the run, at its next block: new parameters. Screen's thread. False: too many at once.
  bool send(const OperatorInput& input) { return rig_->send(input); }
  // After stop(): what made it end early; empty for a plain end.
  Message fault() const { return rig_->device().fault(); }

 private:
  std::unique_ptr<Rig> rig_;
  std::shared_ptr<daq::ReplayControl> control_;
  std::atomic<bool> finished_{false};
  std::optional<rt::RealtimeThread> thread_;
};

}  // namespace stillcut::app
