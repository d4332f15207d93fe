#include "core/sensing/knock_finder.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/units.h"
#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {
namespace {

constexpr double kOutlier = 6.0;  // standard deviations: of Gaussian noise 2e-9
constexpr double kMedianOfNormal = 0.6745;
constexpr double kNews = 3.0;   // times what that angle knows: an edge's impact scatters by less
constexpr int kNear = 2;        // angles to each side: 7.5 degrees, a speed that is 2 % wrong for one turn
constexpr double kFade = 0.85;  // per turn: chatter lifts an edge out of the cut for a few turns
constexpr int kTurnsKnown = 3;

}  // namespace

std::uint8_t KnockFinder::angleOf(double angle) noexcept {
  const int index = static_cast<int>(angle * (kAngles / kTwoPi));
  return static_cast<std::uint8_t>(std::clamp(index, 0, kAngles - 1));
}

void KnockFinder::prepare(int longestWindow) {
  kernels_ = dsp::kernels::bestKernels();
  rest_.assign(static_cast<std::size_t>(longestWindow), 0.0);
  sorted_ = rest_;
  reset();
}

void KnockFinder::reset() noexcept {
  before_ = {};
  now_ = {};
  angle_ = turns_ = 0;
}

bool KnockFinder::predict(std::span<const double> x) noexcept {
  std::array<double, kOrder + 1> r{};
  for (std::size_t lag = 0; lag <= kOrder; ++lag) {
    const std::size_t count = x.size() - lag;
    const std::size_t whole = count - count % dsp::kernels::kLanes;
    r[lag] = kernels_.tapSum(x.data() + lag, x.data(), whole);
    for (std::size_t n = whole; n < count; ++n) r[lag] += x[n + lag] * x[n];
  }
  if (!(r[0] > 0.0)) return false;
  model_ = {};
  model_[0] = 1.0;
  double error = r[0] * (1.0 + 1e-9);
  for (std::size_t l = 1; l <= kOrder; ++l) {
    double sum = r[l];
    for (std::size_t j = 1; j < l; ++j) sum -= model_[j] * r[l - j];
    const double reflection = sum / error;
    std::array<double, kOrder + 1> old = model_;
    for (std::size_t j = 1; j < l; ++j) model_[j] = old[j] - reflection * old[l - j];
    model_[l] = reflection;
    error *= 1.0 - reflection * reflection;
    if (!(error > 0.0)) return false;
  }
  return true;
}

void KnockFinder::turnTo(int angle) noexcept {
  if (angle < angle_ - kAngles / 2) {
    for (std::size_t a = 0; a < kAngles; ++a) before_[a] = std::max(now_[a], kFade * before_[a]);
    now_ = {};
    turns_ = std::min(turns_ + 1, kTurnsKnown);
  }
  angle_ = angle;
}

bool KnockFinder::isNews(double size, int angle) noexcept {
  double known = 0.0;
  for (int a = angle - kNear; a <= angle + kNear; ++a) {
    known = std::max(known, before_[static_cast<std::size_t>((a + kAngles) % kAngles)]);
  }
  return turns_ >= kTurnsKnown && size > kNews * known;
}

// Of the sizes of what the predictor leaves: counted by exponent and two bits more, so that only those in the bin of
// the middle one need sorting.
double KnockFinder::middle(std::size_t count) noexcept {
  constexpr int kShift = 50;
  constexpr std::uint64_t kSize = (1ULL << 63) - 1;
  const auto bits = [this](std::size_t n) { return std::bit_cast<std::uint64_t>(rest_[n]) & kSize; };
  std::uint64_t largest = 0;
  for (std::size_t n = 0; n < count; ++n) largest = std::max(largest, bits(n));
  const std::uint64_t top = largest >> kShift;
  const std::uint64_t base = top - std::min<std::uint64_t>(top, kBins - 1);  // what is smaller is in the first bin
  const auto binOf = [base](std::uint64_t size) {
    const std::uint64_t bin = size >> kShift;
    return static_cast<std::size_t>(bin - std::min(bin, base));
  };
  counts_.fill(0);
  for (std::size_t n = 0; n < count; ++n) ++counts_[binOf(bits(n))];
  std::size_t below = 0;
  std::size_t bin = 0;
  while (below + counts_[bin] <= count / 2) below += counts_[bin++];
  std::size_t found = 0;
  for (std::size_t n = 0; n < count; ++n) {
    if (binOf(bits(n)) == bin) sorted_[found++] = std::abs(rest_[n]);
  }
  const auto place = sorted_.begin() + static_cast<std::ptrdiff_t>(count / 2 - below);
  std::nth_element(sorted_.begin(), place, sorted_.begin() + static_cast<std::ptrdiff_t>(found));
  return *place;
}

KnockFacts KnockFinder::look(std::span<const double> x, std::span<const std::uint8_t> angle, double least) noexcept {
  KnockFacts facts;
  if (x.size() < 4 * kOrder || x.size() > rest_.size() || !predict(x)) return facts;
  const std::size_t count = x.size() - kOrder;
  double energy = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  std::copy_n(x.begin() + kOrder, count, rest_.begin());
  for (std::size_t j = 1; j <= kOrder; ++j) {
    kernels_.addScaled(-model_[j], x.data() + (kOrder - j), rest_.data(), count);
  }
  for (std::size_t n = 0; n < count; ++n) {
    const double e = rest_[n];
    energy += x[n + kOrder] * x[n + kOrder];
    squares += e * e;
    fourths += e * e * e * e;
  }
  if (!(energy > 0.0) || !(squares > 0.0)) return facts;
  facts.left = std::min(1.0, squares / energy);
  facts.kurtosis = fourths * static_cast<double>(count) / (squares * squares);
  const double limit = std::max(least, kOutlier / kMedianOfNormal * middle(count));
  for (std::size_t n = 0; n < count; ++n) {
    const std::uint8_t at = angle[n + kOrder];
    if (at == kNoAngle) continue;
    turnTo(at);
    const double size = std::abs(rest_[n]);
    now_[at] = std::max(now_[at], size);
    if (size <= limit || !isNews(size, at)) continue;
    ++facts.knocks;
    facts.part += size * size / energy;
  }
  return facts;
}

}  // namespace stillcut::detect
