// Semi-discretization (Insperger and Stepan; first order as in Insperger, J. Sound Vib. 313, 2008): the tooth period is
// cut into k cells; in each the force coefficients are their exact mean and the delayed motion is constant (order 0:
// mean of its two end values) or linear (order 1).
// The usual map of size states + k is not formed: over one period its multipliers mu satisfy x_(i-k) = x_i/mu, so that
// they are the zeros of det(Psi(mu) - mu) with a product of k small matrices, counted by the argument principle.
//
// Thread: const members from any thread. Allocates.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "core/base/result.h"
#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/work_meter.h"

namespace stillcut::milling {

struct SdmOptions {
  int cells = 0;  // k, 1 .. 2000; 0: as many at each speed as the fastest mode calls for (cellsFor)
  int order = 1;  // 0 or 1
};

// 40, or 8 for every wave of the fastest mode between two teeth: first order is then good to a percent. 2000 at most.
int cellsFor(const CutModel& model, Rpm speed);
// Fewer than this for a wave see another vibration.
inline constexpr double kLeastCellsPerWave = 6.0;
// Waves of the fastest mode between two teeth.
double wavesBetweenTeeth(const CutModel& model, Rpm speed);

class SemiDiscretization {
 public:
  static Result<SemiDiscretization> make(const CutModel& model, const SdmOptions& options, const std::string& where);

  // Multipliers of the discretized cut outside the unit circle; empty when one sits on it, or when the cut is so
  // unstable that numbers overflow. 0 is stable.
  std::optional<int> outside(Rpm speed, Metres depth) const;
  // The first depth up to maxAxialDepth at which a multiplier leaves, found on a scan of `scan` depths and refined to
  // 1e-9; an island thinner than a scan step may be stepped over, unlike in ExactLobes. crossings holds 0 or 1 entry;
  // when stopped none, and searchedTo is where the scan was.
  Result<SpeedLimits> limit(Rpm speed, Metres maxAxialDepth, int scan = 80, const std::stop_token& stop = {}) const;
  Result<SpeedLimits> limit(Rpm speed, Metres maxAxialDepth, int scan, WorkMeter& meter) const;

 private:
  SdmOptions optionsAt(Rpm speed) const;
  std::optional<int> outside(Rpm speed, Metres depth, WorkMeter& meter) const;
  StabilityLimit limitAt(Rpm speed, double rootAngle, double depth, WorkMeter& meter) const;
  SemiDiscretization(ExactLobes lobes, const SdmOptions& options) : lobes_(std::move(lobes)), options_(options) {}

  ExactLobes lobes_;  // the checked system and its limits on speed
  SdmOptions options_;
};

}  // namespace stillcut::milling
