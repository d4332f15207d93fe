#include "tests/support/path_counter.h"

#include <dlfcn.h>
#include <pthread.h>

#include <cerrno>
#include <cstddef>

#include "core/base/sanitized.h"

#if defined(STILLCUT_SANITIZED_ADDRESSES) || defined(STILLCUT_SANITIZED_THREADS)

namespace stillcut::test {
bool PathCounter::works() {
  return false;
}
PathCounter::PathCounter() = default;
PathCounts PathCounter::counts() const {
  return {};
}
}  // namespace stillcut::test

#else

namespace {

// Plain integers in the program's own thread-local block: touching them never allocates.
thread_local stillcut::test::PathCounts threadCounts;

// The function this program's definition hides. dlsym may be asked for it before main; it takes none of these locks.
template <class Function>
Function hidden(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

// The names are the C library's.
// NOLINTBEGIN(readability-identifier-naming,bugprone-reserved-identifier)
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) noexcept {
  ++threadCounts.allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  ++threadCounts.allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  ++threadCounts.allocations;
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  ++threadCounts.allocations;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++threadCounts.allocations;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  ++threadCounts.allocations;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) noexcept {
  if (memory != nullptr) ++threadCounts.releases;
  __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static const auto kReal = hidden<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
  ++threadCounts.locks;
  return kReal(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  static const auto kReal = hidden<int (*)(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  ++threadCounts.locks;
  return kReal(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  static const auto kReal = hidden<int (*)(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  ++threadCounts.locks;
  return kReal(lock);
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming,bugprone-reserved-identifier)

namespace stillcut::test {

bool PathCounter::works() {
  return true;
}
PathCounter::PathCounter() : before_(threadCounts) {}
PathCounts PathCounter::counts() const {
  return {threadCounts.allocations - before_.allocations, threadCounts.releases - before_.releases,
          threadCounts.locks - before_.locks};
}

}  // namespace stillcut::test

#endif
