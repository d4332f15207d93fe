// HDF5 itself forgets some memory when it refuses a damaged file: the address sanitizer's leak check leaves it out. A
// source of every test program that links test_record; from a library the linker would not take it.
#include "core/base/sanitized.h"

#if defined(STILLCUT_SANITIZED_ADDRESSES)
// The name is the sanitizer's.
// NOLINTNEXTLINE(readability-identifier-naming,bugprone-reserved-identifier)
extern "C" const char* __lsan_default_suppressions();
extern "C" const char*
__lsan_default_suppressions() {  // NOLINT(readability-identifier-naming,bugprone-reserved-identifier)
  return "leak:libhdf5";
}
#endif
