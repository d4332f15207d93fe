// SessionWriter: writes one session file (HDF5; layout in resources/manual/recordings.md) step by step. The file can be
// read while it is written (SWMR), and after a crash up to the last flush.
// Thread: one at a time; not real-time (file access, allocation).
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/model/cut_setup.h"
#include "core/model/step_record.h"

namespace stillcut::record {

inline constexpr int kSessionVersion = 2;

struct SessionHeader {
  CutSetup setup;              // with rate, blockFrames and channels as the source delivers them
  std::string configuration;   // the whole text in force
  std::string programVersion;  // "0.1.0"
  bool simulated = false;
};

class SessionWriter {
 public:
  // The file appears under its name only when it is complete enough to be read; when it cannot be made, nothing is
  // left.
  static Result<std::unique_ptr<SessionWriter>> create(const std::string& path, const SessionHeader& header);
  ~SessionWriter();
  SessionWriter(const SessionWriter&) = delete;
  SessionWriter& operator=(const SessionWriter&) = delete;

  // One step of the worker. Buffers; reaches the file with the next flush, which comes by itself every half second of
  // stream time. After an error nothing more can be written; what was flushed stays readable.
  Status add(const StepInput& input, const StepOutput& output);
  // What is known of a simulated cut: one number by name, or one value at a time.
  Status addTruth(std::string_view name, double value);
  Status addTruth(std::string_view name, Instant time, double value);
  // Hands everything to the system; `toDisk` also waits until it survives a power loss.
  Status flush(bool toDisk = false);
  // Flushes and closes; later calls fail. The destructor does the same and cannot report.
  Status close();
  const std::string& path() const { return path_; }

 private:
  struct Impl;
  SessionWriter(std::string path, std::unique_ptr<Impl> impl);
  Status failed(const char* doing);

  std::string path_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stillcut::record
