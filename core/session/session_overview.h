// SessionOverview: the picture of any span of a session at once, however long it is: least and greatest of what falls
// into each column, from the stored pyramid; what has not filled a bucket yet, or was recorded by an older version, is
// made up from the samples.
// Thread: one at a time; not real-time (file access). A session still being written is seen as it was when opened.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/formats/recording_reader.h"
#include "core/session/file/min_max.h"

namespace stillcut::record {

class SessionOverview {
 public:
  static Result<std::unique_ptr<SessionOverview>> open(const std::string& path);

  ~SessionOverview();
  SessionOverview(const SessionOverview&) = delete;
  SessionOverview& operator=(const SessionOverview&) = delete;

  const RecordingFormat& format() const;
  Instant begin() const;  // of the first sample
  Instant end() const;    // of the last, and its length
  // `columns` of equal length from `from` to `to`, in the channel's SI unit; NaN in both where nothing was recorded.
  // Where a column is shorter than a sample it shows the sample it lies in.
  Result<std::vector<MinMax>> overview(int channel, Instant from, Instant to, int columns);

 private:
  struct Impl;
  explicit SessionOverview(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace stillcut::record
