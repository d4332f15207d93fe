#include "core/milling/identify/modal_band.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace stillcut::identify {
namespace {

constexpr double kNeighbourhood = 0.04;  // of frequency, to either side
constexpr double kReach = 0.20;          // where the skirts of a peak are looked for
constexpr double kNoisy = 0.04;          // scatter of neighbouring lines against the peak
constexpr double kBuried = 0.15;         // so much, and it is named only
constexpr double kNoPeak = 0.3;          // so much, and noise alone makes such peaks
constexpr double kOneSign = 0.9;         // of the imaginary part around a resonance, mean against mean size
constexpr double kImaginary = 0.7;       // of its peak, at least, as it is a quarter wave behind the force there
constexpr std::size_t kLeastLines = 9;   // so many of one sign are no chance
constexpr double kLeastCoherence = 0.8;

// Index range within a fraction of frequency around line i, at least two lines to either side.
std::pair<std::size_t, std::size_t> around(const Frf& frf, std::size_t i, double share) {
  const auto& f = frf.frequency;
  const auto low = std::lower_bound(f.begin(), f.end(), f[i] * (1.0 - share)) - f.begin();
  const auto high = std::upper_bound(f.begin(), f.end(), f[i] * (1.0 + share)) - f.begin();
  const auto first = std::min(static_cast<std::size_t>(low), i >= 2 ? i - 2 : 0);
  const auto end = std::max(static_cast<std::size_t>(high), std::min(i + 3, f.size()));
  return {first, end};
}

// Scatter of one line from the fourth differences, which a resonance of a few lines' width hardly shows in.
double scatter(const Frf& frf, std::size_t first, std::size_t end) {
  std::vector<double> d;
  for (std::size_t i = std::max<std::size_t>(first, 2); i + 2 < frf.value.size() && i < end; ++i) {
    const auto& v = frf.value;
    d.push_back(std::abs(v[i - 2] - 4.0 * v[i - 1] + 6.0 * v[i] - 4.0 * v[i + 1] + v[i + 2]) / std::sqrt(70.0));
  }
  if (d.empty()) return 0.0;
  const auto middle = d.begin() + static_cast<std::ptrdiff_t>(d.size() / 2);
  std::nth_element(d.begin(), middle, d.end());
  return *middle;
}

double smallest(const std::vector<double>& size, std::size_t first, std::size_t end) {
  return *std::min_element(size.begin() + static_cast<std::ptrdiff_t>(first),
                           size.begin() + static_cast<std::ptrdiff_t>(end));
}

// Higher than all around it, with skirts on both sides.
bool isPeak(const Frf& frf, const std::vector<double>& size, std::size_t i) {
  const auto [first, end] = around(frf, i, kNeighbourhood);
  if (i == 0 || i + 1 >= size.size()) return false;
  const auto largest = std::max_element(size.begin() + static_cast<std::ptrdiff_t>(first),
                                        size.begin() + static_cast<std::ptrdiff_t>(end));
  if (*largest > size[i] || size[i - 1] >= size[i]) return false;
  const auto [left, right] = around(frf, i, kReach);
  return smallest(size, left, i) <= 0.85 * size[i] && smallest(size, i + 1, right) <= 0.85 * size[i];
}

// Noise makes peaks too, but not imaginary ones whose whole neighbourhood has the same sign.
bool movesAsAResonance(const Frf& frf, const std::vector<double>& size, std::size_t i) {
  const auto [first, end] = around(frf, i, kNeighbourhood);
  if (end - first < kLeastLines) return false;
  double sum = 0.0, all = 0.0;
  for (std::size_t k = first; k < end; ++k) {
    sum += frf.value[k].imag();
    all += std::abs(frf.value[k].imag());
  }
  return std::abs(frf.value[i].imag()) >= kImaginary * size[i] && std::abs(sum) >= kOneSign * all;
}

std::optional<PeakNoise> noiseOf(const Frf& frf, const std::vector<double>& size, std::size_t i) {
  if (!isPeak(frf, size, i)) return std::nullopt;
  const auto [first, end] = around(frf, i, kNeighbourhood);
  const std::size_t wide = 10;
  const double noise = scatter(frf, std::min(first, i > wide ? i - wide : 0), std::max(end, i + wide)) / size[i];
  const bool incoherent = !frf.coherence.empty() && frf.coherence[i] < kLeastCoherence;
  if (noise < kNoisy && !incoherent) return PeakNoise::Clear;
  if (noise >= kNoPeak || !movesAsAResonance(frf, size, i)) return std::nullopt;
  return noise < kBuried ? PeakNoise::Noisy : PeakNoise::Buried;
}

double depthAt(const Frf& frf, std::size_t i) {
  const auto [first, end] = around(frf, i, kNeighbourhood);
  double largest = 0.0;
  for (std::size_t k = first; k < end; ++k) largest = std::max(largest, std::abs(frf.value[k].imag()));
  return 0.5 * largest;
}

}  // namespace

std::vector<Resonance> findResonances(const Frf& compliance) {
  std::vector<double> size;
  for (const auto& v : compliance.value) size.push_back(std::abs(v));
  std::vector<Resonance> found;
  for (std::size_t i = 1; i + 1 < size.size(); ++i) {
    if (size[i] <= size[i - 1] || size[i] < size[i + 1]) continue;
    const auto noise = noiseOf(compliance, size, i);
    if (!noise) continue;
    const double f = compliance.frequency[i];
    const bool reached = compliance.usableTo <= 0.0 || f <= compliance.usableTo;
    // Beyond the hammer's reach anything may look clear: what does not move as a resonance is none.
    if (!reached && !movesAsAResonance(compliance, size, i)) continue;
    found.push_back({f, depthAt(compliance, i), *noise, reached});
  }
  return found;
}

Result<Band> resonantBand(const Frf& compliance, const std::vector<Resonance>& resonances, const Band& allowed) {
  std::vector<Resonance> inside;
  double deepest = 0.0;
  for (const Resonance& r : resonances) {
    if (!r.fitted() || r.frequency < allowed.from || (allowed.to > 0.0 && r.frequency > allowed.to)) continue;
    inside.push_back(r);
    deepest = std::max(deepest, r.depth);
  }
  std::erase_if(inside, [&](const Resonance& r) {
    return r.depth < (r.noise == PeakNoise::Clear ? kLeastDepth : kLeastNoisyDepth) * deepest;
  });
  if (inside.empty()) {
    return Error{compliance.source, message("no resonance stands out of the noise"),
                 message("give the frequency band to fit")};
  }
  Band band{0.55 * inside.front().frequency, 1.2 * inside.back().frequency};
  band.from = std::max({band.from, compliance.frequency.front(), allowed.from});
  band.to = std::min(band.to, compliance.frequency.back());
  if (allowed.to > 0.0) band.to = std::min(band.to, allowed.to);
  return band;
}

}  // namespace stillcut::identify
