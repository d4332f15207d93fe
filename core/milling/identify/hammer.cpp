#include "core/milling/identify/hammer.h"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/FFT>

#include "core/base/units.h"
#include "core/milling/identify/hammer_hits.h"

namespace stillcut::identify {
namespace {

using Spectrum = std::vector<std::complex<double>>;

// The hammer's spectrum carries information down to this share of its largest line (-45 dB: a sensor of 16 bits still
// leaves some 50 dB of range below that).
constexpr double kUsableShare = 0.0056;

Status checkRecord(const HammerRecord& record, const HammerOptions& options) {
  if (!(record.rate > 0.0) || !std::isfinite(record.rate)) {
    return Error{record.source, message("has no sampling rate")};
  }
  if (record.force.size() < 16 || record.force.size() != record.response.size()) {
    return Error{record.source, message("needs at least 16 samples of force and as many of response")};
  }
  const auto finite = [](double v) { return std::isfinite(v); };
  if (!std::all_of(record.force.begin(), record.force.end(), finite) ||
      !std::all_of(record.response.begin(), record.response.end(), finite)) {
    return Error{record.source, message("holds a value that is not finite")};
  }
  const bool sane = options.trigger > 0.0 && options.trigger < 1.0 && options.doubleHit > 0.0 &&
                    options.exponentialEnd > 0.0 && options.exponentialEnd <= 1.0 && options.forceWindow >= 0.0 &&
                    options.duration >= 0.0 && options.separation > 0.0;
  if (!sane) return Error{record.source, message("an option of the hammer analysis is out of range")};
  return Done{};
}

// Lengths whose prime factors are 2, 3 and 5 keep the transform quick.
std::size_t roundLength(std::size_t n) {
  for (;; ++n) {
    std::size_t rest = n;
    for (const std::size_t p : {2u, 3u, 5u}) {
      while (rest % p == 0) rest /= p;
    }
    if (rest == 1 && n % 2 == 0) return n;
  }
}

// Samples begin..end without the mean of what came before the pulse, zeros behind.
std::vector<double> cutOut(const std::vector<double>& signal, const FoundHit& hit, std::size_t quietEnd,
                           std::size_t length) {
  double mean = 0.0;
  if (quietEnd > hit.begin) {
    for (std::size_t i = hit.begin; i < quietEnd; ++i) mean += signal[i];
    mean /= static_cast<double>(quietEnd - hit.begin);
  }
  std::vector<double> out(length, 0.0);
  for (std::size_t i = hit.begin; i < hit.end; ++i) out[i - hit.begin] = signal[i] - mean;
  return out;
}

void applyForceWindow(std::vector<double>& force, std::size_t peak, std::size_t hold) {
  const std::size_t taper = std::max<std::size_t>(hold / 2, 1);
  for (std::size_t i = peak + hold; i < force.size(); ++i) {
    const double t = static_cast<double>(i - peak - hold) / static_cast<double>(taper);
    force[i] *= t < 1.0 ? 0.5 * (1.0 + std::cos(0.5 * kTwoPi * t)) : 0.0;
  }
}

void applyDecay(std::vector<double>& signal, double decay, double rate) {
  for (std::size_t i = 0; i < signal.size(); ++i) signal[i] *= std::exp(-decay * static_cast<double>(i) / rate);
}

struct Sums {
  std::vector<double> force, response;  // auto spectra
  Spectrum cross;                       // conj(F) X
};

void accumulate(Sums& sums, const std::vector<double>& force, const std::vector<double>& response) {
  Eigen::FFT<double> fft;
  Spectrum f;
  Spectrum x;
  fft.fwd(f, force);
  fft.fwd(x, response);
  const std::size_t lines = force.size() / 2 + 1;
  sums.force.resize(lines, 0.0);
  sums.response.resize(lines, 0.0);
  sums.cross.resize(lines, 0.0);
  for (std::size_t k = 0; k < lines; ++k) {
    sums.force[k] += std::norm(f[k]);
    sums.response[k] += std::norm(x[k]);
    sums.cross[k] += std::conj(f[k]) * x[k];
  }
}

// Lines with no force at all would divide by nothing: the spectrum ends before them.
Frf estimate(const Sums& sums, double resolution, int averages) {
  Frf frf;
  frf.quantity = FrfQuantity::Accelerance;
  const double strongest = *std::max_element(sums.force.begin(), sums.force.end());
  bool usable = true;
  for (std::size_t k = 0; k < sums.force.size(); ++k) {
    if (sums.force[k] < strongest * kUsableShare * kUsableShare) usable = false;
    if (sums.force[k] < strongest * 1e-20) break;
    frf.frequency.push_back(static_cast<double>(k) * resolution);
    frf.value.push_back(sums.cross[k] / sums.force[k]);
    if (usable) frf.usableTo = frf.frequency.back();
    if (averages < 2) continue;
    const double both = sums.force[k] * sums.response[k];
    frf.coherence.push_back(both > 0.0 ? std::min(1.0, std::norm(sums.cross[k]) / both) : 0.0);
  }
  return frf;
}

void judge(std::vector<FoundHit>& hits, const HammerOptions& options, HammerResult& result) {
  int number = 0;
  for (FoundHit& found : hits) {
    ++number;
    Hit& hit = found.hit;
    hit.used = !hit.overload && (!hit.doubleHit || options.useDoubleHits);
    const std::string name = "hit " + std::to_string(number);
    if (hit.overload) result.remarks.push_back(name + " left out: overload");
    if (hit.doubleHit) {
      result.remarks.push_back(name + (hit.used ? " is a double hit, used as asked" : " left out: double hit"));
    }
    if (hit.used) ++result.averages;
    result.hits.push_back(hit);
  }
  if (result.averages == 1) result.remarks.emplace_back("one hit only: no coherence");
}

}  // namespace

Result<HammerResult> analyseHammer(const HammerRecord& given, const HammerOptions& options) {
  Status sane = checkRecord(given, options);
  if (!sane) return sane.error();
  HammerRecord record = given;
  if (options.flipForce) {
    for (double& v : record.force) v = -v;
  }
  if (options.flipResponse) {
    for (double& v : record.response) v = -v;
  }
  std::vector<FoundHit> hits = findHits(record, options);
  if (hits.empty())
    return Error{record.source, message("holds no hit"), message("force never positive; a flipped channel?")};
  HammerResult result;
  judge(hits, options, result);
  if (result.averages == 0) {
    return Error{record.source, message("holds no usable hit"),
                 result.remarks.empty() ? Message() : foreign(result.remarks.front())};
  }
  // All hits are analysed over the same span, the shortest one's, so that their lines coincide.
  std::size_t span = record.force.size();
  for (const FoundHit& found : hits) {
    if (found.hit.used) span = std::min(span, found.end - found.begin);
  }
  const std::size_t length = roundLength(span);
  const double decay =
      options.exponentialEnd < 1.0 ? -std::log(options.exponentialEnd) * record.rate / static_cast<double>(span) : 0.0;
  Sums sums;
  for (FoundHit& found : hits) {
    if (!found.hit.used) continue;
    found.end = found.begin + span;
    const auto half = static_cast<std::size_t>(found.hit.width * record.rate);
    const std::size_t quietEnd = found.peak > 3 * half ? found.peak - 3 * half : 0;
    std::vector<double> force = cutOut(record.force, found, quietEnd, length);
    std::vector<double> response = cutOut(record.response, found, quietEnd, length);
    if (options.forceWindow > 0.0) {
      const auto hold = static_cast<std::size_t>(options.forceWindow * record.rate);
      applyForceWindow(force, found.peak - found.begin, hold);
    }
    // Both channels, so that their ratio stays the response of a linear system with more damping.
    applyDecay(force, decay, record.rate);
    applyDecay(response, decay, record.rate);
    accumulate(sums, force, response);
  }
  result.frf = estimate(sums, record.rate / static_cast<double>(length), result.averages);
  result.frf.addedDecay = decay;
  result.frf.source = record.source;
  return result;
}

}  // namespace stillcut::identify
