// SessionOverview: the picture of any span of a session at once, however long it is: least and greatest of what falls
// into each column, from the stored pyramid; what has not filled a bucket yet, or was recorded by an older version, is
// made up from the samples.
// Thread: one at a time; not real-time (file access). A session still being written is seen as it was when opened.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/record/recording_reader.h"
#include "core/record/session_open.h"
#include "core/record/session_samples.h"
#include "core/record/session_segments.h"

namespace stillcut::record {

class SessionOverview {
 public:
  static Result<std::unique_ptr<SessionOverview>> open(const std::string& path);

  const RecordingFormat& format() const { return format_; }
  Instant begin() const;  // of the first sample
  Instant end() const;    // of the last, and its length
  // `columns` of equal length from `from` to `to`, in the channel's SI unit; NaN in both where nothing was recorded.
  // Where a column is shorter than a sample it shows the sample it lies in.
  Result<std::vector<MinMax>> overview(int channel, Instant from, Instant to, int columns);

 private:
  struct Channel {
    SampleReader samples;
    std::array<FloatTable, kPyramidLevels> levels;
  };
  explicit SessionOverview(std::string path) : path_(std::move(path)) {}
  Status use(OpenedSession opened);
  // Buckets first .. first + count of `level`, -1: the samples themselves. False: damaged.
  bool buckets(Channel& channel, int level, std::uint64_t first, std::uint64_t count, std::vector<MinMax>& out);
  bool samples(Channel& channel, std::uint64_t first, std::uint64_t count, std::vector<MinMax>& out);

  std::string path_;
  std::unique_ptr<JournaledFile> journaled_;
  Hdf5Id file_;
  RecordingFormat format_;
  std::vector<Channel> channels_;
  std::vector<SegmentRow> segments_;
  std::uint64_t frames_ = 0;  // of the shortest channel
};

}  // namespace stillcut::record
