// Round numbers for an axis: 1, 2 or 5 times a power of ten apart.
#pragma once

#include <vector>

namespace stillcut::ui {

// Ticks inside [from, to], at most `most` of them; empty when the interval is empty or not finite.
std::vector<double> niceTicks(double from, double to, int most);
// Decimals that tell ticks apart.
int decimalsFor(double step);

}  // namespace stillcut::ui
