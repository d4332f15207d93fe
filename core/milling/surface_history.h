// SurfaceHistory: the surface the teeth have left, on a grid of angles, and which of those angles are in the material.
//
// A tooth's edge at angle phi reaches rho = runout + x_feed sin(phi) + [sin phi, cos phi] . v(t). The surface is the
// farthest any tooth has reached at that angle, so the chip is h = rho - surface: whatever number of past teeth have
// cut it, at whatever pitch and speed. A tooth with h <= 0 is out of the cut and leaves the surface as it is.
// Thread: one. advance-time functions are real-time safe.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace stillcut::milling {

struct AngularWindow {
  double from = 0.0, to = 0.0;  // [rad], 0 <= from <= to <= pi
};

class SurfaceHistory {
 public:
  // `cells` angles per revolution, one surface per axial slice.
  SurfaceHistory(int cells, int slices);

  // Angles in the material. Cells that come newly into it are fresh. Edges between cells weigh the cell by its part,
  // so that the force integral over a step does not jump when an edge moves (first order in the step without it).
  void setWindows(std::span<const AngularWindow> windows) noexcept;
  // From now on the edges stand at 90 degrees at every angle of the work, all of which is in the material.
  void stand() noexcept;
  // A slice that comes newly into the cut is all fresh.
  void restartSlice(int slice) noexcept;
  // All heights times `factor`; what is fresh stays fresh.
  void scale(double factor) noexcept;

  // The height of a cell that no tooth has passed yet lies this deep: whoever meets it cuts a flat surface, one tooth's
  // feed behind the tool.
  static constexpr double kFresh = -1e305;
  static bool isFresh(double height) { return height < -1e290; }

  int cells() const { return cells_; }
  const double* sine() const { return sine_.data(); }
  const double* cosine() const { return cosine_.data(); }
  const double* weight() const { return weight_.data(); }
  const std::uint8_t* live() const { return live_.data(); }
  double* slice(int s) { return surface_.data() + static_cast<std::ptrdiff_t>(s) * cells_; }

 private:
  int cells_, slices_;
  bool stands_ = false;
  std::vector<double> sine_, cosine_;
  std::vector<double> weight_;      // fraction of the cell [m - 1/2, m + 1/2] inside the windows
  std::vector<std::uint8_t> live_;  // the cell or a neighbour has weight: its surface is kept
  std::vector<double> surface_;     // [slice * cells + cell], [m]
};

}  // namespace stillcut::milling
