#include "core/milling/identify/modal_band.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace stillcut::identify {
namespace {

constexpr double kNeighbourhood = 0.04;  // of frequency, to either side
constexpr double kReach = 0.20;          // where the skirts of a peak are looked for
constexpr double kNoisy = 0.04;          // scatter of neighbouring lines against the peak
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

bool isResonance(const Frf& frf, const std::vector<double>& size, std::size_t i) {
  const auto [first, end] = around(frf, i, kNeighbourhood);
  if (i == 0 || i + 1 >= size.size()) return false;
  const auto largest = std::max_element(size.begin() + static_cast<std::ptrdiff_t>(first),
                                        size.begin() + static_cast<std::ptrdiff_t>(end));
  if (*largest > size[i] || size[i - 1] >= size[i]) return false;
  const auto [left, right] = around(frf, i, kReach);
  if (smallest(size, left, i) > 0.85 * size[i] || smallest(size, i + 1, right) > 0.85 * size[i]) return false;
  if (!frf.coherence.empty() && frf.coherence[i] < kLeastCoherence) return false;
  const std::size_t wide = 10;
  return scatter(frf, std::min(first, i > wide ? i - wide : 0), std::max(end, i + wide)) < kNoisy * size[i];
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
    const double f = compliance.frequency[i];
    if (compliance.usableTo > 0.0 && f > compliance.usableTo) break;
    if (size[i] <= size[i - 1] || size[i] < size[i + 1] || !isResonance(compliance, size, i)) continue;
    found.push_back({f, depthAt(compliance, i)});
  }
  return found;
}

Result<Band> resonantBand(const Frf& compliance, const std::vector<Resonance>& resonances, const Band& allowed) {
  std::vector<Resonance> inside;
  double deepest = 0.0;
  for (const Resonance& r : resonances) {
    if (r.frequency < allowed.from || (allowed.to > 0.0 && r.frequency > allowed.to)) continue;
    inside.push_back(r);
    deepest = std::max(deepest, r.depth);
  }
  std::erase_if(inside, [&](const Resonance& r) { return r.depth < kLeastDepth * deepest; });
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
