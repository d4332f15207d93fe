// The adaptive controller of one axis (Ford 2013 section "Adaptive control theory"; Kuo and Morgan 1996): leaky
// filtered-x LMS with three choices of the reference. Equations and the automatic step:
// resources/manual/developers/laws.md#fxlms. Thread: one; everything but prepare() is real-time.
#pragma once

#include <vector>

#include "core/active/error_weighting.h"
#include "core/active/lms.h"
#include "core/active/path_filter.h"
#include "core/dsp/kernels/aligned.h"

namespace stillcut::active {

enum class Reference { Feedforward, ErrorFeedback, InternalModel };

struct FxlmsOptions {
  LmsOptions filter;  // step: mu, or with `normalised` the fraction of the automatic bound
  Reference reference = Reference::InternalModel;
  Emphasis emphasis;
};

class FxlmsController {
 public:
  // `model` has passed checkPath().
  void prepare(const FxlmsOptions& options, const PathModel& model, Hertz rate);
  void reset() noexcept;
  void setStep(double step) noexcept { options_.filter.step = step; }  // no jump: weights stay
  void setLeak(double leak) noexcept { options_.filter.leak = leak; }

  // Once a sample: the error just read (and the reference, for Feedforward) give the output wanted.
  double process(double error, double reference = 0.0) STILLCUT_RT;
  // And what was really written of it and of what was added to it, after every limit.
  void written(double output, double added = 0.0) STILLCUT_RT;
  // Another model of the path, of the same lengths and delay; the weights stay and follow it.
  void renew(const PathModel& model) STILLCUT_RT { path_.renew(model); }

  // The disturbance as the model sees it, e + s^ * y: what the error would be without control.
  double disturbance() const noexcept { return disturbance_; }
  // The largest step that is stable in the mean at the filtered reference's power; 0 in silence.
  double largestStep() const noexcept;
  const double* weights() const noexcept { return weights_.data(); }
  int taps() const noexcept { return options_.filter.taps; }

 private:
  void hear(double filtered) STILLCUT_RT;

  FxlmsOptions options_;
  dsp::kernels::Kernels kernels_;
  dsp::kernels::LaneValues weights_;
  DelayLine reference_, filtered_;  // the second but for its newest value
  double filteredNow_ = 0.0;
  PathPair path_;  // s^ * y and s^ * x
  ErrorWeighting errorWeight_, referenceWeight_;
  double delay_ = 0.0;     // of the model and the weighting [samples]
  double power_ = 0.0;     // of the filtered reference, the larger of one filter length and about 8
  double inFilter_ = 0.0;  // sum of its squares over one filter length
  double renewed_ = 0.0;   // the same sum begun anew once a filter length, so that no rounding stays
  int sinceRenewal_ = 0;
  int unheard_ = 0;          // samples until the power is that of a whole filter, delay included: no step before
  double errorPower_ = 0.0;  // over about 8 filter lengths
  double forget_ = 0.0;
  double disturbance_ = 0.0;
  double wanted_ = 0.0;
  double error_ = 0.0;
};

}  // namespace stillcut::active
