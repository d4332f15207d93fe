// Zeroth-order approximation (Altintas and Budak, CIRP Ann. 44, 1995): the force coefficients are replaced by their
// mean over the tooth period. With s = w (1 - exp(-i omega tau)) the border of stability is
//   det(I + s H0 G(i omega)) = 0,  so  s = -1/eigenvalue(H0 G),  w = |s|^2/(2 Re s),  exp(-i omega tau) = 1 - s/w.
// Fast, and wrong where the cut is interrupted: it knows no flip lobes and no islands, and at low immersion it can
// allow more than twice the true depth. Every result carries that warning.
// Constant once made: any thread; not real-time.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/milling/stability/exact_lobes.h"
#include "core/milling/stability/measured_receptance.h"

namespace stillcut::milling {

class ZerothOrder {
 public:
  static Result<ZerothOrder> make(const CutModel& model, const std::string& where);
  // With what was measured in place of the model's modes, which may be missing.
  static Result<ZerothOrder> make(CutModel model, MeasuredReceptance measured, const std::string& where);

  // crossings holds 0 or 1 entry; `frequency` is the chatter frequency, omega/2 pi.
  // When stopped: nothing, searchedTo 0.
  Result<SpeedLimits> limit(Rpm speed, Metres maxAxialDepth, const std::stop_token& stop = {}) const;
  Result<SpeedLimits> limit(Rpm speed, Metres maxAxialDepth, WorkMeter& meter) const;
  // One sentence that belongs beside every result; stronger where teeth cut only part of the time. Empty where edges
  // stand, for which the zeroth order is all there is.
  const Message& warning() const { return warning_; }

 private:
  struct BorderPoint;
  explicit ZerothOrder(ExactLobes lobes);
  std::vector<double> frequencies(double period) const;  // [rad/s]
  BorderPoint at(double omega, double period, int branch) const;
  std::vector<double> measuredFrequencies(double period) const;

  ExactLobes lobes_;
  std::optional<MeasuredReceptance> measured_;
  Planar mean_{};
  Message warning_;
};

}  // namespace stillcut::milling
