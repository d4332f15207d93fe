// What a LabVIEW TDMS file holds and where its numbers lie, from its segments' headers alone. Layout: "TDMS File Format
// Internal Structure", National Instruments.
// Pure but for the file; set-up, not real-time.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace stillcut::record {

// Data types of the format that are numbers or times.
enum class TdmsType : std::uint32_t {
  I8 = 1,
  I16 = 2,
  I32 = 3,
  I64 = 4,
  U8 = 5,
  U16 = 6,
  U32 = 7,
  U64 = 8,
  Single = 9,
  Double = 10,
  SingleWithUnit = 0x19,
  DoubleWithUnit = 0x1A,
  Text = 0x20,
  Boolean = 0x21,
  TimeStamp = 0x44,
};
// Bytes of one value; 0: none of a fixed size that is read.
std::size_t sizeOf(TdmsType type);
// The number that so many bits are.
double tdmsNumber(std::uint64_t bits, TdmsType type);

// A run of a channel's values.
struct TdmsRun {
  std::uint64_t from = 0;    // [bytes] of the first value in the file
  std::uint64_t count = 0;   // values
  std::uint64_t stride = 0;  // [bytes] from one to the next
  bool bigEndian = false;
};

// ns since 1970 UTC of seconds since 1904 and so many 2^-64 of one; empty: centuries off.
std::optional<std::int64_t> tdmsTime(std::int64_t seconds, std::uint64_t fraction);

struct TdmsChannel {
  std::string group, name;
  TdmsType type = TdmsType::Double;
  std::vector<TdmsRun> runs;
  std::uint64_t values = 0;
  std::map<std::string, std::string> texts;
  std::map<std::string, double> numbers;
  std::int64_t started_ns = 0;  // wf_start_time, since 1970 UTC; 0: not said
};

struct TdmsIndex {
  std::vector<TdmsChannel> channels;  // with values, in the order of the file
  std::vector<TdmsChannel> above;     // the groups, then the file: what is told of all in them
  std::int64_t started_ns = 0;        // of the file
  bool cut = false;                   // its last segment was not finished
};

Result<TdmsIndex> readTdmsIndex(const std::string& path);

}  // namespace stillcut::record
