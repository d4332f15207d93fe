// FloatTable: a growing dataset of 32-bit floats in a session file: one column (samples) or rows of a few (pyramid).
// Thread: one at a time.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/storage/hdf5_file.h"

namespace stillcut::record {

class FloatTable {
 public:
  // With one column the dataset has one dimension, else two. False: hdf5Cause() says why.
  bool create(hid_t file, const std::string& path, std::uint64_t columns, std::uint64_t chunkRows);
  bool open(hid_t file, const std::string& path, std::uint64_t columns);
  std::uint64_t rows() const { return rows_; }
  hid_t dataset() const { return dataset_.get(); }
  // Rows one after the other.
  bool append(std::span<const float> values);
  bool read(std::uint64_t firstRow, std::span<float> values) const;
  bool flush() { return H5Dflush(dataset_.get()) >= 0; }
  void close() { dataset_.reset(); }

 private:
  int dimensions() const { return columns_ > 1 ? 2 : 1; }

  Hdf5Id dataset_;
  std::uint64_t columns_ = 1;
  std::uint64_t rows_ = 0;
};

}  // namespace stillcut::record
