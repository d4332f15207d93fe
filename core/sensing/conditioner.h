// Conditioner: raw device blocks to what every detector works on. SI units, no offset, validity, spindle angle per
// sample, true spindle speed with its doubt, phase of the cut.
// Thread: worker. prepare() may allocate, plan and throw std::runtime_error; process() and reset() are real-time.
#pragma once

#include <array>
#include <vector>

#include "core/config/param_set.h"
#include "core/dsp/butterworth.h"
#include "core/model/cut_setup.h"
#include "core/model/machine_state.h"
#include "core/model/sample_block.h"
#include "core/sensing/auto_values.h"
#include "core/sensing/conditioned_block.h"
#include "core/sensing/cut_gate.h"
#include "core/sensing/drive_tone.h"
#include "core/sensing/hum_canceller.h"
#include "core/sensing/input_check.h"
#include "core/sensing/left_out.h"
#include "core/sensing/sensor_check.h"
#include "core/spindle/series_watch.h"
#include "core/spindle/speed_tracker.h"

namespace stillcut::detect {

inline constexpr config::ParamDecl kHighPass = config::locked(
    config::autoParam("conditioner.high-pass", "High-pass edge", "Hz", 0.1, 1000.0,
                      "Removes offset and drift below this frequency; auto: a quarter of the spindle frequency"));
inline constexpr config::ParamDecl kSpeedRange = config::locked(
    config::realParam("conditioner.speed-range", "Doubt of the told speed", "", 0.03, 0.0, 0.2,
                      "How far the told spindle speed may be from the true one, as a ratio; searched at entry"));
inline constexpr config::ParamDecl kCutLevel =
    config::realParam("conditioner.cut-level", "Cut above air", "dB", 6.0, 1.0, 40.0,
                      "A cut is this much louder than the quietest the sensor has heard");
// For whoever watches; nothing is decided by it.
inline constexpr config::ParamDecl kVibrationLimit = config::locked(
    config::autoParam("conditioner.vibration-limit", "Vibration limit", "", 1e-9, 1e9,
                      "Vibration (rms, SI unit of the first channel) from which the bar of the operator's page says "
                      "that it is too much; auto: no limit"));

// Every parameter of the conditioner and its parts.
config::ParamTable conditionerParams();

class Conditioner {
 public:
  void prepare(const CutSetup& setup, const config::ParamSet& params);
  // As Detector::retune() and Detector::chosen().
  void retune(const config::ParamSet& params) noexcept;
  double chosen(const config::ParamDecl& decl) const;
  // As Detector::autoValues() and Detector::own().
  static AutoValueTable autoValues();
  AutoValue own(std::size_t index) const noexcept { return own_.read(index); }
  // The returned block and what it points at are good until the next call.
  const ConditionedBlock& process(const SampleBlock& block, const MachineState& machine) noexcept;
  void reset() noexcept;

  const SpeedTracker& speed() const { return speed_; }
  const CutGate& gate() const { return gate_; }
  const SeriesWatch& series() const { return series_; }
  const SensorStatus& sensors() const { return sensors_.status(); }

 private:
  void restart() noexcept;
  bool usable(const SampleBlock& block) noexcept;
  void silenceLeftOut() noexcept;
  void restoreLeftOut() noexcept;
  void makeSi(const SampleBlock& block) noexcept;
  void follow(int frames) noexcept;
  void addSquares(int from, int frames) noexcept;
  void advanceGate() noexcept;
  void lookAtLines() noexcept;
  bool chattersFromTheStart() const noexcept;
  void checkSensors(const SampleBlock& block) noexcept;
  Reason doubtAir() const noexcept;
  Reason doubtDrives() const noexcept;
  void tellOwn() noexcept;

  AutoValues own_;
  CutSetup setup_;
  int capacity_ = 0;
  int channels_ = 0;
  Hertz highPass_{};
  bool onlyForce_ = false;  // every channel measures it
  bool primed_ = false;     // the first sample of each channel is known
  bool gapPending_ = false;
  bool doubted_ = false;  // the sensors, by the block before
  InputCheck check_;
  LeftOut leftOut_;
  SensorCheck sensors_;
  SpeedTracker speed_;
  SeriesWatch series_;
  int startsInChatter_ = 0;  // looks on end that can be nothing else
  unsigned cutUntil_ = 0;    // look to which the lines of a cut hold
  CutGate gate_;
  dsp::kernels::Kernels kernels_;
  std::vector<dsp::Butterworth> filters_;
  std::vector<HumCanceller> hums_;
  std::vector<DriveTone> drives_;
  std::vector<dsp::Butterworth> integrals_;  // low-pass of speed and current; none where there is neither
  std::vector<double> offset_;
  std::vector<double> samples_;
  std::vector<double> kept_;  // what a channel that is left out delivers, for the check of the sensors
  std::vector<double> angle_;
  std::vector<double> angleStep_;
  std::array<const double*, kMaxChannels> pointers_{};
  // Speed and phase are judged every millisecond, however long the blocks are.
  int stepFrames_ = 1;
  int stepDone_ = 0;
  std::array<double, kMaxChannels> squares_{};  // of this step
  ConditionedBlock out_;
};

}  // namespace stillcut::detect
