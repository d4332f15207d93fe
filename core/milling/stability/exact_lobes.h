// Exact stability of a milling cut: every depth at which a Floquet multiplier crosses the unit circle, islands and
// lenses included. Method: for a multiplier mu the delayed motion is x(t)/mu, which leaves an ordinary periodic
// equation (transition_matrix.h); its characteristic function is expanded once per speed (characteristic.h), all zeros
// on the circle are found without scanning the depth (crossing_finder.h), the argument principle checks their number,
// and Newton on the accurate transition matrix refines each. With a regular pitch no multiplier can cross at +1: there
// the delayed force vanishes and the free structure decays. Helix and process damping make the depth more than a
// factor, an uneven pitch makes several delays: then depth_search.h does the same on a CircleFunction.
//
// Thread: const members may be called from any number of threads. Allocates; not for the sample path.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/milling/stability/any_tool/tooth_pattern.h"
#include "core/milling/stability/regenerative_system.h"
#include "core/milling/stability/work_meter.h"

namespace stillcut::milling {

enum class CrossingKind {
  Hopf,  // a pair leaves at exp(+-i theta): quasi-periodic chatter
  Flip,  // one leaves at -1: period doubling
  Fold,  // one leaves at +1, which takes an uneven pitch: the cut drifts away with the spindle's own period
};
const char* crossingName(CrossingKind kind);  // "hopf", "flip", "fold"

struct StabilityLimit {
  Rpm speed{};
  int crossing = 0;  // counted from 0 upwards in depth; 0 is the stability limit
  Metres depth{};
  int before = 0;  // multipliers outside the unit circle below this depth
  int after = 0;   // and above it; 0: stable again
  CrossingKind kind = CrossingKind::Hopf;
  Radians angle{};    // of the multiplier, (0, pi]
  Hertz frequency{};  // largest harmonic of the motion at the tool tip: the chatter frequency; 0 when not asked for
};

struct LimitOptions {
  Metres maxAxialDepth{0.010};
  bool firstOnly = false;   // only crossing 0: several times faster
  bool frequencies = true;  // fill in `frequency`
  Metres hint{};            // firstOnly: where the limit is expected, 0 unknown; affects the time only
};

struct SpeedLimits {
  Rpm speed{};
  std::vector<StabilityLimit> crossings;  // by depth
  Metres searchedTo{};                    // below maxAxialDepth where the cut is so unstable that double precision ends
  bool verified = false;                  // the argument principle counts the same number of multipliers at the top

  bool hasLimit() const { return !crossings.empty(); }
  // Multipliers outside at a depth within searchedTo; beyond it the last known number.
  int outsideAt(Metres depth) const;
  // Deeper than searchedTo nothing is called stable.
  bool stableAt(Metres depth) const { return depth <= (1.0 + 1e-9) * searchedTo && outsideAt(depth) == 0; }
};

class ExactLobes {
 public:
  static Result<ExactLobes> make(const CutModel& model, const std::string& where);

  // One clear line for a speed that is not positive, or absurd for these modes.
  Status checkSpeed(Rpm speed) const;
  static Status checkDepth(Metres largest);  // above 0 and up to 1 m
  // With teeth that differ the harmonics to be solved for grow in number as the speed falls: below this one they are
  // too many, and limits() refuses. 0: no speed is too low for that.
  Rpm lowestSpeed() const;
  bool possible(Rpm speed) const;
  Result<SpeedLimits> limits(Rpm speed, const LimitOptions& options, const std::stop_token& stop = {}) const;
  Result<SpeedLimits> limits(Rpm speed, const LimitOptions& options, WorkMeter& meter) const;

  // With straight teeth of the mean pitch and without process damping.
  const RegenerativeSystem& system() const { return system_; }
  const CutModel& model() const { return model_; }
  const ToothPattern& pattern() const { return pattern_; }

 private:
  ExactLobes(CutModel model, RegenerativeSystem system)
      : model_(std::move(model)), pattern_(toothPattern(model_.tool)), system_(std::move(system)) {}

  Status checkPattern(Rpm speed, Metres largest) const;

  CutModel model_;
  ToothPattern pattern_;
  RegenerativeSystem system_;
};

}  // namespace stillcut::milling
