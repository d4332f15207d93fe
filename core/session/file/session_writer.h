// SessionWriter: writes one session file (HDF5; layout in resources/manual/files.md) step by step. The file can be read
// while it is written (SWMR). Whatever ends the program or the power, it goes on from the last flush as a whole.
// Thread: one at a time; not real-time (file access, allocation).
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/model/cut_setup.h"
#include "core/model/marker.h"
#include "core/model/step_record.h"
#include "core/storage/disk.h"

namespace stillcut::record {

inline constexpr int kSessionVersion = 7;        // what keeps orders from acting
inline constexpr int kOldestSessionVersion = 2;  // without markers, segments and pyramid

struct SessionHeader {
  CutSetup setup;              // with rate, blockFrames and channels as the source delivers them
  std::string configuration;   // the whole text in force
  std::string programVersion;  // "0.1.0"
  bool simulated = false;
  std::string operatorName = "operator";  // author of the markers touched during the cut
  std::string job{};                      // what was being made; empty: not given
};

struct SessionWriterOptions {
  bool powerSafe = false;  // every flush waits for the disk: what was flushed survives a power loss as well
  bool samples = true;     // false: a history of features; blocks are there, without their samples
  Disk* disk = nullptr;    // null: the system's
  bool replaces = true;    // false: an error where a session, or the journal of one, is under the name already
};

class SessionWriter {
 public:
  // The file appears under its name only when it is complete enough to be read; when it cannot be made, nothing is
  // left.
  static Result<std::unique_ptr<SessionWriter>> create(const std::string& path, const SessionHeader& header,
                                                       const SessionWriterOptions& options = {});
  ~SessionWriter();
  SessionWriter(const SessionWriter&) = delete;
  SessionWriter& operator=(const SessionWriter&) = delete;

  // One step of the worker. Buffers; reaches the file with the next flush, which comes by itself every half second of
  // stream time. After an error nothing more can be written; what was flushed is closed and stays readable.
  Status add(const StepInput& input, const StepOutput& output);
  // What is known of a simulated cut: one number by name, or one value at a time.
  Status addTruth(std::string_view name, double value);
  Status addTruth(std::string_view name, Instant time, double value);
  // Markers of the operator's touches come by themselves, from the inputs of a step; this adds any other. The number
  // is given here.
  Status addMarker(Marker marker);
  // Hands everything to the system.
  Status flush();
  // Many steps at once: until false is said, and flush() after it, nothing waits for the disk, and a crash leaves the
  // file as it was before.
  void commitLater(bool later);
  // From now on every flush waits for the disk.
  void setPowerSafe();
  // Flushes and closes; later calls fail. The destructor does the same and cannot report.
  Status close();
  // False: somebody has deleted or moved the file; what is written goes where nobody looks.
  bool inPlace() const;
  // Somebody has made the file shorter than what was written to it.
  bool cutShort() const;
  const std::string& path() const { return path_; }

 private:
  struct Impl;
  SessionWriter(std::string path, std::unique_ptr<Impl> impl);
  Status failed(const char* doing);
  Status failed(const Error& error);
  void leaveWhole();

  std::string path_;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stillcut::record
