// What one instruction set's files define. See kernels.h. Real-time, any thread.
#pragma once

#include "core/dsp/kernels/lanes.h"

namespace stillcut::dsp::kernels::STILLCUT_SET {

void powers(double c, double s, std::size_t n, double* re, double* im) noexcept;
void turn(double* re, double* im, const double* rotationRe, const double* rotationIm, std::size_t lanes) noexcept;
void harmonics(const HarmonicRun& run) noexcept;
void harmonicPair(const HarmonicRun& first, const HarmonicRun& second) noexcept;
void cascade(const CascadeRun& run) noexcept;
double weightedPower(const double* re, const double* im, const double* weight, std::size_t lanes) noexcept;
void covariance(const CovarianceRun& run) noexcept;
void covarianceTimes(const CovarianceRun& run) noexcept;
void turns(const RevolutionDifferenceRun& run) noexcept;
void parametric(const ParametricRun& run) noexcept;
void multiply(const double* a, const double* b, double* out, std::size_t n) noexcept;
double sum(const double* x, std::size_t n) noexcept;
double largest(const double* x, std::size_t n) noexcept;
void addScaled(double scale, const double* a, double* out, std::size_t n) noexcept;
void squares(const double* z, double* out, std::size_t n) noexcept;
void unfold(const UnfoldRun& run) noexcept;
void maskHarmonics(const MaskRun& run) noexcept;
void scanLines(LineScan& scan) noexcept;
void scanCross(CrossScan& scan) noexcept;
void coherence(const CoherenceRun& run) noexcept;
void sharpen(const SharpenRun& run) noexcept;
void bank(const BankRun& run) noexcept;
void designBank(const BankDesign& design) noexcept;
void operatorSums(const OperatorRun& run) noexcept;
void separate(const SeparationRun& run) noexcept;
double tapSum(const double* a, const double* b, std::size_t n) noexcept;
void tapSteer(double* a, double keep, double step, const double* b, std::size_t taps) noexcept;
double newTapSum(const double* a, double b, const double* older, std::size_t n) noexcept;
void newTapSteer(double* a, double keep, double step, double b, const double* older, std::size_t taps) noexcept;
void filterPair(PairRun& run) noexcept;
void lineSums(const LineRun& run) noexcept;
void demodulate(HannRun& run) noexcept;

}  // namespace stillcut::dsp::kernels::STILLCUT_SET
