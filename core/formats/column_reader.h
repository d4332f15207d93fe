// ColumnReader: a recording whose channels lie one after the other in the file (universal files, MATLAB, HDF5), read as
// blocks. The format gives one Column a channel; everything else is the same for all of them.
// Thread: its owner's; not real-time.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

// The numbers of one channel, front to back, in the file's unit.
class Column {
 public:
  virtual ~Column() = default;
  // Fills all of `out` with the next numbers. Error: one line; the file ends early or is damaged.
  virtual Status read(std::span<double> out) = 0;
  // From here on whole numbers are given from the first of the column on: nanoseconds since 1970 have more digits than
  // a double. To be called before the first read; columns that hold no such numbers need not heed it.
  virtual void countFromFirst() {}
};

// A channel that could be read, opened only when it is wanted.
struct ColumnChannel {
  RecordedChannel channel;
  std::function<Result<std::unique_ptr<Column>>()> open;
};

// `format` has kind, rate and frames; its channels are made from `all` and the options. Channels of spindle speed are
// left out as in text files: only when asked for, or when there is nothing else.
Result<std::unique_ptr<RecordingReader>> openColumns(const std::string& path, RecordingFormat format,
                                                     std::vector<ColumnChannel> all, const ReadOptions& options);

// Quantity, scale and axis from what a file says about a channel; empty text: not said.
RecordedChannel channelFromWords(const std::string& name, const std::string& unit);

// A rate known only to this relative error, and no nearer to it than a whole number, is that whole number.
double wholeRate(double rate, double relative);

}  // namespace stillcut::record
