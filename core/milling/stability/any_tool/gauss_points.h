// Points and weights of Gauss-Legendre integration. Thread: pure.
#pragma once

#include <vector>

namespace stillcut::milling {

struct GaussPoint {
  double at, weight;  // over 0 .. 1
};

std::vector<GaussPoint> gaussPoints(int n);

}  // namespace stillcut::milling
