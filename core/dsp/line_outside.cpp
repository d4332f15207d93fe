#include "core/dsp/line_outside.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

constexpr std::size_t kLobe = 2;  // bins to either side that belong to a line

}  // namespace

LineOutside strongestOutside(std::span<const double> power, const HarmonicMask& mask, double binWidth, double amplitude,
                             int eta, const dsp::kernels::Kernels& kernels) noexcept {
  LineOutside found;
  if (mask.first() > mask.last()) return found;
  const std::span<const double> weight = mask.weights(eta);
  dsp::kernels::LineScan scan{power.data(), mask.frees().data(), weight.data(), mask.first(), mask.last()};
  kernels.scanLines(scan);
  if (!(scan.top > 0.0)) return found;
  found.bin = scan.place;  // a local maximum, not the flank of a harmonic
  double line = 0.0;
  for (std::size_t b = found.bin - std::min(found.bin, kLobe); b <= std::min(found.bin + kLobe, mask.last()); ++b) {
    if (mask.free(b)) line += power[b];
  }
  const std::size_t b = found.bin;
  // A bin of a harmonic beside it would pull the parabola over: then the other side alone tells.
  const double shift = !mask.free(b - 1)   ? hannShift(power[b], power[b + 1])
                       : !mask.free(b + 1) ? -hannShift(power[b], power[b - 1])
                                           : peakShift(power[b - 1], power[b], power[b + 1]);
  found.frequency = Hertz((static_cast<double>(b) + shift) * binWidth);
  found.amplitude = amplitude * std::sqrt(power[b]);
  found.part = line / scan.sum;
  found.purity = line / scan.freeSum;
  found.severity = line * weight[b] / (line * weight[b] + scan.forcedSum);
  return found;
}

}  // namespace stillcut::detect
