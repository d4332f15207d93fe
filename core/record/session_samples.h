// One channel's samples of a session file, read through a window so that many small blocks cost few reads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/record/hdf5_file.h"

namespace stillcut::record {

class SampleReader {
 public:
  bool open(hid_t file, int channel);
  std::uint64_t frames() const { return frames_; }
  // Copies frames first .. first + out.size(); false: damaged, or beyond the end.
  bool read(std::uint64_t first, std::span<float> out);

 private:
  Hdf5Id dataset_;
  std::uint64_t frames_ = 0;
  std::uint64_t windowFirst_ = 0;
  std::vector<float> window_;
};

}  // namespace stillcut::record
