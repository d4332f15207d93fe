// Hits along x and hits along y in one record with a sensor for each: which hit went along which.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <array>
#include <vector>

#include "core/milling/identify/hammer.h"

namespace stillcut::identify {

// `x` and `y` are the same hits, as the sensors along x and along y answered them. Numbers, from 1, of those that went
// along y, to be left out along x, and of those along x, to be left out along y. Both empty where all hits went one way
// or where one of them moved both sensors alike.
std::array<std::vector<int>, 2> hitsAlongOther(const std::vector<Hit>& x, const std::vector<Hit>& y);

}  // namespace stillcut::identify
