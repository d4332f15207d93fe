// PathCounter: how often the current thread asked for memory, gave memory back or took a lock while the counter lived.
// The sample path must show 0 of each. A throw counts as well: an exception's memory is asked for.
//
// Memory: malloc, calloc, realloc, aligned_alloc, memalign, posix_memalign and free are interposed for the whole test
// program, operator new and delete end there. Locks: pthread mutexes and read-write locks, and thereby std::mutex.
// Sanitizers bring their own; there works() is false and tests that count skip themselves.
// Thread: counts the thread that made it; counters may be nested.
#pragma once

#include <cstdint>

namespace stillcut::test {

struct PathCounts {
  std::uint64_t allocations = 0;
  std::uint64_t releases = 0;
  std::uint64_t locks = 0;
  bool none() const { return allocations == 0 && releases == 0 && locks == 0; }
};

class PathCounter {
 public:
  static bool works();

  PathCounter();
  PathCounts counts() const;  // since construction

 private:
  PathCounts before_;
};

}  // namespace stillcut::test
