// Disk: the few system calls through which a recording reaches the disk, so that tests can put a full, a slow or a
// dying one in their place. Thread: the writing one. Not real-time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace stillcut::record {

class Disk {
 public:
  virtual ~Disk() = default;
  // All of it at `offset`; false: errno says why.
  virtual bool write(int file, std::uint64_t offset, std::span<const std::byte> bytes);
  // What was written survives a power loss once this has returned true.
  virtual bool sync(int file);
};

// The system's own.
Disk& systemDisk();

}  // namespace stillcut::record
