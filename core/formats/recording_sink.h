// RecordingSink: a recording being written to a file of some format, block by block, in SI units. The file appears
// under its name only with finish(); a sink that is destroyed without it leaves nothing behind. Thread: one at a time,
// not real-time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/formats/gap_list.h"
#include "core/formats/recording_reader.h"

namespace stillcut::record {

// What is known of a recording before the first block is written.
struct ExportPlan {
  std::vector<RecordedChannel> channels;
  Hertz rate{};
  Instant begin{};  // first sample of the whole recording, on the clock of its samples
  // Found by reading the recording once; only where sinkNeedsLook() says so.
  std::int64_t frames = 0;    // with gaps filled
  std::vector<double> peaks;  // largest magnitude of every channel [SI units]
  std::vector<FilledGap> gaps;
};

class RecordingSink {
 public:
  virtual ~RecordingSink() = default;
  // Samples as read: the channel's scale is applied here.
  virtual Status write(const SampleBlock& block) = 0;
  // After the last block: the file appears under its name. An error leaves none.
  virtual Status finish() = 0;
};

// By the suffix of `path`: .wav .flac .csv .mat .uff .unv .h5 .hdf5. An error names the suffixes there are.
Result<std::unique_ptr<RecordingSink>> createSink(const std::string& path, const ExportPlan& plan);
bool sinkNeedsLook(const std::string& path);  // frames, peaks and gaps must be known

// What becomes of a gap: the times jump; or it is filled with what is no number, or, where a format has no such thing,
// with zeros and a list beside the file (gap_list.h).
enum class GapStyle : std::uint8_t { Times, NotANumber, Listed };
GapStyle sinkGapStyle(const std::string& path);

// The sinks by themselves.
Result<std::unique_ptr<RecordingSink>> createCsvSink(const std::string& path, const ExportPlan& plan);
Result<std::unique_ptr<RecordingSink>> createSoundSink(const std::string& path, const ExportPlan& plan);
Result<std::unique_ptr<RecordingSink>> createMatSink(const std::string& path, const ExportPlan& plan);
Result<std::unique_ptr<RecordingSink>> createUffSink(const std::string& path, const ExportPlan& plan);
Result<std::unique_ptr<RecordingSink>> createHdf5Sink(const std::string& path, const ExportPlan& plan);

// The unit of a channel in SI; empty where nobody has calibrated it.
std::string exportUnit(const RecordedChannel& channel);
// The same for formats that know ASCII only: "m/s^2".
std::string plainUnit(const RecordedChannel& channel);

}  // namespace stillcut::record
