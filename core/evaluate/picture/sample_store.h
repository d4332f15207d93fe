// SampleStore: all samples of a recording in SI units, to be looked at from anywhere, whatever the format can be read
// from. They lie in a file without a name that ends with the store, so that memory does not grow with the recording.
// Thread: one adds; any reads what was added before.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"

namespace stillcut::evaluate {

class SampleStore {
 public:
  // Error: no room for a file.
  static Result<std::shared_ptr<SampleStore>> make(int channels);
  ~SampleStore();
  SampleStore(const SampleStore&) = delete;
  SampleStore& operator=(const SampleStore&) = delete;

  // One stretch of each channel, all of the same length.
  Status append(const std::vector<std::span<const float>>& channels);
  int channels() const { return channels_; }
  std::int64_t frames() const { return frames_; }
  // From frame `first` on; not a number where there are no samples. False: the disk does not give them back.
  bool read(int channel, std::int64_t first, std::span<float> out) const;

 private:
  SampleStore(int file, int channels) : file_(file), channels_(channels) {}

  int file_;
  int channels_;
  std::int64_t frames_ = 0;
  std::vector<float> interleaved_;
};

}  // namespace stillcut::evaluate
