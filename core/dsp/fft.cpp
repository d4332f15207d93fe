#include "core/dsp/fft.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/dsp/kernels/choose.h"

namespace stillcut::dsp {
namespace {

// FFTW's planner keeps global tables; only execution is free of them.
std::mutex& plannerMutex() {
  static std::mutex mutex;
  return mutex;
}

bool hasSmallPrimesOnly(int n) {
  for (int p : {2, 3, 5, 7}) {
    while (n % p == 0) n /= p;
  }
  return n == 1;
}

struct FftwFree {
  void operator()(void* p) const { fftw_free(p); }
};

}  // namespace

// A complex transform of half the size and one pass over it: a fifth less than FFTW's own real ones take.
struct RealFft::Plan {
  explicit Plan(int n)
      : size(n),
        half(static_cast<std::size_t>(n / 2)),
        in(fftw_alloc_real(2 * half)),
        folded(fftw_alloc_real(2 * half)),
        out(reinterpret_cast<std::complex<double>*>(fftw_alloc_complex(half + 1))),
        rotationRe(half / 2 + 1 + kernels::kLanes),
        rotationIm(rotationRe.size()) {
    const std::lock_guard lock(plannerMutex());
    plan = fftw_plan_dft_1d(n / 2, reinterpret_cast<fftw_complex*>(in.get()),
                            reinterpret_cast<fftw_complex*>(folded.get()), FFTW_FORWARD,
                            FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
    std::fill_n(in.get(), n, 0.0);
    for (std::size_t k = 0; k < rotationRe.size(); ++k) {
      const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(half);
      rotationRe[k] = 0.5 * std::cos(angle);
      rotationIm[k] = -0.5 * std::sin(angle);
    }
  }
  ~Plan() {
    const std::lock_guard lock(plannerMutex());
    fftw_destroy_plan(plan);
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  int size;
  std::size_t half;
  kernels::Kernels kernels = kernels::bestKernels();
  std::unique_ptr<double, FftwFree> in;
  std::unique_ptr<double, FftwFree> folded;
  std::unique_ptr<std::complex<double>, FftwFree> out;
  std::vector<double> rotationRe, rotationIm;
  fftw_plan plan = nullptr;
};

int goodFftSize(int n) {
  int size = std::max(n, 2);
  size += size % 2;
  while (!hasSmallPrimesOnly(size)) size += 2;
  return size;
}

int fastFftSize(int n) {
  if (n <= 32) return goodFftSize(n);
  int size = (n + 31) / 32 * 32;
  while (!hasSmallPrimesOnly(size) || size % 9 == 0) size += 32;
  return size;
}

RealFft::RealFft() = default;
RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

void RealFft::prepare(int size) {
  if (size < 2 || size % 2 != 0 || !hasSmallPrimesOnly(size)) {
    throw std::runtime_error("FFT size " + std::to_string(size) + " is odd or has a prime factor above 7");
  }
  plan_ = std::make_unique<Plan>(size);
}

int RealFft::size() const {
  return plan_ ? plan_->size : 0;
}

std::span<double> RealFft::input() noexcept {
  return {plan_->in.get(), static_cast<std::size_t>(plan_->size)};
}

std::span<const std::complex<double>> RealFft::forward() noexcept {
  Plan& p = *plan_;
  fftw_execute(p.plan);
  p.kernels.unfold(
      {p.folded.get(), p.rotationRe.data(), p.rotationIm.data(), p.half, reinterpret_cast<double*>(p.out.get())});
  return {p.out.get(), p.half + 1};
}

}  // namespace stillcut::dsp
