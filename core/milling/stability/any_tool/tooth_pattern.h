// Where the teeth of a tool stand and how far behind its predecessor each runs, at any height: what pitch and helix
// do to regeneration. Tooth j stands at the spindle angle plus angle[j]; its edge trails with the height z by
// z trail[j]; the surface it meets was left by tooth j + 1, pitch[j] + z (trail[j] - trail[j + 1]) earlier.
// Pure: any thread; set-up, not real-time.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/milling/cut_model.h"

namespace stillcut::milling {

struct ToothPattern {
  std::vector<double> angle, pitch;  // [rad]
  std::vector<double> trail;         // tan(helix)/R [rad/m]
  int repeats = 1;                   // how often the pattern repeats in a revolution
  bool alike = true;                 // all teeth have the same pitch and helix: then repeats is their number
  bool straight = true;              // no helix
  bool parallel = true;              // one helix for all, so that no delay depends on the height

  int teeth() const { return static_cast<int>(angle.size()); }
  double delayAngle(int tooth, double height) const;  // [rad]
  // The height at which two edges meet, above which the tool cannot be; infinite where they never do.
  Metres meeting() const;
};

ToothPattern toothPattern(const Tool& tool);

}  // namespace stillcut::milling
