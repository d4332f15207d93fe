// The work of ExactLobes at one speed: bands of depth, panels of (theta, depth) small enough for one expansion,
// verification by the argument principle, refinement on the accurate transition matrix.
// Thread: one, with its WorkMeter; not real-time.
#pragma once

#include <optional>
#include <vector>

#include "core/milling/stability/crossing_finder.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::milling {

class LimitSearch {
 public:
  LimitSearch(const RegenerativeSystem& system, Rpm speed, const LimitOptions& options, WorkMeter& meter);
  SpeedLimits run();

 private:
  struct Band {
    std::vector<CircleCrossing> crossings;
    double change = 0.0;  // of arg f along the top of the band
    bool complete = true;
  };

  // All crossings between two depths, checked against the count at the top; appends to limits_. `whole` is the
  // expansion that holds s of every depth up to `to`; where none converges the band is covered by smaller ones.
  void addBand(double from, double to, const std::optional<Characteristic>& whole);
  void searchPanel(const Characteristic& expansion, const ThetaDepthBox& box, double caution, Band& band);
  void cover(const ThetaDepthBox& box, double caution, int level, Band& band);
  void refine(std::vector<CircleCrossing>& crossings) const;
  void append(std::vector<CircleCrossing>& crossings);
  double growthAt(double depth) const;
  std::optional<Characteristic> expandTo(double depth);

  const RegenerativeSystem& system_;
  LimitOptions options_;
  WorkMeter& meter_;
  double cutting_;                         // time in the cut per tooth period [s]
  std::optional<TransitionMatrix> rough_;  // for the expansions
  std::optional<TransitionMatrix> fine_;   // for the refinement
  SpeedLimits limits_;
  int outside_ = 0;  // at the depth reached
  double bandEffort_ = 0.0;
};

}  // namespace stillcut::milling
