// Files of named arrays (MATLAB, HDF5): which array is a channel, which one the rate, which one the time.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/formats/column_reader.h"

namespace stillcut::record {

// One numeric array: one channel, or several side by side.
struct FileArray {
  std::string name;
  std::int64_t frames = 0;           // the longer side
  int columns = 1;                   // the shorter side
  std::string unit, quantity, axis;  // empty: not said
  std::optional<double> scale;       // SI units per unit of the file, where the file says so
  ChannelInfo sensor;                // what is told of it, see sensor_notes.h
  std::function<Result<std::unique_ptr<Column>>(int column)> open;
};

struct FileContents {
  std::string path;
  std::string kind;
  std::vector<FileArray> arrays;
  std::vector<std::pair<std::string, double>> numbers;     // single numbers by name: "fs", "dt"
  std::vector<std::pair<std::string, std::string>> texts;  // "SampleRate": "10000 Hz"
  std::vector<std::string> skipped;                        // neither
  std::vector<Message> notes;                              // for RecordingFormat::notes
  std::int64_t started_ns = 0;                             // for RecordingFormat::started_ns
};

// Whether a number or a text of this name is a sampling rate or the time between samples.
bool namesRate(std::string_view name);
// The first rate that they tell [Hz].
std::optional<double> statedRate(const std::vector<std::pair<std::string, double>>& numbers,
                                 const std::vector<std::pair<std::string, std::string>>& texts);

// The length at which most numbers lie is that of the recording; others are skipped. The rate comes from the
// options, from a number (rate_hz, fs, sample_rate ... in Hz; dt, ts ... in s), from an array named time or t, whose
// unit may be in its name, or from the first column of an array of several where it grows evenly in steps below a
// second, as only time does.
Result<std::unique_ptr<RecordingReader>> openArrays(FileContents contents, const ReadOptions& options);

// Text of a file made fit for one line: UTF-8 whatever it was, control characters become '?', at most 80 bytes.
std::string cleanName(std::string_view text);

}  // namespace stillcut::record
