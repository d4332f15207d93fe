#include "core/active/identify_path.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/active/lms.h"
#include "core/active/path_filter.h"
#include "core/dsp/kernels/choose.h"
#include "core/dsp/spectrum.h"
#include "core/milling/simulation/noise.h"

namespace stillcut::active {

namespace {

constexpr int kSegment = 512;
constexpr double kCoherent = 0.8;
constexpr double kUseless = 0.9;  // a model that leaves so much of the reading unexplained is no model

double meanSquare(std::span<const double> x) {
  double sum = 0.0;
  for (double v : x) sum += v * v;
  return sum / static_cast<double>(x.size());
}

// rms of the reading less the model's prediction over that of the reading.
double residualOf(const PathModel& model, std::span<const double> output, std::span<const double> reading) {
  PathFilter filter;
  filter.prepare(model);
  double left = 0.0;
  for (std::size_t n = 0; n < output.size(); ++n) {
    const double rest = reading[n] - filter.arrive();
    left += rest * rest;
    filter.push(output[n]);
  }
  return std::sqrt(left / static_cast<double>(output.size()) / meanSquare(reading));
}

// Where the reading begins to follow the output, from their cross correlation: the first lag that holds a tenth of the
// largest and stands out of what unrelated signals of this length would show; two samples less, so that the foot of the
// response is in the filter.
int findDelay(std::span<const double> output, std::span<const double> reading, int most) {
  constexpr double kFoot = 0.1;
  constexpr double kOutstanding = 5.0;  // standard deviations
  constexpr int kEarlier = 2;
  const dsp::kernels::Kernels kernels = dsp::kernels::bestKernels();
  const std::size_t lags = std::min(static_cast<std::size_t>(most) + 1, output.size() / 2);
  const std::size_t n = (output.size() - lags) / dsp::kernels::kLanes * dsp::kernels::kLanes;
  std::vector<double> correlation(lags);
  for (std::size_t k = 0; k < lags; ++k) {
    correlation[k] = std::abs(kernels.tapSum(&reading[lags], &output[lags - 1 - k], n));
  }
  const double largest = *std::ranges::max_element(correlation);
  const double chance = std::sqrt(meanSquare(output) * meanSquare(reading) * static_cast<double>(n));
  const double foot = std::max(kFoot * largest, std::min(kOutstanding * chance, largest));
  const auto first = std::ranges::find_if(correlation, [&](double c) { return c >= foot; });
  return std::max(0, static_cast<int>(first - correlation.begin()) - kEarlier);
}

PathModel learn(std::span<const double> output, std::span<const double> reading, const IdentifierOptions& options,
                int passes) {
  PathIdentifier identifier;
  identifier.prepare(options);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t n = 0; n < output.size(); ++n) {
      identifier.reading(reading[n]);
      identifier.output(output[n]);
    }
  }
  return identifier.model();
}

// The finite response of least squares: the normal equations over the whole record, lightly loaded where the output
// teaches nothing.
PathModel leastSquares(std::span<const double> output, std::span<const double> reading, int taps, int delay) {
  constexpr double kLoading = 1e-6;
  const auto late = static_cast<std::size_t>(delay) + 1;
  const std::size_t first = late + static_cast<std::size_t>(taps);
  Eigen::VectorXd own(taps), cross(taps);
  for (int k = 0; k < taps; ++k) {
    const auto lag = static_cast<std::size_t>(k);
    double a = 0.0, c = 0.0;
    for (std::size_t n = first; n < output.size(); ++n) {
      a += output[n] * output[n - lag];
      c += reading[n] * output[n - late - lag];
    }
    own[k] = a;
    cross[k] = c;
  }
  own[0] *= 1.0 + kLoading;
  Eigen::MatrixXd toeplitz(taps, taps);
  for (int i = 0; i < taps; ++i) {
    for (int j = 0; j < taps; ++j) toeplitz(i, j) = own[std::abs(i - j)];
  }
  const Eigen::VectorXd solved = toeplitz.ldlt().solve(cross);
  return {{solved.begin(), solved.end()}, {}, delay};
}

// What a path makes of noise.
struct Record {
  std::vector<double> output, reading;
};
Record asFromNoise(const PathModel& response, double rms, std::size_t samples) {
  PathFilter path;
  path.prepare(response);
  milling::NoiseSource noise(1);
  Record made;
  for (std::size_t n = 0; n < samples; ++n) {
    made.reading.push_back(path.arrive());
    made.output.push_back(rms * noise.normal());
    path.push(made.output.back());
  }
  return made;
}

// Learns in units in which output and reading have the same size: the recursive step treats both alike.
PathModel learnScaled(std::span<const double> output, std::span<const double> reading, const IdentifierOptions& options,
                      int passes) {
  const double perOutput = 1.0 / std::sqrt(meanSquare(output));
  const double perReading = 1.0 / std::sqrt(meanSquare(reading));
  std::vector<double> y(output.begin(), output.end());
  std::vector<double> r(reading.begin(), reading.end());
  for (double& v : y) v *= perOutput;
  for (double& v : r) v *= perReading;
  PathModel model = learn(y, r, options, passes);
  for (double& a : model.forward) a *= perOutput / perReading;
  return model;
}

