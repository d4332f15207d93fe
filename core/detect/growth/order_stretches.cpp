#include "core/detect/growth/order_stretches.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr Seconds kLeastStretch{0.05};
constexpr Seconds kSlowest{0.06};    // growth constant; a load that rises within 0.3 s amplifies at 110 ms
constexpr Seconds kNearLimit{0.15};  // within a twentieth of its limit a mode follows its load no faster
constexpr double kGrowsOn = 1.25;    // over a stretch: an e-fold in four of them or so
constexpr double kOther = 0.1;       // of the pattern: 0.01 while the arc stands, 0.2 to 0.45 while it changes
constexpr double kClearly = 10.0;    // more than the engagement changes, as amplitude
constexpr double kSeen = 2.0;        // over what the pattern scatters by: less may have been added unseen
constexpr double kLeastStep = 0.01;  // of the load; less is noise
constexpr double kMostFolds = 2.0;   // over a long stretch, of a slow spindle

}  // namespace

void OrderStretches::prepare(int teeth, std::size_t orders) {
  teeth_ = static_cast<std::size_t>(std::max(teeth, 0));
  orders_ = orders;
  newest_ = known_ = 0;
  turnsPerRow_ = 1;
  turns_ = 0;
  pattern_ = 1.0;
  rows_.assign(kRows * orders, {});
  learned_.assign(orders, {});
}

void OrderStretches::setSpindle(Hertz spindle) {
  turnsPerRow_ = std::max(1, static_cast<int>(std::lround(kLeastStretch.value * spindle.value / kStretch)));
  const double stretch = static_cast<double>(kStretch) * turnsPerRow_ / std::max(spindle.value, 1.0);
  faster_ = std::exp(std::min(stretch / kSlowest.value, kMostFolds));
  settling_ = std::exp(std::min(stretch / kNearLimit.value, kMostFolds));
}

OrderStretches::Row OrderStretches::ago(std::size_t rows) const {
  return std::span(rows_).subspan((newest_ + kRows - rows) % kRows * orders_, orders_);
}

double OrderStretches::teethOf(Row row) const {
  double power = 0.0;
  for (std::size_t n = teeth_; n <= orders_; n += teeth_) power += std::norm(row[n - 1]);
  return std::sqrt(power);
}

template <class Amplitude>
double OrderStretches::ofClass(int rest, const Amplitude& amplitude) const {
  double power = 0.0;
  const auto one = static_cast<std::size_t>(rest);
  const std::size_t over = teeth_ - 2 * one;  // from kZ + rest to (k + 1) Z - rest; 0: they are the same
  for (std::size_t n = one; n <= orders_; n += teeth_) {
    power += std::norm(amplitude(n - 1));
    if (over > 0 && n + over <= orders_) power += std::norm(amplitude(n + over - 1));
  }
  return std::sqrt(power);
}

double OrderStretches::added(int rest, std::size_t rowsAgo) const {
  const Row now = ago(rowsAgo);
  const Row before = ago(rowsAgo + kStretch);
  const double scaleNow = teethOf(now);
  const double scaleBefore = teethOf(before);
  if (!(scaleNow > 0.0) || !(scaleBefore > 0.0)) return 0.0;
  return ofClass(rest, [&](std::size_t i) { return now[i] / scaleNow - before[i] / scaleBefore; });
}

double OrderStretches::size(int rest, std::size_t rowsAgo) const {
  const Row now = ago(rowsAgo);
  const double scale = teethOf(now);
  return scale > 0.0 ? ofClass(rest, [&](std::size_t i) { return now[i]; }) / scale : 0.0;
}

// Sine of the angle between the tooth passings of now and those of a stretch ago, as vectors: 0 while they only scale.
double OrderStretches::patternChange() const {
  const Row now = ago(0);
  const Row before = ago(kStretch);
  std::complex<double> product = 0.0;
  for (std::size_t n = teeth_; n <= orders_; n += teeth_) product += now[n - 1] * std::conj(before[n - 1]);
  const double scale = teethOf(now) * teethOf(before);
  const double cosine = scale > 0.0 ? std::abs(product) / scale : 0.0;
  return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

void OrderStretches::endTurn(std::span<const std::complex<double>> now) {
  if (teeth_ == 0 || ++turns_ < turnsPerRow_) return;
  turns_ = 0;
  newest_ = (newest_ + 1) % kRows;
  known_ = std::min(known_ + 1, kRows);
  const auto row = rows_.begin() + static_cast<std::ptrdiff_t>(newest_ * orders_);
  const std::size_t count = std::min(now.size(), orders_);
  std::copy_n(now.begin(), count, row);
  std::fill(row + static_cast<std::ptrdiff_t>(count), row + static_cast<std::ptrdiff_t>(orders_), 0.0);
  pattern_ = patternChange();
}

bool OrderStretches::ownGrowth(int rest) const {
  return added(rest, 0) > pattern_;
}

bool OrderStretches::growsOn(int rest) const {
  return ownGrowth(rest) && size(rest, 0) > kGrowsOn * size(rest, kStretch) &&
         added(rest, 0) > settling_ * added(rest, kStretch);
}

double OrderStretches::loadChange(std::size_t rowsAgo) const {
  const double now = teethOf(ago(rowsAgo));
  return now > 0.0 ? std::abs(now - teethOf(ago(rowsAgo + kStretch))) / now : 0.0;
}

bool OrderStretches::engagementChanges() const {
  return pattern_ > kOther;
}

void OrderStretches::learnEngagement() {
  const Row now = ago(0);
  std::transform(now.begin(), now.end(), learned_.begin(), [](const auto& a) { return std::abs(a); });
}

// By their sizes alone: over seconds the angle they are told against wanders, and after a gap it is another one.
bool OrderStretches::otherEngagement() const {
  const Row now = ago(0);
  double product = 0.0;
  double power = 0.0;
  for (std::size_t n = teeth_; teeth_ > 0 && n <= orders_; n += teeth_) {
    product += std::abs(now[n - 1]) * learned_[n - 1];
    power += learned_[n - 1] * learned_[n - 1];
  }
  const double scale = teethOf(now) * std::sqrt(power);
  const double cosine = scale > 0.0 ? product / scale : 0.0;
  return 1.0 - cosine * cosine > kOther * kOther;
}

bool OrderStretches::unstableGrowth(int rest) const {
  const double latest = added(rest, 0);
  const double byLoad = loadChange(0) / (loadChange(kStretch) + kLeastStep);
  const double bound = latest / (faster_ * std::max(1.0, byLoad));
  if (bound <= kSeen * pattern_ || bound <= added(rest, kStretch)) return false;
  for (std::size_t k = 2; k < kStretches && (k + 1) * kStretch < known_; ++k) {
    if (bound <= added(rest, k * kStretch)) return false;
  }
  return true;
}

bool OrderStretches::lockedGrowth(int rest) const {
  const double latest = added(rest, 0);
  return latest > kClearly * pattern_ && latest > faster_ * added(rest, kStretch);
}

}  // namespace stillcut::detect
