// SimulatedCut: the plant. One spindle, one tool, one workpiece, the sensors on it; advanced block by block.
// The same scenario, seed and commands give the same samples, bit by bit.
// Thread: one (the simulated source's driver thread); others talk to it through a PlantPort. After construction nothing
// allocates, fill() and everything above the line "afterwards" is real-time safe.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/realtime.h"
#include "core/base/time.h"
#include "core/milling/engagement_windows.h"
#include "core/milling/regenerative_cut.h"
#include "core/milling/simulation/chatter_truth.h"
#include "core/milling/simulation/growth_probe.h"
#include "core/milling/simulation/noise.h"
#include "core/milling/simulation/override_path.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/simulation/sensors.h"
#include "core/milling/simulation/spindle_drive.h"
#include "core/model/machine_state.h"
#include "core/model/sample_block.h"

namespace stillcut::milling {

class SimulatedCut {
 public:
  // `scenario` has passed check(). Seed 0: the scenario's own.
  explicit SimulatedCut(const Scenario& scenario, std::uint64_t seed = 0);

  // Stream time of the first sample; before the first fill().
  void setStart(Instant start) noexcept { start_ = start; }

  // Advances by as many frames as the block holds (block.capacityFrames) and writes them. Sets everything but `source`.
  // The last block carries kBlockEnd and may be shorter. False, nothing written: the scenario is over.
  bool fill(SampleBlock& block) STILLCUT_RT;

  // As a control would tell it, at the end of the last block.
  MachineState machineState() const STILLCUT_RT;
  // Our factors on the programmed values; they act after the override's delay, from `when` or now, whichever is later.
  void setOverrides(Ratio speed, Ratio feed, Instant when) STILLCUT_RT;
  void setOperatorOverrides(Ratio speed, Ratio feed) STILLCUT_RT;
  void setOverridesEnabled(bool enabled) noexcept { overridesEnabled_ = enabled; }  // false: as under M49
  void setFeedHold(bool hold) noexcept { feedHold_ = hold; }

  // Strokes asked of the work-holder [m], as its converter holds them until the next call. With fill() called frame by
  // frame this is the loop of an active table: the command of one frame acts from that frame to the next.
  void setWorkHolder(double x, double y) noexcept;

  // With the flexure of a work-holder among the model's modes.
  const Scenario& scenario() const { return scenario_; }
  const ChatterTruth& truth() const { return truth_; }
  Seconds time() const { return Seconds(cut_.time()); }
  Metres depth() const { return Metres(depth_); }
  bool cutting() const { return cutting_; }

 private:
  void advanceTo(double seconds) noexcept;
  void tick() noexcept;
  void disturb() noexcept;
  void moveWorkHolder() noexcept;
  void takeAlong(RegenerativeCut& companion, int steps) noexcept;
  int flexure(std::size_t axis) const { return cut_.modes() - static_cast<int>(holder_.size() - axis); }
  void updateDrives() noexcept;
  void updateEngagement() noexcept;
  void setCutSpeed(double radPerSecond) noexcept;
  std::array<RegenerativeCut*, 3> cuts() noexcept { return {&cut_, &probe_.cut(), &forced_}; }
  void readSensors(std::vector<double>& values) const noexcept;

  Scenario scenario_;
  int tickSteps_;
  RegenerativeCut cut_;
  GrowthProbe probe_;
  RegenerativeCut forced_;  // vibrates as cut_ would if vibration left no marks
  SpindleDrive drive_;
  OverridePath overrides_;
  NoiseSource noise_;
  ChatterTruth truth_;
  std::vector<Sensor> sensors_;

  Instant start_{};
  std::uint64_t frames_ = 0, totalFrames_ = 0, blocks_ = 0;
  std::uint64_t fine_ = 0;  // readings made, at the oversampled rate
  int stepInTick_ = 0;
  double lastTick_ = 0.0;
  std::vector<double> before_, now_;  // readings around the instant wanted, one per sensor
  double beforeTime_ = 0.0, nowTime_ = 0.0;

  double modelSpeed_ = 0.0;  // [rad/s] the cut steps with
  double programmedRpm_ = 0.0, feed_ = 0.0, depth_ = 0.0;
  std::array<double, 2> random_{};           // [N]
  std::vector<WorkHolderAxis> holder_;       // none, or x and y
  std::array<double, 2> wanted_{}, push_{};  // [m]; [N] on its flexure at the last reading
  std::array<AngularWindow, 2> windows_{};
  int windowCount_ = -1;
  bool cutting_ = false, engagementSteady_ = true;
  bool overridesEnabled_ = true, feedHold_ = false;
  Ratio knobSpeed_{1.0}, knobFeed_{1.0};
};

}  // namespace stillcut::milling
