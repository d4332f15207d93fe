// TextReader: CSV and other tables of numbers. open() reads the whole file once, so that all that is missing, damaged
// or left out in it is known before anything is made of the first row; memory stays bounded.
// Thread: its owner's; not real-time.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/formats/recording_reader.h"
#include "core/formats/text/text_layout.h"
#include "core/formats/text/text_rows.h"

namespace stillcut::record {

class TextReader final : public RecordingReader {
 public:
  // A table of text; of a spreadsheet "FILE:/SHEET" is one of its sheets. `notes` are told with those of the file.
  static Result<std::unique_ptr<RecordingReader>> open(const std::string& path, const ReadOptions& options,
                                                       std::vector<Message> notes = {});
  // Whether it has rows of numbers, by its first lines.
  static bool holdsTable(const std::string& path);

  const RecordingFormat& format() const override { return format_; }
  Result<bool> read(SampleBlock& block) override;

 private:
  TextReader(std::string path, TextLayout layout, TextChannels channels);

  Status scan(const ReadOptions& options);
  Status checkTime(const ReadOptions& options);
  Status findStep();
  void takeHeaderRate();
  Status pass();
  // Columns that end early or are mostly empty; true: something has changed, and the rows are to be read again.
  bool settleColumns();
  void leaveOut(const std::vector<bool>& out);
  Status checkBadRows();
  Status settleRate(const ReadOptions& options);
  void makeNotes();

  std::string path_;
  TextLayout layout_;
  TextChannels channels_;
  RecordingFormat format_;
  bool timed_ = false;     // gaps are looked for
  bool coarse_ = false;    // so many rows share a time that those cannot part them
  double step_ = 0.0;      // typical time between rows [s]; 0 until it is known
  double evenTime_ = 0.0;  // over all steps without a gap [s]
  std::int64_t evenSteps_ = 0;
  std::int64_t end_ = 0;  // rows; 0: all

  std::unique_ptr<TextRows> rows_;
  bool havePending_ = false;  // the row at hand belongs to the next block
  std::int64_t lostTotal_ = 0;
  std::int64_t framesRead_ = 0;
  std::uint64_t sequence_ = 0;
};

}  // namespace stillcut::record
