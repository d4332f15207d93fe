#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

using Two [[gnu::vector_size(16)]] = double;  // one of each signal
constexpr std::size_t kNumbers = 5;           // of a section

// States and coefficients in registers, as far as there are enough.
template <std::size_t kSections>
STILLCUT_INLINE void sections(const CascadeRun& run, std::size_t from, const double* const* in) {
  Two c[kSections][kNumbers];
  Two z[kSections][2];
  for (std::size_t s = 0; s < kSections; ++s) {
    for (std::size_t i = 0; i < kNumbers; ++i) {
      const std::size_t at = kNumbers * (from + s) + i;
      c[s][i] = Two{run.coefficients[0][at], run.coefficients[1][at]};
    }
    for (std::size_t i = 0; i < 2; ++i) {
      z[s][i] = Two{run.state[0][2 * (from + s) + i], run.state[1][2 * (from + s) + i]};
    }
  }
  for (std::size_t k = 0; k < run.frames; ++k) {
    Two x{in[0][k], in[1][k]};
    for (std::size_t s = 0; s < kSections; ++s) {
      const Two y = c[s][0] * x + z[s][0];
      z[s][0] = c[s][1] * x - c[s][3] * y + z[s][1];
      z[s][1] = c[s][2] * x - c[s][4] * y;
      x = y;
    }
    run.out[0][k] = x[0];
    run.out[1][k] = x[1];
  }
  for (std::size_t s = 0; s < kSections; ++s) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t n = 0; n < 2; ++n) run.state[n][2 * (from + s) + i] = z[s][i][n];
    }
  }
}

}  // namespace

void cascade(const CascadeRun& run) noexcept {
  const double* const done[2] = {run.out[0], run.out[1]};
  const double* const* in = run.in;
  std::size_t s = 0;
  while (s < run.sections) {
    switch (run.sections - s) {
      case 1:
        sections<1>(run, s, in);
        return;
      case 2:
        sections<2>(run, s, in);
        return;
      case 3:
        sections<3>(run, s, in);
        return;
      case 4:
        sections<4>(run, s, in);
        return;
      default:
        sections<5>(run, s, in);
        s += 5;
        in = done;
    }
  }
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