// Welch's estimate, half overlapped. What the path is late by is taken out first and turned back in the result: a
// segment of the output would else be compared with what the segment before it had done.
void measure(std::span<const double> output, std::span<const double> reading, int delay, Hertz rate,
             PathReport& report) {
  const auto late = static_cast<std::size_t>(delay);
  reading = reading.subspan(late);
  output = output.first(reading.size());
  dsp::Spectrum y;
  dsp::Spectrum r;
  y.prepare(kSegment, rate, dsp::WindowKind::Hann);
  r.prepare(kSegment, rate, dsp::WindowKind::Hann);
  const auto bins = static_cast<std::size_t>(y.bins());
  std::vector<double> yy(bins), rr(bins);
  std::vector<std::complex<double>> yr(bins);
  for (std::size_t at = 0; at + kSegment <= output.size(); at += kSegment / 2) {
    y.transform(output.subspan(at, kSegment));
    r.transform(reading.subspan(at, kSegment));
    for (std::size_t k = 0; k < bins; ++k) {
      yy[k] += std::norm(y.values()[k]);
      rr[k] += std::norm(r.values()[k]);
      yr[k] += std::conj(y.values()[k]) * r.values()[k];
    }
  }
  for (std::size_t k = 1; k + 1 < bins; ++k) {
    if (!(yy[k] > 0.0) || !(rr[k] > 0.0)) continue;
    const double frequency = static_cast<double>(k) * y.binWidth();
    report.frequency.push_back(frequency);
    report.measured.push_back(yr[k] / yy[k] * std::polar(1.0, -kTwoPi * frequency * delay / rate.value));
    report.coherence.push_back(std::norm(yr[k]) / (yy[k] * rr[k]));
  }
}

void judge(const PathModel& model, Hertz rate, PathReport& report) {
  for (std::size_t k = 0; k < report.frequency.size(); ++k) {
    const Hertz f(report.frequency[k]);
    report.modelled.push_back(model.response(f, rate));
    if (report.coherence[k] < kCoherent) continue;
    const double error = std::abs(phaseError(model, report.measured[k], f, rate));
    if (error <= report.worstPhase) continue;
    report.worstPhase = error;
    report.worstFrequency = f.value;
  }
  report.phaseMargin = 0.5 * std::numbers::pi - report.worstPhase;
}

}  // namespace

Result<IdentifiedPath> identifyPath(std::span<const double> output, std::span<const double> reading, Hertz rate,
                                    const PathRequest& request, const std::string& where) {
  if (output.size() != reading.size()) return Error{where, message("output and reading differ in length")};
  if (output.size() < 4 * kSegment) {
    return Error{where, message("too short to identify a path from"),
                 message("at least %1 samples", std::to_string(4 * kSegment))};
  }
  const auto finite = [](std::span<const double> x) {
    return std::all_of(x.begin(), x.end(), [](double v) { return std::isfinite(v); });
  };
  if (!finite(output) || !finite(reading)) return Error{where, message("holds a value that is not finite")};
  if (meanSquare(output) <= 0.0) return Error{where, message("nothing was written to the actuator")};
  if (meanSquare(reading) <= 0.0) return Error{where, message("the sensor read nothing"), message("is it connected?")};

  IdentifiedPath found;
  IdentifierOptions recursive = request.filter;
  recursive.delay = findDelay(output, reading, request.mostDelay);
  IdentifierOptions finiteResponse = recursive;
  Record made;
  if (request.sweep) {
    constexpr int kTaps = 256;
    made = asFromNoise(leastSquares(output, reading, kTaps, recursive.delay), std::sqrt(meanSquare(output)),
                       output.size());
  }
  const std::span<const double> y = request.sweep ? made.output : output;
  const std::span<const double> r = request.sweep ? made.reading : reading;
  finiteResponse.backward = 0;
  found.model = learnScaled(y, r, finiteResponse, request.passes);
  found.report.residual = residualOf(found.model, output, reading);
  if (request.filter.backward > 0) {
    const PathModel model = learnScaled(y, r, recursive, request.passes);
    if (checkPath(model, where).ok()) {
      const double residual = residualOf(model, output, reading);
      if (residual < found.report.residual) {
        found.model = model;
        found.report.residual = residual;
      }
    }
  }
  if (Status ok = checkPath(found.model, where); !ok) return ok.error();
  if (!(found.report.residual < kUseless)) {
    return Error{where, message("the reading does not follow the actuator"),
                 message("noise, or a sensor that is not on the table")};
  }
  measure(output, reading, found.model.delay, rate, found.report);
  judge(found.model, rate, found.report);
  return found;
}

Result<PathModel> modelOf(const std::vector<double>& impulse, const PathModel& like, const std::string& where) {
  constexpr std::size_t kSamples = 20000;
  constexpr int kPasses = 4;
  const Record made = asFromNoise({impulse, {}, 0}, 1.0, kSamples);
  IdentifierOptions options = PathRequest{}.filter;
  options.forward = static_cast<int>(like.forward.size());
  options.backward = static_cast<int>(like.backward.size());
  options.delay = like.delay;
  const PathModel model = learnScaled(made.output, made.reading, options, kPasses);
  if (Status ok = checkPath(model, where); !ok) return ok.error();
  if (!(residualOf(model, made.output, made.reading) < kUseless)) return Error{where, message("fits no path")};
  return model;
}

}  // namespace stillcut::active
