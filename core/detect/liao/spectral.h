// Detector "spectral": Liao, Young 1996, "A new on-line spindle speed regulation strategy for chatter control",
// section 3.
//
// The power spectrum of the newest window; the largest line outside the spindle and tooth-passing harmonics, over a
// threshold, is chatter, and its place f_c.
//
// Departures, with their evidence:
// - The paper's 512 points at 1 kHz are 0.51 s, eight turns at its 950 rev/min. Here the window is 28 turns, at most
//   1.5 s, with 8 windows overlapping: a Hann line is four bins wide, so 8 turns leave nothing between two spindle
//   harmonics. That is 0.15 s at 11 000 rev/min; growth shows before the window is full of it.
// - The paper's threshold is a number on its force sensor. Here the strongest free line's part of the vibration is
//   tested for growth above its learned floor (onset_test.h). `spectral.threshold` fixes an amplitude instead.
// - A line is a local maximum, seen in two spectra in a row, and holds a good part of what lies between the harmonics
//   (the flank of a harmonic, chips and knocks do not).
// - Works on any sensor, every channel on its own; the loudest evidence decides.
// Known limits: harmonics folded back by a missing anti-alias filter are not masked; chatter within 2 bins (0.071
// orders) of a spindle harmonic is masked; period doubling with even teeth too. Thread: worker. See detector.h.
#pragma once

#include <vector>

#include "core/detect/alarm_state_machine.h"
#include "core/detect/detector.h"
#include "core/detect/growth/onset_test.h"
#include "core/dsp/frame_ring.h"
#include "core/dsp/harmonic_mask.h"
#include "core/dsp/line_outside.h"
#include "core/dsp/spectrum.h"

namespace stillcut::detect {

inline constexpr config::ParamDecl kSpeWindow =
    config::locked(config::autoParam("spectral.window", "Window", "s", 0.005, 10.0,
                                     "Length of the spectrum; auto: 28 turns, at most 1.5 s (paper: 0.512 s)"));
inline constexpr config::ParamDecl kSpeOverlap = config::locked(config::integerParam(
    "spectral.overlap", "Spectra per window", 8, 1, 64, "A new spectrum is taken this often within one window"));
inline constexpr config::ParamDecl kSpeThreshold =
    config::autoParam("spectral.threshold", "Line threshold", "", 1e-12, 1e12,
                      "Amplitude (unit of the sensor) of a line that is chatter; auto: growth above the learned floor");
inline constexpr config::ParamDecl kSpeMask =
    config::realParam("spectral.mask", "Mask", "", 2.25, 1.0, 10.0, "Half width of the mask on a harmonic, in bins");
inline constexpr config::ParamDecl kSpePurity =
    config::realParam("spectral.purity", "Purity", "", 0.3, 0.0, 1.0,
                      "Part of the power between the harmonics that a chatter line holds at least");
inline constexpr config::ParamDecl kSpeEvidence =
    config::realParam("spectral.evidence", "Evidence for onset", "", 12.0, 1.0, 100.0,
                      "Log-likelihood ratio of growth against the learned floor that makes an onset (onset_test.h)");
inline constexpr config::ParamDecl kSpeChatter = config::realParam(
    "spectral.chatter", "Chatter ratio", "", 0.2, 0.01, 1.0, "Energy ratio from which a cut is in full chatter");

config::ParamTable spectralParams();

class SpectralDetector final : public Detector {
 public:
  DetectorInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  Verdict process(const ConditionedBlock& block) override;
  void retune(const config::ParamSet& params) override;
  double chosen(const config::ParamDecl& decl) const override;
  AutoValueTable autoValues() const override;
  AutoValue own(std::size_t index) const override { return own_.read(index); }
  void reset() override;

  int window() const { return static_cast<int>(ring_.window()); }

 private:
  struct SpectralChannel {
    OnsetTest onset;
    LineOutside line;
    int eta = 0;
  };
  void restart();
  void leaveCut();
  void analyse(const ConditionedBlock& block);
  void look(SpectralChannel& c, int index);
  bool fromEntry(const LineOutside& line, double turns);
  Verdict verdict(const ConditionedBlock& block) const;
  void tellOwn();

  AutoValues own_;
  dsp::kernels::Kernels kernels_;
  AlarmStateMachine judge_;
  FrameRing ring_;
  HarmonicMask mask_;
  dsp::Spectrum spectrum_;
  std::vector<double> power_;
  std::vector<SpectralChannel> channels_;
  double rate_ = 0.0;
  int hop_ = 1;
  double maskBins_ = 2.25;
  double threshold_ = 0.0;  // 0: automatic
  double purity_ = 0.3;
  double chatterRatio_ = 0.2;

  long sinceLook_ = 0;
  double steadySeconds_ = 0.0;
  double highTurns_ = 0.0;
  Hertz highLine_{};
  std::size_t leading_ = 0;
};

}  // namespace stillcut::detect
