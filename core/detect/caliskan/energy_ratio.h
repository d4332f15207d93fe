// Detector "energy-ratio": Caliskan, Kilic, Altintas 2018, "On-line energy based milling chatter detection".
//
// Equations: harmonics removed by the rotating Kalman filter (16-22: turning_harmonics.h), band-pass bank following the
// speed and energy separation with lag (23-27: energy_separation.h), energy ratio (28, 29) with eta by quantity
// (energy_chain.h). ER >= 0.2 is the paper's threshold for full chatter (ratio_judge.h decides).
//
// Departures, with their evidence:
// - The filter's memory is given in turns (lambda follows from it), so that 800 rev/min and 30 000 rev/min are alike:
//   with the paper's lambda = 1e-6 .. 1e-4 at 4096 Hz and 800 rev/min chatter 1.5 Hz from an order is swallowed.
// - `onset` is not a fixed ratio: on the reference cuts the second axis shows an energy ratio of 1.6 % when chatter has
//   reached 20 % of the vibration. Growth of the turn difference above its learned floor is tested (onset_test.h,
//   turn_difference.h).
// - Full chatter is also told by the part of the line power that stands off the spindle's orders, whatever was learned
//   (share_test.h, core/detect/MODEL.md).
// - Chatter that is there from the entry, until the cut has once been calm, is onset from a fifth of the chatter ratio
//   on, 0.04 or a fifth of the amplitude, where its line has side lines whole tooth passings away, as the
//   tooth-periodic cut gives to what vibrates in it (entry_chatter.h). A line of other origin that shakes the tool so
//   strongly from the entry on has them too, and is taken for chatter.
// - A channel whose ratio is high in the calm cut anyway is asked for more than 0.2 in full chatter (usual_ratio.h).
// - A channel whose own vibration falls begins no alarm: a sensor that loses its seat differs from the turn before by
//   what it no longer hears.
// - Air, entry and exit are told by the conditioner; nothing is judged there.
// - The frequency of chatter is that of the strongest line of the turn difference (line_finder.h), or, while that line
//   is new, by its phase from turn to turn (new_line.h).
// - Period doubling with an even number of teeth lies on spindle harmonics, other chatter sometimes: order_growth.h.
// Known limits: chatter nearer than 0.03 orders to a tooth-passing harmonic is not told from forced vibration, and
// nearer than 0.012 to any other only where it grows by itself or has locked to it. While the load changes by more than
// 5 % a turn, as it may on a slow spindle, chatter beside an order is told by more than that change explains, some
// turns later (load_watch.h, order_pole.h): of 180 runs of face mills at 800 rev/min whose depth rises past the limit
// (detection_table, six seeds) 15 come late, a turn and a half after the 20 % time at most. Of chatter that has just
// grown out of runout beside an order the frequency lies nearer to that order, by up to 0.6 %, than where it comes to
// stand. Chatter that fills the cut from the entry is alarmed by its line alone where that can be no tooth passing
// (speed_tracker.h). Thread: worker. See detector.h.
#pragma once

#include <array>
#include <vector>

#include "core/detect/caliskan/energy_chain.h"
#include "core/detect/caliskan/ratio_judge.h"
#include "core/detect/caliskan/turn_marks.h"
#include "core/detect/detector.h"
#include "core/detect/growth/turn_difference.h"
#include "core/dsp/butterworth.h"

namespace stillcut::detect {

inline constexpr config::ParamDecl kErHarmonics =
    config::locked(config::autoParam("energy-ratio.harmonics", "Harmonics", "", 1, 256,
                                     "Spindle harmonics the Kalman filter removes (N, eq. 16); auto: 12 tooth "
                                     "passings, at least 32, as the sampling rate allows"));
inline constexpr config::ParamDecl kErLambda =
    config::locked(config::autoParam("energy-ratio.lambda", "Process noise ratio", "", 1e-10, 1e-1,
                                     "Q/R of the Kalman filter (eq. 20); auto: a memory of two turns"));
inline constexpr std::array<std::string_view, 2> kErCovariances{"settled", "full"};
inline constexpr config::ParamDecl kErCovariance = config::locked(config::choiceParam(
    "energy-ratio.covariance", "Covariance", 0, kErCovariances,
    "Covariance of the Kalman filter: its settled gain from the start, or eq. 20 at every sample, which is right from "
    "the first turn on and costs some twenty times as much"));
inline constexpr config::ParamDecl kErChatter = config::realParam(
    "energy-ratio.chatter", "Chatter ratio", "", 0.2, 0.01, 1.0,
    "Energy ratio (eq. 28) from which a cut is in full chatter; more where it is high in the calm cut");
inline constexpr config::ParamDecl kErOnsetAmplitude = config::realParam(
    "energy-ratio.onset-amplitude", "Smallest onset", "", 0.0125, 0.001, 1.0,
    "Unrepeated vibration over all vibration (amplitudes) below which growth is not yet called onset");
inline constexpr config::ParamDecl kErEvidence =
    config::realParam("energy-ratio.evidence", "Evidence for onset", "", 15.0, 2.0, 100.0,
                      "Log-likelihood ratio of growth against the learned noise that makes an onset; a stable cut "
                      "lasts e to this power turns, on average, without a false alarm");

config::ParamTable energyRatioParams();

class EnergyRatioDetector final : public Detector {
 public:
  DetectorInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  Verdict process(const ConditionedBlock& block) override;
  void retune(const config::ParamSet& params) override;
  double chosen(const config::ParamDecl& decl) const override;
  AutoValueTable autoValues() const override;
  AutoValue own(std::size_t index) const override { return own_.read(index); }
  void reset() override;

 private:
  static constexpr int kRow = 256;  // frames compared at once
  void sizeFor(const CutSetup& setup, const config::ParamSet& params);
  void tune(const ConditionedBlock& block);
  void followBand();
  void relearn();
  void restart();
  void leaveCut();
  int stretch(const ConditionedBlock& block, int first) const;
  void processFrames(const ConditionedBlock& block, int first, int frames);
  void compare(const ConditionedBlock& block, int first, int frames);
  void endHop(const ConditionedBlock& block);
  Verdict verdict(const ConditionedBlock& block) const;
  void tellOwn(double gain);

  AutoValues own_;
  bool harmonicsSet_ = false;
  double rate_ = 0.0;
  int teeth_ = 0;
  int channels_ = 0;
  int harmonics_ = 0;
  double smallest_ = 0.0;
  double fixedGain_ = 0.0;  // 0: from the memory in turns
  dsp::kernels::Kernels kernels_;
  EnergyChain chain_;
  RevolutionDifference turns_;
  TurnMarks marks_;
  LineFinder lines_;
  NewLine newLine_;
  std::vector<RatioChannel> channelStates_;
  RatioJudge judge_;
  std::vector<dsp::Butterworth> lowPass_;             // of what is compared from turn to turn, one per channel
  std::vector<double> compared_, difference_, news_;  // [channel * kRow + frame]

  Hertz spindle_{};
  Hertz highest_{};  // chatter is looked for up to here
  long hopFrames_ = 1;
  int windowHops_ = kHopsPerTurn;  // over which the turn difference is averaged
  long inHop_ = 0;
  int hopOfTurn_ = 0;
  bool turnsCompare_ = true;
  bool integrals_ = false;  // every channel is an integral of the cutting torque,
  bool sideLines_ = false;  // ... or a force
  double steadyTurns_ = 0.0;
};

}  // namespace stillcut::detect
