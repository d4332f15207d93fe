// GrowthProbe: does a small disturbance of the cut grow or die, now? The cut linearised about its forced vibration: the
// same structure, teeth, engagement, depth and speed, no feed, runout or edge forces, teeth that stay in the cut; it
// sees neither noise nor sensors. What the exact lobes say of a constant cut it says of a cut that changes, helix
// included. The disturbance is brought back to one size now and then, and each mode is nudged by a thousandth of it,
// so that what becomes unstable next is not lost below the number range.
// Steps are twice the plant's: the multiplier is then good to about 1e-3 at 1024 steps per revolution.
// Thread: one. After construction nothing allocates; real-time safe.
#pragma once

#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/noise.h"

namespace stillcut::milling {

// Steps of a companion of a cut that looks at it every `tickSteps` steps: half as many, where that goes.
int companionTick(int tickSteps);
CutNumerics companionNumerics(CutNumerics plant, int tickSteps);

class GrowthProbe {
 public:
  // `plant` as the cut it goes with; one advance() goes as far as `tickSteps` of its steps; `feedPerTooth` is where a
  // power law of the chip is linearised.
  GrowthProbe(const CutModel& model, const CutNumerics& plant, int tickSteps, Metres feedPerTooth);

  RegenerativeCut& cut() { return cut_; }  // for speed, depth and windows
  void advance() noexcept;

  // Over the last few tooth periods: growth of the amplitude [1/s], above zero unstable;
  double growth() const { return growth_; }
  // |1 - exp(-2 pi i f T)|^2 of the motion's frequency f, 0..4, where `perRevolution` periods T make a revolution (1,
  // or the teeth of a regular pitch); near zero it all but repeats.
  double gain(int perRevolution) const noexcept;
  // The motion's frequency as a fraction of the tooth-passing frequency, folded into 0 .. 1/2 (of the spindle's with a
  // variable pitch); its lines lie at this, plus or minus, from every multiple.
  double folded() const noexcept;
  int periodsPerRevolution() const { return periods_; }
  // Its multiplier over the tooth period is -1: the motion repeats after two teeth.
  bool flips() const { return periods_ > 1 && cosine_ < -0.9995; }

 private:
  double energy() const noexcept;
  void endPeriod() noexcept;

  RegenerativeCut cut_;
  int tickSteps_;
  int periods_;  // a revolution has: the teeth, or 1 with a variable pitch
  int ticksPerPeriod_;
  std::array<double, kMaxModes> stiffness_{}, mass_{};
  NoiseSource nudges_{1};
  int tick_ = 0;
  double energySum_ = 0.0, energyBefore_ = 1.0, duration_ = 0.0;
  double growth_ = 0.0, cosine_ = 0.0;  // of the motion's rotation over a period
  std::vector<double> past_;            // tip motion, x + y, over two periods
  std::size_t pastAt_ = 0;
  double num_ = 0.0, den_ = 0.0;
  bool first_ = true;
};

}  // namespace stillcut::milling
