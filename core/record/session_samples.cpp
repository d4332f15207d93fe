#include "core/record/session_samples.h"

#include <algorithm>

#include "core/record/session_layout.h"

namespace stillcut::record {

bool SampleReader::open(hid_t file, int channel) {
  dataset_ = Hdf5Id(H5Dopen2(file, samplesPath(channel).c_str(), H5P_DEFAULT));
  if (!dataset_) return false;
  const std::optional<std::uint64_t> length = lengthOf(dataset_.get());
  frames_ = length.value_or(0);
  return length.has_value();
}

bool SampleReader::read(std::uint64_t first, std::span<float> out) {
  if (first > frames_ || out.size() > frames_ - first) return false;
  const bool inside = first >= windowFirst_ && first + out.size() <= windowFirst_ + window_.size();
  if (!inside) {
    const std::uint64_t size = std::min(std::max<std::uint64_t>(out.size(), 4 * kSampleChunk), frames_ - first);
    window_.resize(size);
    windowFirst_ = first;
    const hsize_t start = first;
    const hsize_t count = size;
    const Hdf5Id file(H5Dget_space(dataset_.get()));
    const Hdf5Id memory(H5Screate_simple(1, &count, nullptr));
    if (H5Sselect_hyperslab(file.get(), H5S_SELECT_SET, &start, nullptr, &count, nullptr) < 0 ||
        H5Dread(dataset_.get(), H5T_NATIVE_FLOAT, memory.get(), file.get(), H5P_DEFAULT, window_.data()) < 0) {
      window_.clear();
      return false;
    }
  }
  std::copy_n(window_.begin() + static_cast<std::ptrdiff_t>(first - windowFirst_), out.size(), out.begin());
  return true;
}

}  // namespace stillcut::record
