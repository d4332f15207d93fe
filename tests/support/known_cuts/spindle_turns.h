// Where the spindle of a known cut stood: its turns, also while its speed changes.
// Thread: one; not the sample path.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/support/known_cuts/known_cut.h"

namespace stillcut::bench {

double rpmAt(const KnownCut& cut, double time);
// Turns up to each frame.
std::vector<double> turnsOf(const KnownCut& cut, std::size_t frames);

}  // namespace stillcut::bench
