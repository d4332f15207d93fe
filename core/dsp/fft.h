// Real FFT plans as values that own them (FFTW, double). Plan in prepare(); executing allocates nothing as long as the
// size is even and has only the primes 2, 3, 5, 7, which prepare() insists on (FFTW allocates at run time for large
// primes; counted over all the sizes allowed up to 140000: not for one of them).
// Thread: prepare() on any thread (the planner is guarded); forward() on one thread at a time per object.
#pragma once

#include <complex>
#include <memory>
#include <span>

namespace stillcut::dsp {

// Smallest even size >= n whose only prime factors are 2, 3, 5 and 7.
int goodFftSize(int n);
// The same for a transform that may be padded: a multiple of 32 with no more than one factor 3. FFTW's estimated plans
// take up to twice as long a point for sizes rich in threes and poor in twos (measured: 2.1 ns at 2916, 1.2 at 3136).
int fastFftSize(int n);

class RealFft {
 public:
  RealFft();
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  // Throws std::runtime_error for a size that is odd, < 2 or has a prime factor above 7.
  void prepare(int size);
  int size() const;
  int bins() const { return size() / 2 + 1; }

  // Input of the next forward(): size() doubles, 0 at first, to be filled by the caller. forward() leaves it as it is.
  std::span<double> input() noexcept;
  // Unnormalised X[k] = sum x[n] exp(-2 pi i k n / size), k = 0 .. size/2; valid until the next call. Real-time.
  std::span<const std::complex<double>> forward() noexcept;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace stillcut::dsp
