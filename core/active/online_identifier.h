// On-line identification of the secondary path while the control is on (Ford 2013, further work 4; Eriksson and Allie
// 1989 for the auxiliary noise). White noise v (small against the stroke) is added to the output. Where the control
// works, it works on v as well, so that what v does to the error alone is the path as the old model has it, to first
// order. So v is an instrument: with e = d - s * y, and d unrelated to v, the correlations of v with the error and with
// the whole output obey c_ve = -s * c_vy, whatever the control makes of v; s follows by dividing the one by the other.
// The cut's lines would drown both: a linear predictor takes out of e and y what it can tell from values older than all
// the lags that are identified, which the lines are and v's own doing is not.
// Thread: next(), hear() and wrote() on the loop's thread, real-time; takeEstimate() on one other.
#pragma once

#include <vector>

#include "core/active/delay_line.h"
#include "core/active/lms.h"
#include "core/active/path_model.h"
#include "core/milling/simulation/noise.h"
#include "core/rt/triple_buffer.h"

namespace stillcut::active {

struct OnlineOptions {
  double rms = 0.0;     // of the auxiliary noise, in the unit of the output; 0: off
  int lags = 256;       // of the path's impulse response that are identified
  Seconds window{4.0};  // an estimate each
  std::uint64_t seed = 7;
};

class OnlineIdentifier {
 public:
  void prepare(const OnlineOptions& options, Hertz rate);
  void reset() noexcept;
  bool on() const noexcept { return options_.rms > 0.0; }

  // Once a sample, in this order: the error just read; what to add to the output; what was written of output and noise.
  void hear(double error) STILLCUT_RT;
  double next() STILLCUT_RT;
  void wrote(double output) STILLCUT_RT;

  // The impulse response of the path, s(1), s(2) ..., by the newest whole window; null: none since the last call.
  const std::vector<double>* takeEstimate();

 private:
  // What a linear predictor from values `delay` old and older leaves of a signal.
  class PredictionErrorFilter {
   public:
    void prepare(int taps, int delay);
    void reset() noexcept;
    double process(double x) STILLCUT_RT;

   private:
    Lms predictor_;
    DelayLine past_;
    int delay_ = 0;
  };
  struct Sums {
    std::vector<double> error, output;  // correlations with v, lag by lag
    double power = 0.0;                 // of v
  };

  OnlineOptions options_;
  dsp::kernels::Kernels kernels_;
  milling::NoiseSource noise_{7};
  DelayLine added_;  // v, newest first
  PredictionErrorFilter error_, output_;
  Sums sums_;
  std::size_t samples_ = 0, window_ = 1, settle_ = 0;
  double now_ = 0.0;
  rt::TripleBuffer<Sums> whole_;
  std::vector<double> impulse_;
};

}  // namespace stillcut::active
