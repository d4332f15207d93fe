// FlightLog: writes the flight recordings of a run (every fault, refusal and change of authority) as text files, so
// that what happened can be read afterwards. An error leaves the run alone: it is about the disk, not about the
// machine. Thread: start(), finish() and the destructor on the owner's; between them the disk is touched on a thread of
// its own. problem() on any. Without start(), poll() does the same in the caller's thread.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/rt/realtime_thread.h"
#include "core/rt/wakeup.h"
#include "core/safety/flight_recorder.h"

namespace stillcut::app {

// Where flight recordings go when nobody says otherwise: $XDG_DATA_HOME/stillcut/flights, else below ~/.local/share.
std::filesystem::path defaultFlightsFolder();

class FlightLog {
 public:
  // Files go to `folder`, made when the first one comes; the oldest are removed beyond `keep`. `recorder` outlives the
  // log.
  FlightLog(safety::FlightRecorder& recorder, std::filesystem::path folder, int keep = 200)
      : recorder_(recorder), folder_(std::move(folder)), keep_(keep) {}
  ~FlightLog() { (void)finish().ok(); }
  FlightLog(const FlightLog&) = delete;
  FlightLog& operator=(const FlightLog&) = delete;

  void start();
  // When the worker has stopped: joins the thread and writes what waits. An error: something could not be written.
  Status finish();
  // Empty, or why the newest recording could not be written, until one could.
  Message problem() const;

  // Writes one recording, the one that failed before a new one. True: there may be more. Not while started.
  bool poll();

 private:
  void run(const std::stop_token& stop);
  Status write() const;
  void removeOldest() const;

  safety::FlightRecorder& recorder_;
  std::filesystem::path folder_;
  int keep_;
  safety::FlightRecording recording_;
  bool waiting_ = false;  // recording_ is not on the disk yet
  mutable std::mutex problemLock_;
  Message problem_;
  rt::Wakeup wakeup_;
  std::optional<rt::RealtimeThread> thread_;  // last: joined before what it uses goes
};

}  // namespace stillcut::app
