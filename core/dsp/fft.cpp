#include "core/dsp/fft.h"

#include <fftw3.h>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <string>

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

struct RealFft::Plan {
  explicit Plan(int n)
      : size(n),
        in(fftw_alloc_real(static_cast<std::size_t>(n))),
        out(reinterpret_cast<std::complex<double>*>(fftw_alloc_complex(static_cast<std::size_t>(n / 2 + 1)))) {
    const std::lock_guard lock(plannerMutex());
    plan = fftw_plan_dft_r2c_1d(n, in.get(), reinterpret_cast<fftw_complex*>(out.get()),
                                FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
    std::fill_n(in.get(), n, 0.0);
  }
  ~Plan() {
    const std::lock_guard lock(plannerMutex());
    fftw_destroy_plan(plan);
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  int size;
  std::unique_ptr<double, FftwFree> in;
  std::unique_ptr<std::complex<double>, FftwFree> out;
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
  if (size < 2 || !hasSmallPrimesOnly(size)) {
    throw std::runtime_error("FFT size " + std::to_string(size) + " has a prime factor above 7 or is below 2");
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
  fftw_execute(plan_->plan);
  return {plan_->out.get(), static_cast<std::size_t>(plan_->size / 2 + 1)};
}

}  // namespace stillcut::dsp
