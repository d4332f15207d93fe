// The entry libFuzzer calls; STILLCUT_FUZZ_TARGET is one of targets().
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const stillcut::fuzz::Target* const kTarget = stillcut::fuzz::findTarget(STILLCUT_FUZZ_TARGET);
  kTarget->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
