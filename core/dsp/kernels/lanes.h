// Lanes: eight doubles, as however many vector registers the instruction set of this file needs for them. Every
// operation is done lane by lane, so the set decides the speed and not the result.
// Only for the files of this folder that are compiled once per set; see kernels.h for their rules.
// Real-time, any thread.
#pragma once

#include <cstddef>

#include "core/dsp/kernels/kernels.h"

#if defined(__AVX512F__)
#define STILLCUT_SET avx512
#define STILLCUT_NATIVE 8
#elif defined(__AVX2__)
#define STILLCUT_SET avx2
#define STILLCUT_NATIVE 4
#else
#define STILLCUT_SET baseline
#define STILLCUT_NATIVE 2
#endif
#define STILLCUT_INLINE [[gnu::always_inline]] static inline

namespace stillcut::dsp::kernels::STILLCUT_SET {

inline constexpr std::size_t kNative = STILLCUT_NATIVE;
inline constexpr std::size_t kParts = kLanes / kNative;

// One register, and the same in memory at any address.
using Native [[gnu::vector_size(8 * STILLCUT_NATIVE)]] = double;
using Unaligned [[gnu::vector_size(8 * STILLCUT_NATIVE), gnu::aligned(8), gnu::may_alias]] = double;
using Choice = decltype(Native{} < Native{});  // all bits of a lane, or none

STILLCUT_INLINE Native loadNative(const double* p) {
  return *reinterpret_cast<const Unaligned*>(p);
}
STILLCUT_INLINE void storeNative(double* p, Native a) {
  *reinterpret_cast<Unaligned*>(p) = a;
}
STILLCUT_INLINE Native spread(double x) {
  return x - Native{};  // minus zero stays what it is
}

template <class Element>
struct Octet {
  Element part[kParts];
};
using Lanes = Octet<Native>;
using Choices = Octet<Choice>;

// f(part) for each register. Written out: a loop over registers would live in memory.
template <class F>
STILLCUT_INLINE auto each(F f) {
  using Element = decltype(f(std::size_t{0}));
  if constexpr (kParts == 1) {
    return Octet<Element>{{f(0)}};
  } else if constexpr (kParts == 2) {
    return Octet<Element>{{f(0), f(1)}};
  } else {
    return Octet<Element>{{f(0), f(1), f(2), f(3)}};
  }
}

STILLCUT_INLINE Lanes operator+(Lanes a, Lanes b) {
  return each([&](std::size_t i) { return a.part[i] + b.part[i]; });
}
STILLCUT_INLINE Lanes operator-(Lanes a, Lanes b) {
  return each([&](std::size_t i) { return a.part[i] - b.part[i]; });
}
STILLCUT_INLINE Lanes operator*(Lanes a, Lanes b) {
  return each([&](std::size_t i) { return a.part[i] * b.part[i]; });
}
STILLCUT_INLINE Lanes operator/(Lanes a, Lanes b) {
  return each([&](std::size_t i) { return a.part[i] / b.part[i]; });
}
STILLCUT_INLINE Choices operator<(Lanes a, Lanes b) {
  return each([&](std::size_t i) { return a.part[i] < b.part[i]; });
}
STILLCUT_INLINE Choices operator&(Choices a, Choices b) {
  return each([&](std::size_t i) { return a.part[i] & b.part[i]; });
}
STILLCUT_INLINE Choices operator|(Choices a, Choices b) {
  return each([&](std::size_t i) { return a.part[i] | b.part[i]; });
}
STILLCUT_INLINE Lanes pick(Choices which, Lanes yes, Lanes no) {
  return each([&](std::size_t i) { return which.part[i] ? yes.part[i] : no.part[i]; });
}
STILLCUT_INLINE Lanes root(Lanes a) {
  return each([&](std::size_t i) {
    Native r{};
    for (std::size_t l = 0; l < kNative; ++l) r[l] = __builtin_sqrt(a.part[i][l]);
    return r;
  });
}
STILLCUT_INLINE Lanes all(double x) {
  return each([n = spread(x)](std::size_t) { return n; });
}
STILLCUT_INLINE Lanes load(const double* p) {
  return each([p](std::size_t i) { return loadNative(p + i * kNative); });
}
STILLCUT_INLINE void store(double* p, Lanes a) {
  for (std::size_t i = 0; i < kParts; ++i) storeNative(p + i * kNative, a.part[i]);
}

// One lane down: those of `a` but the first, then the first of `b`.
STILLCUT_INLINE Lanes movedOn(Lanes a, Lanes b) {
  return each([&](std::size_t i) {
    const Native upper = i + 1 < kParts ? a.part[(i + 1) % kParts] : b.part[0];
#if STILLCUT_NATIVE == 8
    return __builtin_shufflevector(a.part[i], upper, 1, 2, 3, 4, 5, 6, 7, 8);
#elif STILLCUT_NATIVE == 4
    return __builtin_shufflevector(a.part[i], upper, 1, 2, 3, 4);
#else
    return __builtin_shufflevector(a.part[i], upper, 1, 2);
#endif
  });
}

// A value and the seven that are older than it.
STILLCUT_INLINE Lanes loadAfter(double newest, const double* older) {
  Lanes a = load(older - 1);
  a.part[0][0] = newest;
  return a;
}

// Eight interleaved complex numbers.
struct ComplexLanes {
  Lanes re;
  Lanes im;
};
STILLCUT_INLINE ComplexLanes loadComplex(const double* p) {
  const auto halves = [p](std::size_t i, bool odd) {
    const Native a = loadNative(p + 2 * i * kNative);
    const Native b = loadNative(p + (2 * i + 1) * kNative);
#if STILLCUT_NATIVE == 8
    return odd ? __builtin_shufflevector(a, b, 1, 3, 5, 7, 9, 11, 13, 15)
               : __builtin_shufflevector(a, b, 0, 2, 4, 6, 8, 10, 12, 14);
#elif STILLCUT_NATIVE == 4
    return odd ? __builtin_shufflevector(a, b, 1, 3, 5, 7) : __builtin_shufflevector(a, b, 0, 2, 4, 6);
#else
    return odd ? __builtin_shufflevector(a, b, 1, 3) : __builtin_shufflevector(a, b, 0, 2);
#endif
  };
  return {each([&](std::size_t i) { return halves(i, false); }), each([&](std::size_t i) { return halves(i, true); })};
}

STILLCUT_INLINE void storeComplex(double* p, ComplexLanes z) {
  for (std::size_t i = 0; i < kParts; ++i) {
    const Native re = z.re.part[i];
    const Native im = z.im.part[i];
#if STILLCUT_NATIVE == 8
    storeNative(p + 2 * i * kNative, __builtin_shufflevector(re, im, 0, 8, 1, 9, 2, 10, 3, 11));
    storeNative(p + (2 * i + 1) * kNative, __builtin_shufflevector(re, im, 4, 12, 5, 13, 6, 14, 7, 15));
#elif STILLCUT_NATIVE == 4
    storeNative(p + 2 * i * kNative, __builtin_shufflevector(re, im, 0, 4, 1, 5));
    storeNative(p + (2 * i + 1) * kNative, __builtin_shufflevector(re, im, 2, 6, 3, 7));
#else
    storeNative(p + 2 * i * kNative, __builtin_shufflevector(re, im, 0, 2));
    storeNative(p + (2 * i + 1) * kNative, __builtin_shufflevector(re, im, 1, 3));
#endif
  }
}

STILLCUT_INLINE Lanes reversed(Lanes a) {
  return each([&](std::size_t i) {
    const Native n = a.part[kParts - 1 - i];
#if STILLCUT_NATIVE == 8
    return __builtin_shufflevector(n, n, 7, 6, 5, 4, 3, 2, 1, 0);
#elif STILLCUT_NATIVE == 4
    return __builtin_shufflevector(n, n, 3, 2, 1, 0);
#else
    return __builtin_shufflevector(n, n, 1, 0);
#endif
  });
}

// ((l0 + l4) + (l2 + l6)) + ((l1 + l5) + (l3 + l7)), whatever the registers.
STILLCUT_INLINE double total(Lanes a) {
  using Two [[gnu::vector_size(16)]] = double;
#if STILLCUT_NATIVE == 2
  const Two pair = (a.part[0] + a.part[2]) + (a.part[1] + a.part[3]);
#else
  using Four [[gnu::vector_size(32)]] = double;
#if STILLCUT_NATIVE == 4
  const Four four = a.part[0] + a.part[1];
#else
  const Native n = a.part[0];
  const Four four = __builtin_shufflevector(n, n, 0, 1, 2, 3) + __builtin_shufflevector(n, n, 4, 5, 6, 7);
#endif
  const Two pair = __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
#endif
  return pair[0] + pair[1];
}

// Square of kNative rows, in place.
STILLCUT_INLINE void transpose(Native* r) {
#if STILLCUT_NATIVE == 8
  Native t[8];
  for (std::size_t i = 0; i < 8; i += 2) {
    t[i] = __builtin_shufflevector(r[i], r[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    t[i + 1] = __builtin_shufflevector(r[i], r[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  Native u[8];
  for (std::size_t i = 0; i < 8; i += 4) {
    for (std::size_t j = i; j < i + 2; ++j) {
      u[j] = __builtin_shufflevector(t[j], t[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
      u[j + 2] = __builtin_shufflevector(t[j], t[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
    }
  }
  for (std::size_t j = 0; j < 4; ++j) {
    r[j] = __builtin_shufflevector(u[j], u[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
    r[j + 4] = __builtin_shufflevector(u[j], u[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
  }
#elif STILLCUT_NATIVE == 4
  const Native t[4] = {__builtin_shufflevector(r[0], r[1], 0, 4, 2, 6), __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7),
                       __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6),
                       __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7)};
  for (std::size_t j = 0; j < 2; ++j) {
    r[j] = __builtin_shufflevector(t[j], t[j + 2], 0, 1, 4, 5);
    r[j + 2] = __builtin_shufflevector(t[j], t[j + 2], 2, 3, 6, 7);
  }
#else
  const Native even = __builtin_shufflevector(r[0], r[1], 0, 2);
  r[1] = __builtin_shufflevector(r[0], r[1], 1, 3);
  r[0] = even;
#endif
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
