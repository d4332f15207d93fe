#include "core/dsp/kernels/harmonic_loop.h"
#include "core/dsp/kernels/set.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {
namespace {

using Four [[gnu::vector_size(32)]] = double;
using FourAnywhere [[gnu::vector_size(32), gnu::aligned(8), gnu::may_alias]] = double;

STILLCUT_INLINE void get(Four& to, const double* from) {
  to = *reinterpret_cast<const FourAnywhere*>(from);
}
STILLCUT_INLINE void put(double* to, const Four& from) {
  *reinterpret_cast<FourAnywhere*>(to) = from;
}

}  // namespace

void parametric(const ParametricRun& run) noexcept {
  Four theta;
  Four past;
  Four sum;
  Four p[4];
  Four drift[4] = {};
  get(theta, run.ar->theta);
  get(past, run.ar->past);
  get(sum, run.thetaSum);
  for (std::size_t i = 0; i < 4; ++i) {
    get(p[i], run.ar->p + 4 * i);
    drift[i][i] = run.rv;
  }
  harmonicLoop(run.harmonics, [&](double residual) {
    const double e = run.scale * residual;
    const Four t = (p[0] * past[0] + p[1] * past[1]) + (p[2] * past[2] + p[3] * past[3]);
    const Four spread = past * t;
    const Four predicted = past * theta;
    const double gain = 1.0 / (run.rw + ((spread[0] + spread[2]) + (spread[1] + spread[3])));
    const double error = e - ((predicted[0] + predicted[2]) + (predicted[1] + predicted[3]));
    theta += t * (gain * error);
    for (std::size_t i = 0; i < 4; ++i) p[i] = (p[i] + drift[i]) - (t * t[i]) * gain;  // symmetric to the last bit
    past = Four{e, past[0], past[1], past[2]};
    sum += theta;
  });
  put(run.ar->theta, theta);
  put(run.ar->past, past);
  put(run.thetaSum, sum);
  for (std::size_t i = 0; i < 4; ++i) put(run.ar->p + 4 * i, p[i]);
}

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
