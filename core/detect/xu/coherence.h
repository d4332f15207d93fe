// Detector "coherence": Xu 2003, "Chatter suppression using a fuzzy logic controller", sections 3.1, 3.2.
//
// Equations: coherence of two channels (3-1 .. 3-5, both forms), smoothing, sharpening and window (3-17a, 3-17b, 3-18:
// coherence_ratio.h), mean vibration energy E_r (3-7, 3-8), references gamma_ref and E_ref (3-19, 3-21). gamma_max high
// before the energy is: early warning, with its lead time.
//
// Departures, with their evidence:
// - Welch averages by default: eq. 3-1 of one segment is 1 everywhere, and 3-5 exceeds 0.8 in about 9 % of windows of
//   independent noise. Eq. 3-5 is `coherence.form = paper`.
// - Eq. 3-17b's branches do not meet (0.287 and 0.435 at 0.5): a monotone variant is the default.
// - The window's band (the author's 170 .. 250 Hz) is a parameter; by default the whole band counts and the spindle's
//   lines are masked. Both channels first pass the turn difference (turn_difference.h), which takes the harmonics and
//   their leakage out: one and the same linear filter on both channels leaves their coherence as it is.
// - E over E_ref OR gamma over gamma_ref calls a stable cut chatter (forced vibration and structural modes are
// coherent,
//   the depth moves the energy). Here the energy that does not repeat from turn to turn must grow above its learned
//   floor (onset_test.h; E_r of the turn difference over E_r of the signal) AND gamma_max be over gamma_ref at a line.
//   `coherence.energy-ref` fixes E_ref in the sensor's unit instead of the learned floor (the paper's 1.5 V).
// - Segments are 12 turns, at most the paper's 1 s.
// More than two channels: neighbours are paired, the pair with the highest ratio speaks; E_r takes every channel.
// Known limits: where the stable cut already holds gamma_max over gamma_ref there is no early warning.
// Thread: worker. See detector.h.
#pragma once

#include <array>
#include <vector>

#include "core/detect/alarm_state_machine.h"
#include "core/detect/detector.h"
#include "core/detect/growth/onset_test.h"
#include "core/detect/growth/turn_difference.h"
#include "core/detect/xu/coherence_ratio.h"
#include "core/dsp/frame_ring.h"
#include "core/dsp/harmonic_mask.h"
#include "core/dsp/spectrum.h"

namespace stillcut::detect {

inline constexpr std::array<std::string_view, 2> kCohForms{"welch", "paper"};
inline constexpr std::array<std::string_view, 2> kCohSharpenings{"monotone", "printed"};

inline constexpr config::ParamDecl kCohForm =
    config::locked(config::choiceParam("coherence.form", "Coherence", 0, kCohForms,
                                       "welch: averaged magnitude-squared coherence; paper: eq. 3-5 of one transform"));
inline constexpr config::ParamDecl kCohSharpening =
    config::locked(config::choiceParam("coherence.sharpening", "Sharpening", 0, kCohSharpenings,
                                       "Weighting of the smoothed coherence; printed: eq. 3-17b as it stands"));
inline constexpr config::ParamDecl kCohSegment = config::locked(config::autoParam(
    "coherence.segment", "Segment", "s", 0.005, 10.0, "Length of one transform; auto: 12 turns, at most 1 s"));
inline constexpr config::ParamDecl kCohAverages =
    config::locked(config::integerParam("coherence.averages", "Averages", 12, 2, 256,
                                        "Memory of the averages, in segments (each overlaps the last by 7/8)"));
inline constexpr config::ParamDecl kCohLow =
    config::locked(config::autoParam("coherence.band-low", "Window from", "Hz", 1.0, 50000.0,
                                     "Where the window of eq. 3-18 begins to rise (paper: 170 Hz); auto: no window"));
inline constexpr config::ParamDecl kCohHigh =
    config::locked(config::autoParam("coherence.band-high", "Window to", "Hz", 1.0, 50000.0,
                                     "Where the window of eq. 3-18 has fallen (paper: 250 Hz); auto: no window"));
inline constexpr config::ParamDecl kCohGammaRef = config::realParam(
    "coherence.gamma-ref", "Coherence reference", "", 0.8, 0.0, 1.0, "gamma_ref: coherence ratio that is chatter's");
inline constexpr config::ParamDecl kCohEnergyRef =
    config::autoParam("coherence.energy-ref", "Energy reference", "", 1e-12, 1e12,
                      "E_ref (unit of the sensor) of eq. 3-21; auto: growth above the learned floor");
inline constexpr config::ParamDecl kCohPurity =
    config::realParam("coherence.purity", "Purity", "", 0.3, 0.0, 1.0,
                      "Part of the cross spectrum between the harmonics that a chatter line holds at least");
inline constexpr config::ParamDecl kCohEvidence =
    config::realParam("coherence.evidence", "Evidence for onset", "", 12.0, 1.0, 100.0,
                      "Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)");
inline constexpr config::ParamDecl kCohChatter = config::realParam(
    "coherence.chatter", "Chatter ratio", "", 0.2, 0.01, 1.0, "Energy ratio from which a cut is in full chatter");

config::ParamTable coherenceParams();

class CoherenceDetector final : public Detector {
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
  static constexpr int kOverlap = 8;
  static constexpr int kRow = 256;  // frames compared at once

  void tellOwn();
  struct CoherenceChannel {
    double sum = 0.0;      // of |x| since the last look (eq. 3-7)
    double changed = 0.0;  // of |d|
  };
  // What gamma_max is while the cut is stable.
  struct Usual {
    double mean = 0.0;
    double variance = 0.0;
    double looks = 0.0;
  };
  void restart();
  void leaveCut();
  void compare(const ConditionedBlock& block, int first, int frames);
  void analyse(const ConditionedBlock& block);
  void takeEnergies();
  void transform();
  void warn(bool settled, double seconds);
  double severity(Hertz spindle) const;
  bool fromEntry(double severity, double turns);
  Verdict verdict(const ConditionedBlock& block) const;

  AlarmStateMachine judge_;
  RevolutionDifference turns_;
  FrameRing ring_;
  HarmonicMask mask_;
  OnsetTest onset_;
  dsp::Spectrum spectrum_;
  std::vector<CoherenceRatio> pairs_;
  std::vector<CoherenceChannel> channels_;
  std::vector<double> difference_;            // [channel * kRow + frame]
  std::vector<std::complex<double>> before_;  // transform of the pair's first channel
  double rate_ = 0.0;
  int hop_ = 1;
  double gammaRef_ = 0.8;
  double energyRef_ = 0.0;  // 0: automatic
  double purity_ = 0.3;
  double chatterRatio_ = 0.2;

  int sinceLook_ = 0;
  double settledSeconds_ = 0.0;
  double energy_ = 0.0;         // E_r, eq. 3-8
  double changedEnergy_ = 0.0;  // the same of the turn difference
  CoherencePeak peak_;
  Usual usual_;
  AutoValues own_;
  bool warned_ = false;
  double warnedSeconds_ = 0.0;
  double lead_ = 0.0;
  double highTurns_ = 0.0;
  Hertz highLine_{};
};

}  // namespace stillcut::detect
