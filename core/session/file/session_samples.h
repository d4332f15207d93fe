// One channel's samples of a session file: appended with their min/max pyramid, and read through a window so that many
// small blocks cost few reads.
// The pyramid has kPyramidLevels levels; a bucket of level k holds the least and the greatest of kPyramidBase *
// kPyramidFactor^k frames in a row. Only full buckets are stored; what the last frames have not filled is made up from
// the level below, and in the end from the samples. Thread: its owner's; not real-time.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/model/channel.h"
#include "core/session/file/min_max.h"
#include "core/storage/float_table.h"

namespace stillcut::record {

inline constexpr int kPyramidLevels = 4;
inline constexpr std::uint64_t kPyramidBase = 256;
inline constexpr std::uint64_t kPyramidFactor = 16;

// Frames in a bucket of `level`: 256, 4096, 65536, 1048576.
constexpr std::uint64_t bucketFrames(int level) {
  std::uint64_t frames = kPyramidBase;
  for (int k = 0; k < level; ++k) frames *= kPyramidFactor;
  return frames;
}
// "pyramid/00/256"
std::string pyramidPath(int channel, int level);

// The extremes of a growing number of parts. A sample that is no number counts only while there is no other.
class Extremes {
 public:
  void add(MinMax part) {
    if (!(value_.min <= part.min)) value_.min = part.min == part.min ? part.min : value_.min;
    if (!(value_.max >= part.max)) value_.max = part.max == part.max ? part.max : value_.max;
  }
  void clear() { *this = Extremes(); }
  const MinMax& value() const { return value_; }

 private:
  static constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
  MinMax value_{kNothing, kNothing};
};

class SampleWriter {
 public:
  bool create(hid_t file, int channel, const ChannelInfo& info);
  void add(std::span<const float> samples);
  std::size_t pending() const { return pending_.size(); }
  bool write();  // what was added, and flushes it
  void close();

 private:
  struct Level {
    FloatTable table;
    std::vector<float> pending;  // min, max, min, max ...
    Extremes open;
    std::uint64_t filled = 0;  // parts of the open bucket: samples, or buckets below
  };
  void put(int level, MinMax part);

  FloatTable samples_;
  std::vector<float> pending_;
  std::array<Level, kPyramidLevels> levels_;
};

class SampleReader {
 public:
  bool open(hid_t file, int channel);
  std::uint64_t frames() const { return samples_.rows(); }
  // Copies frames first .. first + out.size(); false: damaged, or beyond the end.
  bool read(std::uint64_t first, std::span<float> out);

 private:
  FloatTable samples_;
  std::uint64_t windowFirst_ = 0;
  std::vector<float> window_;
};

}  // namespace stillcut::record
