// The little of HDF5's C interface that session files need, with ownership and one-line errors.
// Thread: the library is built thread-safe (one lock inside); an object belongs to one thread at a time.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.h"

namespace stillcut::record {

// Owns one HDF5 identifier of any kind.
class Hdf5Id {
 public:
  Hdf5Id() = default;
  explicit Hdf5Id(hid_t id) : id_(id) {}
  ~Hdf5Id() { reset(); }
  Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Hdf5Id& operator=(Hdf5Id&& other) noexcept {
    if (this != &other) {
      reset();
      id_ = std::exchange(other.id_, H5I_INVALID_HID);
    }
    return *this;
  }
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;

  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }
  // False: closing failed, which for a file means that not everything reached the disk.
  bool reset();

 private:
  hid_t id_ = H5I_INVALID_HID;
};

// Keeps the library from printing on this thread; errors are returned instead. Cheap when called again.
void quietHdf5();
// What the library says was the innermost cause of the last failure on this thread.
Message hdf5Cause();

// Scalar attributes on a file, group or dataset.
bool writeText(hid_t object, const char* name, const std::string& text);
bool writeNumber(hid_t object, const char* name, double value);
bool writeInteger(hid_t object, const char* name, std::int64_t value);
std::optional<std::string> readText(hid_t object, const char* name);
std::optional<double> readNumber(hid_t object, const char* name);
std::optional<std::int64_t> readInteger(hid_t object, const char* name);

// Length of a one-dimensional dataset; nothing when it is not one.
std::optional<std::uint64_t> lengthOf(hid_t dataset);

}  // namespace stillcut::record
