// Poles from one frequency response: least-squares complex frequency-domain estimator over rising model order, and the
// poles that stay put as the order rises (stabilisation).
// Source: P. Guillaume et al., A poly-reference implementation of the least-squares complex frequency-domain estimator,
// IMAC 2003 (common-denominator form, one response); the band is mapped onto nine tenths of the unit circle, which
// keeps the normal equations well conditioned for any band, and the lowest denominator coefficient is the one fixed,
// which makes the poles of noise unstable in the mean, so that damping tells them apart (Cauberghe 2004, section 5.3).
// Pure: any thread; set-up, not real-time.
#pragma once

#include <vector>

#include "core/milling/identify/modal_lines.h"
#include "core/milling/identify/modal_pole.h"

namespace stillcut::identify {

// A pole seen at several orders in a row.
struct StablePole {
  ModalPole pole;  // median over its orders
  int seen = 0;    // number of orders
};

// Physical poles (0 < damping < 0.3, inside the band or just beside it) for each order 2 .. highest.
std::vector<std::vector<ModalPole>> lscfPoles(const ModalLines& lines, int highestOrder);

// Tracks through the orders: a pole continues one of the order before within 1 % in frequency and 10 % (at least
// 0.001) in damping. Most seen first. Two tracks of one pole that broke off are joined.
std::vector<StablePole> stablePoles(const std::vector<std::vector<ModalPole>>& byOrder);

}  // namespace stillcut::identify
