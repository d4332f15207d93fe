#include "core/milling/identify/hits_by_axis.h"

namespace stillcut::identify {
namespace {

constexpr double kClearly = 2.0;  // response along the hit over that across it, for the force of each

}  // namespace

std::array<std::vector<int>, 2> hitsAlongOther(const std::vector<Hit>& x, const std::vector<Hit>& y) {
  std::array<std::vector<int>, 2> out;
  if (x.size() != y.size()) return {};
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double alongX = x[i].response, alongY = y[i].response;
    if (x[i].time != y[i].time) return {};
    if (alongX >= kClearly * alongY) {
      out[1].push_back(static_cast<int>(i) + 1);
    } else if (alongY >= kClearly * alongX) {
      out[0].push_back(static_cast<int>(i) + 1);
    } else {
      return {};
    }
  }
  if (out[0].empty() || out[1].empty()) return {};
  return out;
}

}  // namespace stillcut::identify
