// SessionReader: reads a session file step by step, also while it is being written and after a crash: up to the last
// step of which everything is there. And the repair of a crashed file. Thread: one at a time.
// The HDF5 library dies of some damaged files. Everything here is therefore done by a process of its own, which may
// die; what is in the namespace `here` does the work in the process that calls it: that one, or a writer of its own
// file.
#pragma once

#include <memory>
#include <string>

#include "core/formats/recording_reader.h"
#include "core/model/marker.h"

namespace stillcut::record {

// The signature of an HDF5 file at its first byte.
bool isHdf5File(const std::string& path);

// Clears the marks that a writer leaves when it is killed, as h5clear -s does, so that h5py and MATLAB open the file.
// True: something was repaired; false: there was nothing to do. What is no session, or cut short, is left as it is.
Result<bool> repairSession(const std::string& path);

// How much of what a session holds, for `info`.
struct SessionCounts {
  std::uint64_t steps = 0;
  std::uint64_t gaps = 0;
  std::uint64_t inputs = 0;
  std::uint64_t verdicts = 0;
  std::uint64_t commands = 0;
  std::uint64_t events = 0;
  std::vector<Marker> markers;
  Instant begin{};                                          // of the first sample
  Instant end{};                                            // of the last step
  std::vector<Event> firstEvents;                           // at most a hundred
  std::vector<std::pair<std::string, double>> truthValues;  // simulated cuts
};
Result<SessionCounts> countSession(const std::string& path);

struct RecordedTruthSample {
  std::string name;
  Instant time{};
  double value = 0.0;
};
Result<std::vector<RecordedTruthSample>> readTruthSeries(const std::string& path);

namespace here {

// Every read() also yields recordedStep(). With ReadOptions::channels the step's block holds only those.
Result<std::unique_ptr<RecordingReader>> openSession(const std::string& path, const ReadOptions& options = {});
Result<bool> repairSession(const std::string& path);
Result<SessionCounts> countSession(const std::string& path);
Result<std::vector<RecordedTruthSample>> readTruthSeries(const std::string& path);

}  // namespace here
}  // namespace stillcut::record
