// Detector "parametric": van Dijk, Doppenberg, Faassen, van de Wouw, Oosterling, Nijmeijer 2010, "Automatic in-process
// chatter avoidance in the high-speed milling process", section 3.
//
// Equations: periodic part by NLMS on the spindle harmonics (19), perturbation as AR(4) by a random-walk Kalman filter
// (25) (parametric_recursions.h); dominant root, its frequency (27), H(f_c) (26), reflection of unstable roots
// (parametric_model.h); the variance of the residual as the signal that decides, H and |alpha| as indicators.
//
// Departures, with their evidence:
// - phi is the integrated spindle angle: the paper's l omega(k) k T_s jumps when the speed changes.
// - mu and the leak are given by a memory in turns: NLMS forgets harmonic l within L/mu samples, so that the paper's
//   mu = 0.5 at 25.6 kHz and L = 32 follows within 64 samples, half a turn at 11 000 rev/min, and takes the chatter
//   with it. The leak leaves (1 - lambda) L/mu of each harmonic; automatic lambda makes that 1 %.
// - Eq. 25c's sign against 22b's: D(q) = 1 - sum theta_n q^-n.
// - R_v and R_w belong to a signal of unit variance: the residual is divided by the rms of the vibration, learned while
//   the cut is stable and held from onset (NLMS does not depend on the scale).
// - The method works near the paper's 10 kHz: four taps at 100 kHz span 1/25 of a 1 kHz wave, and noise then decides
//   the roots. Faster input is low-passed and thinned by a whole factor.
// - A real root has no frequency: the dominant root is looked for among those that oscillate. Reflection is done where
//   the model is read, four times a turn, not at every sample. It is read from theta averaged over two turns: at full
//   chatter the paper's R_v, R_w forget within five samples, and single roots scatter from 0.86 to 1.
// - Four coefficients among side lines and noise put the root beside the line (at the alarm c2: 1.3 %, c6: 2.8 %). The
//   root says which line; its frequency in the verdict is refined by the phase of the residual (line_phase.h), where
//   a line stands there. The indicator frequency_hz is the root's own, eq. 27.
// - Threshold: the printed 6.678e4 m^2/s^4 is above what the paper's own figure 9 can reach. Growth of the residual
//   over what the harmonics take, above its learned floor, decides (onset_test.h), while the model has a root near the
//   unit circle (chips and knocks leave a broad residual). Its share of the whole would do in quiet signals alone: it
//   ends at 1, and where a sensor's noise makes it 0.25 it can not grow fourfold.
// Known limits: as energy_ratio.h, period doubling on spindle harmonics is not seen.
// Thread: worker. See detector.h.
#pragma once

#include <vector>

#include "core/detect/alarm_state_machine.h"
#include "core/detect/detector.h"
#include "core/detect/growth/onset_test.h"
#include "core/detect/van_dijk/parametric_model.h"
#include "core/dsp/butterworth.h"
#include "core/dsp/frame_ring.h"

namespace stillcut::detect {

inline constexpr config::ParamDecl kParHarmonics =
    config::locked(config::autoParam("parametric.harmonics", "Harmonics", "", 1, 256,
                                     "Spindle harmonics of the periodic part (L, eq. 9); auto: 32 as the rate allows"));
inline constexpr config::ParamDecl kParMu = config::locked(config::autoParam(
    "parametric.mu", "NLMS step", "", 1e-6, 1.0, "mu of eq. 19; auto: a memory of two turns (paper: 0.5)"));
inline constexpr config::ParamDecl kParLambda =
    config::locked(config::autoParam("parametric.lambda", "NLMS leak", "", 0.9, 1.0,
                                     "lambda of eq. 19; auto: leaves 1 % of a harmonic (paper: 0.9995)"));
inline constexpr config::ParamDecl kParRv = config::locked(config::realParam(
    "parametric.rv", "AR drift", "", 3e-5, 1e-12, 1.0, "R_v of eq. 21, for a signal of unit variance"));
inline constexpr config::ParamDecl kParRw = config::locked(config::realParam(
    "parametric.rw", "AR noise", "", 8e-4, 1e-12, 10.0, "R_w of eq. 21, for a signal of unit variance"));
inline constexpr config::ParamDecl kParDelta =
    config::realParam("parametric.delta", "Reflected distance", "", 0.001, 1e-6, 0.1,
                      "Distance from the unit circle at which an unstable root is put back inside");
inline constexpr config::ParamDecl kParRate =
    config::locked(config::autoParam("parametric.rate", "Working rate", "Hz", 500.0, 102400.0,
                                     "Least rate the method works at; auto: 10 kHz, as the paper"));
inline constexpr config::ParamDecl kParVariance = config::autoParam(
    "parametric.variance", "Variance limit", "", 1e-30, 1e30,
    "Variance of the residual (squared unit of the sensor) that is an alarm; auto: growth above the learned floor");
inline constexpr config::ParamDecl kParRoot =
    config::realParam("parametric.root", "Root of an alarm", "", 0.97, 0.0, 1.0,
                      "Magnitude of the dominant root below which the residual is noise and not chatter");
inline constexpr config::ParamDecl kParEvidence =
    config::realParam("parametric.evidence", "Evidence for onset", "", 12.0, 1.0, 100.0,
                      "Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)");
inline constexpr config::ParamDecl kParChatter = config::realParam(
    "parametric.chatter", "Chatter ratio", "", 0.2, 0.01, 1.0, "Energy ratio from which a cut is in full chatter");

config::ParamTable parametricParams();

class ParametricDetector final : public Detector {
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
  static constexpr int kStepsPerTurn = 4;

