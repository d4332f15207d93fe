// Recorder: the tap. The worker copies each step into a preallocated slot; the recorder's own thread writes the session
// file. When the disk fails or fills, recording stops and says so; the worker never notices more than a false.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/realtime.h"
#include "core/base/result.h"
#include "core/model/step_record.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/spsc_ring.h"
#include "core/rt/wakeup.h"
#include "core/session/file/session_writer.h"
#include "core/session/step_sink.h"

namespace stillcut::record {

struct RecorderOptions {
  Seconds buffer{4.0};                        // of steps that may wait for a slow disk
  std::uint64_t reserveBytes = 64ULL << 20U;  // stop, and close cleanly, before the disk is fuller than this
  Disk* disk = nullptr;                       // null: the system's
};

struct RecorderStatus {
  bool recording = false;
  Message fault;              // one line: why it stopped by itself; empty otherwise
  std::uint64_t written = 0;  // steps handed to the file
  std::uint64_t dropped = 0;  // steps that found no free slot, or came after the stop
  std::string path;           // of the file, or of the last one
  bool writing = false;       // a file is open: around events there is none most of the time
};

class Recorder {
 public:
  // Set-up thread. Creates the session file; the steps that will come have the format of header.setup.
  static Result<std::unique_ptr<Recorder>> create(const std::string& path, const SessionHeader& header,
                                                  const RecorderOptions& options = {});
  // The same under the first name of `nextPath` that nobody has.
  static Result<std::unique_ptr<Recorder>> create(const NextPath& nextPath, const SessionHeader& header,
                                                  const RecorderOptions& options = {});
  // One that has stopped before it began, for the reason `why`: every step is dropped and counted, and its status and
  // finish() say why. A cut is watched all the same.
  static std::unique_ptr<Recorder> stopped(const std::string& path, const Error& why, const CutSetup& setup);
  // The same into any sink.
  static std::unique_ptr<Recorder> create(std::unique_ptr<StepSink> sink, const CutSetup& setup,
                                          const RecorderOptions& options = {});
  ~Recorder();  // as finish(), without a report
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Set-up thread: from now on a thread of its own writes. Without it, call drain() (deterministic runs).
  void startThread();
  // Worker. False: dropped and counted; the next step that is taken carries the gap.
  bool push(const StepInput& input, const StepOutput& output) STILLCUT_RT;
  // Worker: recording has stopped by itself.
  bool stopped() const STILLCUT_RT { return !recording_.load(std::memory_order_relaxed); }
  // The writing thread (startThread() does it by itself): writes everything that waits. False: recording has stopped.
  bool drain();
  // Thread of drain(), before finish(): truth of a simulated cut, and other late knowledge. Null once stopped.
  SessionWriter* writer() { return sink_ ? sink_->writer() : nullptr; }
  // Set-up thread, when the worker has stopped: joins the thread, writes what waits, closes.
  Status finish();
  // Any thread but the worker's.
  RecorderStatus status() const;

 private:
  Recorder(std::unique_ptr<StepSink> sink, const CutSetup& setup, const RecorderOptions& options);
  void run(const std::stop_token& stop);
  Status checkSpace();
  void stopWith(const Message& fault);

  RecorderOptions options_;
  std::unique_ptr<StepSink> sink_;
  rt::SpscRing<StepRecord> ring_;
  std::uint64_t lostFrames_ = 0;  // worker's: frames of dropped steps since the last one taken
  bool lost_ = false;
  std::atomic<bool> recording_{true};
  std::atomic<std::uint64_t> written_{0};
  std::atomic<std::uint64_t> dropped_{0};
  std::atomic<bool> writing_{false};
  mutable std::mutex faultLock_;  // of the two below
  Message fault_;
  std::string path_;
  rt::Wakeup wakeup_;
  std::optional<rt::RealtimeThread> thread_;  // last: joined before what it uses goes
};

}  // namespace stillcut::record
