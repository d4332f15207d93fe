// Kernels: the loops that run once per sample, compiled for several instruction sets and chosen once, at prepare().
//
// Every set gives the same bits. Sums run in kLanes fixed lanes and are added up by one fixed tree, there is no
// fast-math and no contraction to fused multiply-adds, so a recording replays the same verdicts on any machine; a test
// holds every set that the machine has to the baseline bit for bit. (Fused multiply-adds would save nothing here: the
// loops wait for their recursions.) Kernels do not look at their numbers: callers check that results are finite.
//
// Rules for files in this folder that are compiled per set: nothing but kernels.h, lanes.h and <cstddef> is included,
// and everything lives in the set's own namespace, or an inline function compiled for one machine would be linked into
// the code of another.
// Thread: values and pure functions of their arguments; real-time.
#pragma once

#include <cstddef>

namespace stillcut::dsp::kernels {

inline constexpr std::size_t kLanes = 8;
constexpr std::size_t wholeLanes(std::size_t n) {
  return (n + kLanes - 1) / kLanes * kLanes;
}

enum class InstructionSet { Baseline, Avx2, Avx512 };

// One signal through harmonics that rotate with the spindle (Caliskan 2018 eq. 16-22 with a settled gain; van Dijk 2010
// eq. 19 with its leak in `turn`): rest = x - sum Re q; q = turn (q + gain rest).
struct HarmonicRun {
  const double* x = nullptr;
  double* residual = nullptr;  // before correction, times `after`
  std::size_t frames = 0;
  std::size_t lanes = 0;  // harmonics, in whole lanes; turn is 0 in those without a harmonic
  double* re = nullptr;   // state q
  double* im = nullptr;
  const double* rotationRe = nullptr;
  const double* rotationIm = nullptr;
  double gain = 0.0;
  double after = 1.0;
};

// Two signals through recursive filters of second order in a row (transposed direct form II), each through its own.
struct CascadeRun {
  const double* in[2] = {};
  double* out[2] = {};  // may be the same as in
  std::size_t frames = 0;
  std::size_t sections = 0;
  const double* coefficients[2] = {};  // b0, b1, b2, a1, a2 of each section
  double* state[2] = {};               // two of each section
};

// The same harmonics with their whole covariance (Caliskan 2018 eq. 16-22, R = 1), the same for all channels. In the
// frame that rotates with the spindle the states stand still and the regressors h = (cos, sin) turn.
struct CovarianceRun {
  const double* x = nullptr;  // [channel * stride + frame]
  std::ptrdiff_t stride = 0;
  double* residual = nullptr;  // after correction, [channel * residualStride + frame]
  std::ptrdiff_t residualStride = 0;
  std::size_t channels = 0;
  std::size_t frames = 0;
  std::size_t lanes = 0;               // of harmonics, whole; all vectors below are 2 * lanes long: cosines, then sines
  double* p = nullptr;                 // 2 lanes x 2 lanes; blocks of kLanes on and above the diagonal are kept
  double* ph = nullptr;                // P h of the frame to come
  double* h = nullptr;                 // of the frame to come; 0 where there is no harmonic
  const double* rotationRe = nullptr;  // lanes
  const double* rotationIm = nullptr;  // lanes
  const double* drift = nullptr;       // Q / R of each state; 0 where there is no harmonic
  double* states = nullptr;            // [channel * 2 lanes + n]: Re q, -Im q in that frame
  double* scratch = nullptr;           // 4 lanes
};

// One signal through a bank of filters of two sections each, lanes = bands:
// gain (1 - z^-2)^2 / ((1 + a1 z^-1 + a2 z^-2)(1 + b1 z^-1 + b2 z^-2)).
struct BankRun {
  const double* x = nullptr;
  std::size_t frames = 0;
  std::size_t lanes = 0;                 // bands, in whole lanes
  std::size_t stride = 0;                // of the rows below
  const double* coefficients = nullptr;  // rows gain, a1, a2, b1, b2
  double* state = nullptr;               // 4 rows
  double* const* out = nullptr;          // per lane; kLanes - 1 doubles after `frames` are overwritten
};

// Analogue band edges tan(pi f / rate) of each band to the coefficients of a BankRun: Butterworth, 4 poles.
struct BankDesign {
  const double* low = nullptr;
  const double* high = nullptr;
  std::size_t lanes = 0;
  std::size_t stride = 0;
  double* coefficients = nullptr;
};

// Sums of the energy operator over a stretch of one band (Caliskan 2018 eq. 26, 27); 4 lags before it must be there.
struct OperatorRun {
  const double* first = nullptr;
  std::size_t frames = 0;  // kLanes - 1 doubles after them are read, not used
  std::size_t lag = 1;
  double* signal = nullptr;      // += Psi[s]
  double* difference = nullptr;  // += Psi[y_{k-D}] + Psi[y_{k-2D}]
};

// Amplitude squared and frequency from those sums; a band that gives none keeps what it had.
struct SeparationRun {
  double* signal = nullptr;  // per lane; both are 0 afterwards
  double* difference = nullptr;
  std::size_t lanes = 0;
  double frames = 1.0;
  const double* scale = nullptr;  // rate / (2 pi lag)
  double* power = nullptr;
  double* frequency = nullptr;
  double* valid = nullptr;  // 1: of this stretch, 0: kept
};

// van Dijk 2010 eq. 25 with N_d = 4, the sign of 25c.
struct ArState {
  double theta[4] = {};
  double past[4] = {};  // scaled residuals, newest first
  double p[16] = {};    // Sigma, symmetric
};
// NLMS on the harmonics (eq. 19), then the Kalman filter on what they leave.
struct ParametricRun {
  HarmonicRun harmonics;  // `after` is 1
  double scale = 0.0;     // of the residual, for the Kalman filter
  double rv = 0.0;
  double rw = 1.0;
  ArState* ar = nullptr;
  double* thetaSum = nullptr;  // 4, += theta of every frame
};

// What does not repeat with the revolution of one signal, by fractional delays of kDelayTaps taps: with now = x(t),
// one = x(t - T), two = x(t - 2T), each read at or before the frame that its pointer names,
//   difference = (now - 2 one + two) / sqrt(6), news = (now - (one + two) / 2) / sqrt(1.5).
inline constexpr std::size_t kDelayTaps = 16;
struct RevolutionDifferenceRun {
  const double* now = nullptr;  // of the first frame
  const double* one = nullptr;  // newest frame under the taps for the first frame, kDelayTaps - 1 before it are read
  const double* two = nullptr;
  const double* oneTaps = nullptr;
  const double* twoTaps = nullptr;
  std::size_t frames = 0;
  double* difference = nullptr;
  double* innovation = nullptr;  // may be null
};

// The transform of 2 n real numbers from that of the n complex ones that they make, even ones re and odd ones im:
// X_k = (Z_k + Z*_(n-k)) / 2 - j e^(-j pi k / n) (Z_k - Z*_(n-k)) / 2. All interleaved.
struct UnfoldRun {
  const double* folded = nullptr;      // n
  const double* rotationRe = nullptr;  // e^(-j pi k / n) / 2, k = 0 .. n / 2 and kLanes more
  const double* rotationIm = nullptr;
  std::size_t n = 0;
  double* out = nullptr;  // n + 1
};

// Auto and cross spectra of two transforms (interleaved re, im), and their coherence.
struct CoherenceRun {
  const double* x = nullptr;
  const double* y = nullptr;
  std::size_t bins = 0;  // in whole lanes
  double part = 1.0;     // of the new segment in the averages
  bool welch = true;     // |Gxy|^2 / (Gx Gy), else Re(Gxy)^2 / (Gx Gy)
  double* gx = nullptr;
  double* gy = nullptr;
  double* crossRe = nullptr;
  double* crossIm = nullptr;
  double* coherence = nullptr;
  double* cross = nullptr;  // |Gxy|, to 1e-10
};

// Mean over two bins to either side, then exp(-(1 - g) / above) over the knee and factor exp(-(1 - g) / below) up to
// it, times weight. The two outermost bins are left as they are.
struct SharpenRun {
  const double* coherence = nullptr;
  const double* weight = nullptr;
  std::size_t bins = 0;
  double knee = 0.5;
  double above = 1.0;
  double below = 1.0;
  double factor = 1.0;
  double* out = nullptr;
};

// 1 for the bins first .. last that lie `halfWidth` + order `spread` bins or more from every harmonic, at most 0.45 of
// the way to the next; 0 for all others.
struct MaskRun {
  double spacing = 1.0;  // of the harmonics, in bins
  double spread = 0.0;
  double halfWidth = 0.0;
  std::size_t first = 1;
  std::size_t last = 0;
  std::size_t bins = 0;  // in whole lanes
  double* free = nullptr;
};

// Bins first .. last of a power spectrum; free is 1 or 0, bins first - 1 and last + 1 exist.
struct LineScan {
  const double* power = nullptr;
  const double* free = nullptr;
  const double* weight = nullptr;
  std::size_t first = 1;
  std::size_t last = 0;
  double sum = 0.0;        // of the power
  double freeSum = 0.0;    // between the harmonics
  double forcedSum = 0.0;  // weighted, on the harmonics
  double top = 0.0;        // largest free local maximum
  std::size_t place = 0;   // its bin, the first of equals; 0: none
};

// Bins first .. last of a cross spectrum and its coherence ratio.
struct CrossScan {
  const double* cross = nullptr;
  const double* ratio = nullptr;
  const double* free = nullptr;
  std::size_t first = 0;
  std::size_t last = 0;
  double freeSum = 0.0;       // of cross between the harmonics
  double largestRatio = 0.0;  // there
  double top = 0.0;           // largest product of both there
  std::size_t place = 0;      // its bin, the first of equals; 0: none
};

// Two signals through the same recursive filter of one sample, in transposed form: each state moves on by one place and
// takes up what the newest input and output add to all later outputs; the first place is the new output. Nothing is
// summed over taps, so no output waits for more than one addition.
struct PairRun {
  const double* forward = nullptr;   // both `taps` long, in whole lanes
  const double* backward = nullptr;  //
  std::size_t taps = 0;
  double* state[2] = {};  // taps and kLanes zeros
  double in[2] = {};      // of the sample before
  double out[2] = {};     // of the sample before, then of this one
};

// Leakage of one signal and its copy with control into up to `lanes` lines: turns the oscillators sample by sample and
// adds what the signals hold of them.
struct LineRun {
  const double* x = nullptr;
  const double* y = nullptr;
  std::size_t frames = 0;
  std::size_t lanes = 0;  // lines, in whole lanes
  double* re = nullptr;   // oscillators
  double* im = nullptr;
  const double* rotationRe = nullptr;
  const double* rotationIm = nullptr;
  double* xRe = nullptr;  // += x times oscillator
  double* xIm = nullptr;
  double* yRe = nullptr;
  double* yIm = nullptr;
};

// What a signal holds of one line under a periodic Hann window: sum hann(n) x(n) line^n.
struct HannRun {
  const double* x = nullptr;
  std::size_t frames = 0;
  double lineRe = 1.0;  // unit numbers: turn per frame of the line (against its own sense), of the window
  double lineIm = 0.0;
  double windowRe = 1.0;
  double windowIm = 0.0;
  double re = 0.0;  // the sum
  double im = 0.0;
};

struct Kernels {
  InstructionSet set = InstructionSet::Baseline;
  // turn^1 .. turn^n of the unit number (c, s).
  void (*powers)(double c, double s, std::size_t n, double* re, double* im) noexcept = nullptr;
  // q *= turn
  void (*turn)(double* re, double* im, const double* rotationRe, const double* rotationIm,
               std::size_t lanes) noexcept = nullptr;
  void (*harmonics)(const HarmonicRun&) noexcept = nullptr;
  // The same for two signals whose harmonics rotate alike, frame by frame side by side: neither waits for the other.
  void (*harmonicPair)(const HarmonicRun&, const HarmonicRun&) noexcept = nullptr;
  void (*cascade)(const CascadeRun&) noexcept = nullptr;
  void (*covariance)(const CovarianceRun&) noexcept = nullptr;
  // ph = P h from the kept blocks
  void (*covarianceTimes)(const CovarianceRun&) noexcept = nullptr;
  void (*parametric)(const ParametricRun&) noexcept = nullptr;
  void (*turns)(const RevolutionDifferenceRun&) noexcept = nullptr;
  // out = a b
  void (*multiply)(const double* a, const double* b, double* out, std::size_t n) noexcept = nullptr;
  double (*sum)(const double* x, std::size_t n) noexcept = nullptr;
  // 0 where none is larger
  double (*largest)(const double* x, std::size_t n) noexcept = nullptr;
  // out += scale a
  void (*addScaled)(double scale, const double* a, double* out, std::size_t n) noexcept = nullptr;
  // |z|^2 of n complex numbers, interleaved
  void (*squares)(const double* z, double* out, std::size_t n) noexcept = nullptr;
  void (*unfold)(const UnfoldRun&) noexcept = nullptr;
  void (*maskHarmonics)(const MaskRun&) noexcept = nullptr;
  void (*scanLines)(LineScan&) noexcept = nullptr;
  void (*scanCross)(CrossScan&) noexcept = nullptr;
  void (*coherence)(const CoherenceRun&) noexcept = nullptr;
  void (*sharpen)(const SharpenRun&) noexcept = nullptr;
  void (*bank)(const BankRun&) noexcept = nullptr;
  void (*designBank)(const BankDesign&) noexcept = nullptr;
  void (*operatorSums)(const OperatorRun&) noexcept = nullptr;
  void (*separate)(const SeparationRun&) noexcept = nullptr;
  // sum weight (re^2 + im^2), whole lanes
  double (*weightedPower)(const double* re, const double* im, const double* weight,
                          std::size_t lanes) noexcept = nullptr;
  // sum a b, whole lanes
  double (*tapSum)(const double* a, const double* b, std::size_t n) noexcept = nullptr;
  // a = keep a + step b over `taps` values; the rest of the last lanes becomes 0
  void (*tapSteer)(double* a, double keep, double step, const double* b, std::size_t taps) noexcept = nullptr;
  // The same, b being one new value and then older ones, newest first. A value that was written a moment ago and is
  // read back as part of a vector holds the processor up for longer than the sum takes. older[-1] must be readable.
  double (*newTapSum)(const double* a, double b, const double* older, std::size_t n) noexcept = nullptr;
  void (*newTapSteer)(double* a, double keep, double step, double b, const double* older,
                      std::size_t taps) noexcept = nullptr;
  void (*filterPair)(PairRun&) noexcept = nullptr;
  void (*lineSums)(const LineRun&) noexcept = nullptr;
  void (*demodulate)(HannRun&) noexcept = nullptr;
};

}  // namespace stillcut::dsp::kernels
