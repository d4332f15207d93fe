// NoiseSource: reproducible random numbers for the simulation; the same on every compiler, unlike std distributions.
// xoshiro256++ (Blackman and Vigna) seeded through splitmix64; normal deviates by the polar method.
// Thread: one. Real-time safe.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace stillcut::milling {

class NoiseSource {
 public:
  explicit NoiseSource(std::uint64_t seed) noexcept {
    for (std::uint64_t& s : state_) {
      seed += 0x9e3779b97f4a7c15U;
      std::uint64_t z = seed;
      z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
      z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
      s = z ^ (z >> 31U);
    }
  }
  // [0, 1)
  double uniform() noexcept { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
  // Mean 0, variance 1.
  double normal() noexcept {
    if (hasSpare_) {
      hasSpare_ = false;
      return spare_;
    }
    double a = 0.0, b = 0.0, r = 0.0;
    do {
      a = 2.0 * uniform() - 1.0;
      b = 2.0 * uniform() - 1.0;
      r = a * a + b * b;
    } while (r >= 1.0 || r == 0.0);
    const double scale = std::sqrt(-2.0 * std::log(r) / r);
    spare_ = b * scale;
    hasSpare_ = true;
    return a * scale;
  }

 private:
  std::uint64_t next() noexcept {
    auto& s = state_;
    const std::uint64_t result = std::rotl(s[0] + s[3], 23) + s[0];
    const std::uint64_t t = s[1] << 17U;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = std::rotl(s[3], 45);
    return result;
  }

  std::array<std::uint64_t, 4> state_{};
  double spare_ = 0.0;
  bool hasSpare_ = false;
};

}  // namespace stillcut::milling
