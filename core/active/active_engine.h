// ActiveEngine: the loop of the active work-holder on its device, with a thread of its own: identifies, controls, and
// tells what it does. A start is refused without a valid model, with one too old, one without phase margin, and
// after the device was opened anew or may have become later. Whatever the device loses makes the output zero and is
// counted. The owner renews the lease of the gates, at least every half second: when it stands still, the table is let
// go after a second of the device's time. Thread: one owner for everything; fit() may be called on another while
// nothing is being recorded. The owner may go away at any time: the destructor ramps out first.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "core/active/active_loop.h"
#include "core/active/duplex_device.h"
#include "core/active/path_recorder.h"
#include "core/active/stability_margin.h"
#include "core/base/time.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/triple_buffer.h"

namespace stillcut::active {

struct ActiveEngineOptions {
  FxlmsOptions controller;  // its emphasis is on `lines`
  std::array<safety::ActuatorLimits, kActiveAxes> limits{};
  std::vector<Hertz> lines;  // to quieten
  RecordRequest record;
  PathRequest path;
  Seconds oldestModel{3600.0};
  double auxiliary = 0.0;  // rms of the noise for on-line identification, as a fraction of the stroke; 0: off
};

using PathPairFound = std::array<IdentifiedPath, kActiveAxes>;

// What each axis of a loop on these paths is to be.
std::array<AxisOptions, kActiveAxes> axisOptions(const ActiveEngineOptions& options, const PathPairFound& paths);

class ActiveEngine {
 public:
  ActiveEngine(std::unique_ptr<DuplexDevice> device, ActiveEngineOptions options, const Clock& clock);
  ~ActiveEngine();
  ActiveEngine(const ActiveEngine&) = delete;
  ActiveEngine& operator=(const ActiveEngine&) = delete;

  // Opens the device and starts the thread; what was identified before no longer counts.
  Status open();
  // Ramps out and ends the thread.
  void close();
  bool isOpen() const { return open_.load(std::memory_order_acquire); }
  DuplexDevice& device() { return *device_; }

  Status identify();
  // The record is whole, or ended early; fit() says which.
  bool recorded() const { return recorded_.load(std::memory_order_acquire); }
  Result<PathPairFound> fit() const;
  Status install(const PathPairFound& paths);
  const std::array<ActivePath, kActiveAxes>& paths() const { return paths_; }

  Status start();
  void stop();
  void renew() { renewals_.fetch_add(1, std::memory_order_relaxed); }
  Status setStep(double step);  // 0 .. 1
  Status setLeak(double leak);  // 0.9 .. 1

  // The newest, or null before the first.
  const ActiveSnapshot* pull() { return snapshots_.read(); }

 private:
  void run(const std::stop_token& stop);
  void renew(const std::stop_token& stop);
  void block(std::span<const double> in, std::span<safety::ActuatorCommand> out) STILLCUT_RT;
  void lost() STILLCUT_RT;
  void cut() STILLCUT_RT;
  void publish() STILLCUT_RT;
  bool busy() const;                                                     // identifying or controlling
  Instant identifiedAt(std::size_t axis, const ActivePath& path) const;  // or renewed on-line since

  std::unique_ptr<DuplexDevice> device_;
  ActiveEngineOptions options_;
  const Clock& clock_;
  DuplexFormat format_;
  std::array<ActivePath, kActiveAxes> paths_{};
  std::unique_ptr<PathRecorder> recorder_;
  std::vector<std::unique_ptr<ActiveLoop>> loops_;  // the last is in force; older ones go with the thread
  std::atomic<PathRecorder*> recording_{nullptr};
  std::atomic<ActiveLoop*> loop_{nullptr};
  std::atomic<bool> open_{false}, recorded_{false};
  std::atomic<bool> delayLost_{false};  // what the models say of it may no longer hold
  std::atomic<double> step_, leak_;
  std::atomic<std::uint64_t> renewals_{0};

  // The loop's thread alone.
  ActiveSnapshot telling_;
  std::uint64_t heardRenewals_ = 0;
  int untold_ = 0;  // frames since the last snapshot
  std::vector<double> in_;
  std::vector<safety::ActuatorCommand> out_;
  rt::TripleBuffer<ActiveSnapshot> snapshots_;
  rt::TripleBuffer<std::array<ActivePath, kActiveAxes>> margins_;   // owner to thread
  std::array<std::atomic<std::int64_t>, kActiveAxes> renewedAt_{};  // [ns]
  std::jthread renewer_;  // beside the loop, while on-line identification is on
  std::unique_ptr<rt::RealtimeThread> thread_;
};

}  // namespace stillcut::active