  struct ParametricChannel {
    OnsetTest onset;
    int eta = 0;
    double residualSum = 0.0;  // this step
    double inputSum = 0.0;
    double variance = 0.0;      // of the residual, about a turn
    double power = 0.0;         // of the vibration, several turns
    double taken = 0.0;         // of it by the harmonics
    double scale = 0.0;         // 1/rms of the stable cut; 0: nothing heard yet
    ArCoefficients thetaSum{};  // this step
    ArCoefficients theta{};     // about two turns
    ArRoots roots{};            // of that
    double root = 0.0;
    Hertz frequency{};
    double severity = 0.0;
    std::vector<double> weights;  // of its harmonics, l^(2 eta)
  };

  void tune(const ConditionedBlock& block);
  void restart();
  void leaveCut();
  std::size_t thin(const ConditionedBlock& block);
  std::size_t stretch(const ConditionedBlock& block, std::size_t from, std::size_t count) const;
  void processFrames(std::size_t from, std::size_t count);
  void endStep(const ConditionedBlock& block);
  void endChannelStep(std::size_t channel, CutPhase phase);
  void follow(Hertz root);
  void readModel(std::size_t channel);
  static double odds(const ParametricChannel& c);
  static double shareOf(double odds);
  double density(const ParametricChannel& c) const;
  double severity(std::size_t channel) const;
  bool fromEntry(const ParametricChannel& c);
  Verdict verdict(const ConditionedBlock& block) const;
  void tellOwn(int active, double mu, double lambda);

  AutoValues own_;
  bool harmonicsSet_ = false;
  bool rateSet_ = false;
  AlarmStateMachine judge_;
  dsp::kernels::Kernels kernels_;
  ParametricRecursions recursions_;
  std::vector<ParametricChannel> channels_;
  std::vector<dsp::Butterworth> lowPass_;  // one a channel, or none: nothing is thinned
  std::size_t most_ = 0;                   // frames of the longest block
  std::vector<double> thinned_, rest_;     // [channel * most + frame]
  FrameRing history_;                      // newest turns of the residual
  int harmonics_ = 1;
  int factor_ = 1;
  double rate_ = 0.0;  // after thinning
  double mu_ = 0.0;    // 0: automatic
  double lambda_ = 0.0;
  double delta_ = 0.001;
  double varianceLimit_ = 0.0;  // 0: automatic
  double rootLimit_ = 0.0;
  double chatterRatio_ = 0.2;

  Hertz spindle_{};
  int phase_ = 0;  // of the thinning: frames since the last one that was kept, modulo factor
  int first_ = 0;  // frame of this block that is kept first
  long stepFrames_ = 1;
  long inStep_ = 0;
  double steadyTurns_ = 0.0;
  double highTurns_ = 0.0;
  Hertz highLine_{};
  double clearTurns_ = 0.0;
  int sinceLook_ = 0;        // steps, at the phase of the line
  double looks_ = 0.0;       // in the mean of
  Hertz line_{};             // ... its frequency
  std::size_t leading_ = 0;  // channel with the strongest evidence
};

}  // namespace stillcut::detect
