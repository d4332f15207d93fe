// A detector that knows: whether it chatters and how much is the simulation's truth; the frequency, which the truth
// tells only afterwards, is the strongest line of the velocity's spectrum between the spindle's harmonics. So that
// a strategy can be judged on its own. For tests: it allocates nothing, but it is not quick.
#pragma once

#include <vector>

#include "core/detect/detector.h"
#include "core/dsp/spectrum.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::test {

class IdealDetector final : public detect::Detector {
 public:
  // `plant` outlives it and is advanced before each block.
  explicit IdealDetector(const milling::SimulatedCut& plant) : plant_(plant) {}
  detect::DetectorInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  Verdict process(const detect::ConditionedBlock& block) noexcept override;
  void reset() noexcept override {}

 private:
  Hertz strongest(Hertz spindle) noexcept;

  const milling::SimulatedCut& plant_;
  dsp::Spectrum spectrum_;
  std::vector<double> past_;  // first channel, oldest first
};

}  // namespace stillcut::test
