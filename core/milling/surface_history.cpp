#include "core/milling/surface_history.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace stillcut::milling {

namespace {
std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}
}  // namespace

SurfaceHistory::SurfaceHistory(int cells, int slices)
    : cells_(cells),
      slices_(slices),
      sine_(at(cells)),
      cosine_(at(cells)),
      weight_(at(cells), 0.0),
      live_(at(cells), 0),
      surface_(at(cells) * at(slices), 0.0) {
  for (int m = 0; m < cells; ++m) {
    const double phi = kTwoPi * m / cells;
    sine_[at(m)] = std::sin(phi);
    cosine_[at(m)] = std::cos(phi);
  }
}

void SurfaceHistory::stand() noexcept {
  stands_ = true;
  std::fill(sine_.begin(), sine_.end(), 1.0);
  std::fill(cosine_.begin(), cosine_.end(), 0.0);
  std::fill(weight_.begin(), weight_.end(), 1.0);
  std::fill(live_.begin(), live_.end(), std::uint8_t{1});
  for (int s = 0; s < slices_; ++s) restartSlice(s);
}

void SurfaceHistory::setWindows(std::span<const AngularWindow> windows) noexcept {
  if (stands_) return;
  const double perCell = kTwoPi / cells_;
  std::fill(weight_.begin(), weight_.end(), 0.0);
  for (const AngularWindow& w : windows) {
    const double from = w.from / perCell, to = w.to / perCell;
    if (!(to > from)) continue;
    const int first = static_cast<int>(std::floor(from + 0.5)), last = static_cast<int>(std::floor(to + 0.5));
    for (int m = first; m <= last; ++m) {
      const double share = std::min(to, m + 0.5) - std::max(from, m - 0.5);
      if (share > 0.0) weight_[at(m % cells_)] += share;
    }
  }
  for (int m = 0; m < cells_; ++m) {
    // A tooth between two cells reads both and writes the one behind it: keep one cell more on either side.
    double around = 0.0;
    for (int d = -1; d <= 2; ++d) around += weight_[at((m + d + cells_) % cells_)];
    const bool now = around > 0.0;
    if (now && live_[at(m)] == 0) {
      for (int s = 0; s < slices_; ++s) slice(s)[m] = kFresh;
    }
    live_[at(m)] = now ? 1 : 0;
  }
}

void SurfaceHistory::restartSlice(int s) noexcept {
  std::fill_n(slice(s), cells_, kFresh);
}

void SurfaceHistory::scale(double factor) noexcept {
  for (double& height : surface_) {
    if (!isFresh(height)) height *= factor;
  }
}

}  // namespace stillcut::milling
