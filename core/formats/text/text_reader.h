// TextReader: CSV and other tables of numbers. open() reads the whole file once, so that a bad cell in the last line is
// known before anything is made of the first; memory stays bounded. Thread: its owner's; not real-time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/formats/recording_reader.h"
#include "core/formats/text/line_reader.h"
#include "core/formats/text/text_layout.h"

namespace stillcut::record {

// One data line: its channels, its time, and what is missing before it.
struct TextRow {
  std::vector<float> values;  // per channel
  double time = 0.0;          // [s], 0 without a time column
  std::int64_t lost = 0;      // frames missing between the row before and this one
};

class TextReader final : public RecordingReader {
 public:
  static Result<std::unique_ptr<RecordingReader>> open(const std::string& path, const ReadOptions& options);

  const RecordingFormat& format() const override { return format_; }
  Result<bool> read(SampleBlock& block) override;

 private:
  TextReader(std::string path, TextLayout layout, TextChannels channels);

  Status scan(const ReadOptions& options);
  Result<double> typicalStep();
  Status settleRate(const ReadOptions& options, double evenTime, std::int64_t evenSteps);
  Status rewind();
  Result<bool> nextRow();
  Status parseRow();
  Result<double> numberIn(int column) const;
  // Frames missing between two neighbouring rows; an error when time stands still or runs back.
  Result<std::int64_t> missingBetween(double before, double after) const;

  std::string path_;
  TextLayout layout_;
  TextChannels channels_;
  RecordingFormat format_;
  bool timed_ = false;  // gaps are looked for
  double step_ = 0.0;   // typical time between rows [s]; 0 until it is known

  std::unique_ptr<LineReader> lines_;
  std::vector<std::string_view> cells_;
  TextRow row_;
  std::int64_t rows_ = 0;     // read since rewind()
  bool havePending_ = false;  // row_ belongs to the next block
  std::int64_t lostTotal_ = 0;
  std::int64_t framesRead_ = 0;
  std::uint64_t sequence_ = 0;
};

}  // namespace stillcut::record
