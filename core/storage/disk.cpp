#include "core/storage/disk.h"

#include <unistd.h>

#include <cerrno>

namespace stillcut::record {

bool Disk::write(int file, std::uint64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    offset += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return true;
}

bool Disk::sync(int file) {
  return fdatasync(file) == 0;
}

Disk& systemDisk() {
  static Disk disk;
  return disk;
}

}  // namespace stillcut::record
