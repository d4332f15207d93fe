// How often this test program has called operator new. The real-time functions must not add to it.
#pragma once

namespace stillcut::safety::testing {
long allocationCount();
}
