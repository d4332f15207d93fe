// f of a cut whose teeth are alike, with helix and process damping: det(Psi - mu) of the transition matrix over one
// tooth period with the delayed motion x/mu, at the one depth that lag and damping are for.
// Thread: const members from any thread.
#pragma once

#include "core/milling/cut_model.h"
#include "core/milling/stability/any_tool/circle_function.h"
#include "core/milling/stability/regenerative_system.h"

namespace stillcut::milling {

class AlikeTeeth final : public CircleFunction {
 public:
  AlikeTeeth(const CutModel& model, Rpm speed);

  int states() const override { return states_; }
  bool sample(double depth, std::span<const double> angles, Fineness fineness, std::span<std::complex<double>> out,
              WorkMeter& meter) const override;
  Hertz chatterFrequency(double angle, double depth, WorkMeter& meter) const override;
  double growthAt(double depth) const override;

 private:
  const CutModel& model_;  // outlives this
  Rpm speed_;
  RegenerativeSystem straight_;  // without lag, for estimates
  int states_;
};

}  // namespace stillcut::milling
