// FlightLog: writes the flight recordings of a run (every fault, refusal and change of authority) as text files, so
// that what happened can be read afterwards. Thread: one, not the worker; poll() touches the disk only when there is
// something new.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/safety/flight_recorder.h"

namespace stillcut::app {

class FlightLog {
 public:
  // Files go to `folder`, made when the first one comes; the oldest are removed beyond `keep`.
  explicit FlightLog(std::filesystem::path folder, int keep = 200) : folder_(std::move(folder)), keep_(keep) {}

  // Writes what waits. An error leaves the run alone: it is about the disk, not about the machine.
  Status poll(safety::FlightRecorder& recorder);

 private:
  void removeOldest() const;

  std::filesystem::path folder_;
  int keep_;
  safety::FlightRecording recording_;
};

}  // namespace stillcut::app
