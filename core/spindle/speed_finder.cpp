#include "core/spindle/speed_finder.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

constexpr double kNearlyAll = 0.93;  // of what the best comb holds: a fundamental this good is preferred to its parts
constexpr double kTeethCarry = 0.7;  // of the comb, on every so manieth line: these are the tooth passings
constexpr double kRunout = 0.25;     // of what is beside the comb, on the lines in between: runout
constexpr double kFirstLine = 0.5;   // of the comb: a tooth passing; imbalance alone never shakes a cut like that
constexpr std::array<int, 3> kSkips{2, 3, 5};  // of a spindle that turns so many times faster, every such multiple
constexpr double kLeastPeak = 1e-4;            // of the power; smaller lines propose nothing

}  // namespace

void SpeedFinder::prepare(int bins, Hertz binWidth, int lobe, int teeth) {
  binWidth_ = binWidth.value;
  lobe_ = lobe;
  teeth_ = teeth;
  sums_.assign(static_cast<std::size_t>(bins) + 1, 0.0);
}

// Power in the main lobe around a frequency.
double SpeedFinder::lineAt(double frequency) const noexcept {
  const double middle = std::round(frequency / binWidth_);
  const auto size = static_cast<double>(power_.size());
  const double from = std::clamp(middle - lobe_, 0.0, size);
  const double to = std::clamp(middle + lobe_ + 1.0, 0.0, size);
  return sums_[static_cast<std::size_t>(to)] - sums_[static_cast<std::size_t>(from)];
}

// Part of all power on every `every`-th line of the comb, above what lobes there would hold of noise.
double SpeedFinder::combPart(double fundamental, int every) const noexcept {
  const double spacing = fundamental * every;
  const double end = binWidth_ * static_cast<double>(power_.size());
  const double chance = std::min(1.0, (2.0 * lobe_ + 1.0) * binWidth_ / spacing);
  if (chance > 0.7) return 0.0;
  double on = 0.0;
  for (int h = 1; h <= kMostOrder && h * spacing < end; ++h) on += lineAt(h * spacing);
  return (on / total_ - chance) / (1.0 - chance);
}

void SpeedFinder::collectPeaks() noexcept {
  peaks_ = 0;
  for (std::size_t b = 1; b + 1 < power_.size(); ++b) {
    const double p = power_[b];
    if (p < kLeastPeak * total_ || p < power_[b - 1] || p < power_[b + 1]) continue;
    const double shift = peakShift(power_[b - 1], p, power_[b + 1]);
    const Peak peak{(static_cast<double>(b) + shift) * binWidth_, p};
    // Sidelobes of a line that is there already say nothing new.
    const auto end = found_.begin() + peaks_;
    const auto near = std::find_if(found_.begin(), end, [&](const Peak& other) {
      return std::abs(other.frequency - peak.frequency) < lobe_ * binWidth_;
    });
    if (near != end) {
      if (near->power < p) *near = peak;
    } else if (peaks_ < kPeaks) {
      found_[static_cast<std::size_t>(peaks_++)] = peak;
    } else {
      const auto least =
          std::min_element(found_.begin(), end, [](const Peak& a, const Peak& c) { return a.power < c.power; });
      if (least->power < p) *least = peak;
    }
  }
}

// Least squares over the lines that lie on the comb.
double SpeedFinder::refined(double fundamental) const noexcept {
  double sum = 0.0;
  double weight = 0.0;
  for (int i = 0; i < peaks_; ++i) {
    const Peak& p = found_[static_cast<std::size_t>(i)];
    const double order = std::round(p.frequency / fundamental);
    if (order < 1.0 || std::abs(p.frequency - order * fundamental) > lobe_ * binWidth_) continue;
    sum += p.power * order * p.frequency;
    weight += p.power * order * order;
  }
  return weight > 0.0 ? sum / weight : fundamental;
}

double SpeedFinder::fundamental(double low, double high, double* part) const noexcept {
  double best = 0.0;
  const auto eachCandidate = [&](auto&& use) {
    for (int i = 0; i < peaks_; ++i) {
      for (int order = 1; order <= kMostOrder; ++order) {
        const double f = found_[static_cast<std::size_t>(i)].frequency / order;
        if (f < low) break;
        if (f <= high) use(refined(f));
      }
    }
  };
  eachCandidate([&](double f) { best = std::max(best, combPart(f, 1)); });
  double found = 0.0;
  eachCandidate([&](double f) {
    if (f > found && combPart(f, 1) >= kNearlyAll * best) found = f;
  });
  *part = found > 0.0 ? combPart(found, 1) : 0.0;
  return found;
}

// By what the fundamental is to be divided to give the spindle frequency.
int SpeedFinder::divisor(double fundamental) const noexcept {
  const double all = combPart(fundamental, 1);
  for (int k = teeth_; k > 1; --k) {
    if (teeth_ % k != 0) continue;
    const double carried = k == teeth_ ? 1.0 : combPart(fundamental, teeth_ / k) / all;
    const double between = combPart(fundamental / k, 1) - all;
    if (carried > kTeethCarry && between > kRunout * (1.0 - all)) return k;
  }
  if (combPart(fundamental, std::max(teeth_, 1)) > kTeethCarry * all) return 1;
  return teeth_ > 1 && lineAt(fundamental) > kFirstLine * all * total_ ? teeth_ : 1;
}

FoundSpeed SpeedFinder::find(std::span<const double> power, Hertz low, Hertz high) noexcept {
  power_ = power.first(std::min(power.size(), sums_.size() - 1));
  sums_[0] = 0.0;
  for (std::size_t b = 0; b < power_.size(); ++b) sums_[b + 1] = sums_[b] + power_[b];
  total_ = sums_[power_.size()];
  FoundSpeed found;
  if (!(total_ > 0.0)) return found;
  collectPeaks();
  const double most = high.value * std::max(teeth_, 1);
  const double f = fundamental(low.value, most, &found.part);
  if (!(f > 0.0)) return found;
  const double spindle = f / divisor(f);
  if (spindle < low.value || spindle > high.value) return found;
  found.spindle = Hertz(spindle);
  found.toothPart = teeth_ > 0 ? combPart(spindle, teeth_) : 0.0;
  found.everyPassing = everyPassing(spindle);
  return found;
}

// A line above the noise beside it.
double SpeedFinder::standsOut(double frequency) const noexcept {
  const double beside = (2.0 * lobe_ + 1.0) * binWidth_;
  const double noise = std::min(lineAt(frequency - beside), lineAt(frequency + beside));
  return std::max(0.0, lineAt(frequency) - noise);
}

double SpeedFinder::everyPassing(double spindle) const noexcept {
  if (teeth_ < 1) return 1.0;
  double all = 0.0;
  std::array<double, kSkips.size()> between{};
  for (int k = 1; k * teeth_ <= kMostOrder; ++k) {
    const double line = standsOut(k * teeth_ * spindle);
    all += line;
    for (std::size_t q = 0; q < kSkips.size(); ++q) between[q] += k % kSkips[q] != 0 ? line : 0.0;
  }
  return all > 0.0 ? *std::min_element(between.begin(), between.end()) / all : 1.0;  // none there: nothing is told
}

}  // namespace stillcut::detect
