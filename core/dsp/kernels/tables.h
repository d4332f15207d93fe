// The tables that choose.cpp chooses from, one per instruction set the program was built with. Constant: any thread.
#pragma once

#include "core/dsp/kernels/kernels.h"

namespace stillcut::dsp::kernels {
namespace baseline {
void fill(Kernels& k) noexcept;
}
namespace avx2 {
void fill(Kernels& k) noexcept;
}
namespace avx512 {
void fill(Kernels& k) noexcept;
}
}  // namespace stillcut::dsp::kernels
