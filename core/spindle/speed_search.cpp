#include "core/spindle/speed_search.h"

#include <algorithm>
#include <cmath>

#include "core/dsp/kernels/choose.h"
#include "core/dsp/order.h"
#include "core/dsp/peak_shift.h"

namespace stillcut::detect {
namespace {

constexpr int kMostHarmonics = 40;
constexpr double kUsableBand = 0.45;  // of the rate; above it the filters before the converter bend the lines
constexpr int kPadding = 2;
constexpr int kLobe = 2 * kPadding;  // half width of a Hann line in padded bins
constexpr double kLoneDoubt = 1.0;   // bins of the window: a line whose amplitude changes is known to that
// Of what the square holds beside the line's own: all of it but noise lies on the comb of a line that is forced.
// Products of chatter with forced lines do not, and are as much as the forced lines make there among themselves.
constexpr double kAllBeside = 0.7;
// The same where noise fills the rest, and the line's peak counts on the comb while all of its lobe is its own: the
// comb has to outweigh the line's breadth as well.
constexpr double kLoneSquare = 0.2;
// A comb of one line alone fits many speeds. That line need not be forced: where it is chatter, or an order above half
// the rate that no filter kept out, the others lie on another comb. A tooth passing may well be all there is.
constexpr double kAlone = 0.25;               // of what the vibration has on the comb, and is not that line
constexpr double kBetterBeside = 2.5;         // the others' comb holds so much more of them
constexpr double kLinePart = 1.5 * kPadding;  // a full Hann line holds 1.5 bins' worth of its peak, times the padding

}  // namespace

void SpeedSearch::prepare(int window, Hertz rate, int teeth) {
  kernels_ = dsp::kernels::bestKernels();
  spectrum_.prepare(window, rate, dsp::WindowKind::Hann, kPadding * window);
  finder_.prepare(spectrum_.bins(), Hertz(spectrum_.binWidth()), kLobe, teeth);
  rate_ = rate.value;
  teeth_ = teeth;
  for (auto* v : {&power_, &square_, &powers_}) v->assign(static_cast<std::size_t>(spectrum_.bins()), 0.0);
  for (auto* v : {&scratch_, &evened_}) v->assign(static_cast<std::size_t>(window), 0.0);
  trials_.assign(kMostTrials, 0.0);
}

void SpeedSearch::begin(double drift) noexcept {
  drift_ = drift;
  std::fill(power_.begin(), power_.end(), 0.0);
  std::fill(square_.begin(), square_.end(), 0.0);
  added_ = 0;
}

void SpeedSearch::addSpectrum(std::span<const double> samples, std::vector<double>& power) noexcept {
  spectrum_.transform(samples);
  spectrum_.powers(powers_);
  const auto usable = static_cast<std::size_t>(kUsableBand * rate_ / spectrum_.binWidth());
  const double total = kernels_.sum(powers_.data() + kLobe, usable - kLobe);
  if (total > 0.0) kernels_.addScaled(1.0 / total, powers_.data() + kLobe, power.data() + kLobe, usable - kLobe);
}

// The spindle has turned by f_m (t + drift t^2 / 2) at a time t from the middle, f_m its speed there: as far as at an
// even speed at t + drift t^2 / 2. Cubic interpolation; the window is silent where samples beyond its ends would be
// wanted.
std::span<const double> SpeedSearch::evened(std::span<const double> samples) noexcept {
  if (drift_ == 0.0) return samples;
  const double last = static_cast<double>(samples.size()) - 1.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double even = static_cast<double>(i) - 0.5 * last;
    const double place = std::clamp(static_cast<double>(i) - 0.5 * drift_ / rate_ * even * even, 1.0, last - 2.0);
    const auto at = static_cast<std::size_t>(place);
    const double u = place - static_cast<double>(at);
    const double* x = samples.data() + at;
    const double before = 0.5 * (x[1] - x[-1]);
    const double after = 0.5 * (x[2] - x[0]);
    const double rise = x[1] - x[0];
    evened_[i] = x[0] + u * (before + u * (3.0 * rise - 2.0 * before - after + u * (before + after - 2.0 * rise)));
  }
  return evened_;
}

void SpeedSearch::add(std::span<const double> raw) noexcept {
  const std::span<const double> samples = evened(raw);
  addSpectrum(samples, power_);
  kernels_.multiply(samples.data(), samples.data(), scratch_.data(), scratch_.size());
  const double mean = kernels_.sum(scratch_.data(), scratch_.size()) / static_cast<double>(scratch_.size());
  for (double& s : scratch_) s -= mean;
  addSpectrum(scratch_, square_);
  ++added_;
}

double SpeedSearch::at(const std::vector<double>& power, double position) noexcept {
  const auto b = static_cast<std::size_t>(position);
  if (b + 1 >= power.size()) return 0.0;
  const double part = position - static_cast<double>(b);
  return (1.0 - part) * power[b] + part * power[b + 1];
}

// Sums over the comb; leaveOut: frequency of a line that does not count, 0: none.
SpeedSearch::Parts SpeedSearch::parts(double spindle, int harmonics, double leaveOut) const noexcept {
  Parts sum;
  const double line = leaveOut / spectrum_.binWidth();
  const double line2 = doubled(leaveOut) / spectrum_.binWidth();
  const auto counts = [&](double position, double beside) {
    return !(leaveOut > 0.0) || std::abs(position - beside) > kLobe;
  };
  for (int h = 1; h <= harmonics; ++h) {
    const double position = h * spindle / spectrum_.binWidth();
    if (counts(position, line)) sum.vibration += at(power_, position);
    if (counts(position, line2)) sum.square += at(square_, position);
  }
  const double scale = kLinePart / std::max(added_, 1);
  return {scale * sum.vibration, scale * sum.square};
}

double SpeedSearch::toothPart(double spindle) const noexcept {
  if (teeth_ < 1) return 0.0;
  double on = 0.0;
  for (int k = 1; k * teeth_ * spindle < kUsableBand * rate_; ++k) {
    const double position = k * teeth_ * spindle / spectrum_.binWidth();
    for (int d = -kLobe; d <= kLobe; ++d) on += at(power_, std::max(0.0, position + d));
  }
  return on / std::max(added_, 1);
}

int SpeedSearch::harmonicsOf(Hertz spindle) const noexcept {
  return spindle.value > 0.0 ? std::min(kMostHarmonics, static_cast<int>(kUsableBand * rate_ / spindle.value)) : 0;
}

SpeedSearch::Parts SpeedSearch::partsAt(Hertz spindle) const noexcept {
  return parts(spindle.value, harmonicsOf(spindle), 0.0);
}

SpeedSearch::Parts SpeedSearch::restAt(Hertz spindle, const Line& without) const noexcept {
  return parts(spindle.value, harmonicsOf(spindle), without.frequency.value);
}

double SpeedSearch::restPartAt(Hertz spindle) const noexcept {
  const Line line = strongest();
  return line.part < 1.0 ? restAt(spindle, line).vibration / (1.0 - line.part) : 0.0;
}

// Both spectra's sum, into powers_.
void SpeedSearch::addBoth(Hertz notForced) noexcept {
  std::copy(power_.begin(), power_.end(), powers_.begin());
  kernels_.addScaled(1.0, square_.data(), powers_.data(), powers_.size());
  if (!(notForced.value > 0.0)) return;
  const auto leaveOut = [&](const std::vector<double>& power, double hertz) {
    const auto middle = static_cast<std::size_t>(std::lround(hertz / spectrum_.binWidth()));
    for (std::size_t b = middle - std::min<std::size_t>(middle, kLobe); b <= middle + kLobe && b < power.size(); ++b) {
      powers_[b] = std::max(0.0, powers_[b] - power[b]);
    }
  };
  leaveOut(power_, notForced.value);
  leaveOut(square_, doubled(notForced.value));
}

// Mean of both spectra's parts, of powers_, for combs of low, low + step ... Hz. Harmonic by harmonic: the places of
// its line in one comb after the other lie side by side.
void SpeedSearch::tryCombs(double low, double step, int harmonics, std::size_t count) noexcept {
  std::fill_n(trials_.begin(), count, 0.0);
  for (int h = 1; h <= harmonics; ++h) {
    const double first = h * low / spectrum_.binWidth();
    const double further = h * step / spectrum_.binWidth();
    if (first + further * static_cast<double>(count) + 1.0 >= static_cast<double>(powers_.size())) break;
    for (std::size_t i = 0; i < count; ++i) {
      const double position = first + further * static_cast<double>(i);
      const auto b = static_cast<std::size_t>(position);
      trials_[i] += powers_[b] + (position - static_cast<double>(b)) * (powers_[b + 1] - powers_[b]);
    }
  }
  const double scale = 0.5 * kLinePart / std::max(added_, 1);
  for (std::size_t i = 0; i < count; ++i) trials_[i] *= scale;
}

// Of a line at this bin, with all of its lobe.
double SpeedSearch::lobeAt(const std::vector<double>& power, std::size_t middle) const noexcept {
  double lobe = 0.0;
  for (std::size_t b = middle - std::min<std::size_t>(middle, kLobe); b <= middle + kLobe && b < power.size(); ++b) {
    lobe += power[b];
  }
  return lobe / std::max(added_, 1);
}

bool SpeedSearch::sharesComb(Hertz line, Hertz spindle) const noexcept {
  const int harmonics = harmonicsOf(spindle);
  const auto middle = static_cast<std::size_t>(std::lround(doubled(line.value) / spectrum_.binWidth()));
  const double own = lobeAt(square_, middle);
  const double rest = 1.0 - own;
  // Where its amplitude changes, as while a tool enters on a mode, the line is broader than any that the comb is read
  // for, and is left out whole.
  if (parts(spindle.value, harmonics, line.value).square > kAllBeside * rest) return true;
  const double whole = partsAt(spindle).square;
  const bool counted = std::lround(doubled(line.value) / spindle.value) <= kMostHarmonics;
  return counted ? whole - own > kLoneSquare * rest : whole > kLoneSquare;
}

bool SpeedSearch::mayBeForced(Hertz line, Hertz low, Hertz high) const noexcept {
  const Hertz doubt(kLoneDoubt * rate_ / window());
  const double highest = (line + doubt) / low;  // orders
  const double lowest = (line - doubt) / high;
  if (lowest < teeth_ || std::floor(highest / teeth_) >= lowest / teeth_) return true;
  // Where other lines stand with it on one comb, that comb is the spindle's.
  for (int order = static_cast<int>(std::ceil(lowest)); order <= highest; ++order) {
    if (sharesComb(line, line / order)) return true;
  }
  return false;
}

bool SpeedSearch::mayBeForcedAt(Hertz line, Hertz spindle) const noexcept {
  if (!(spindle.value > 0.0) || std::abs(dsp::orderOffset(line, spindle)) > kOnComb) return false;
  const auto order = static_cast<int>(std::lround(line / spindle));
  return order > 0 && (order % std::max(teeth_, 1) == 0 || sharesComb(line, line / order));
}

bool SpeedSearch::mayBeAmongOthers(Hertz line, Hertz low, Hertz high) const noexcept {
  if (!(low.value > 0.0)) return true;
  for (int order = std::max(1, static_cast<int>(std::ceil(line / high))); order * low.value <= line.value; ++order) {
    if (sharesComb(line, line / order)) return true;
  }
  return false;
}

SpeedCandidate SpeedSearch::search(Hertz low, Hertz high, Hertz notForced) noexcept {
  SpeedCandidate found = searchCombs(low, high, notForced);
  if (notForced.value > 0.0 || !(found.part > 0.0)) return found;
  const Line line = strongest();
  const Parts rest = restAt(found.spindle, line);
  // What a line that is not on the comb leaves in the square, at twice its frequency, says nothing for it.
  if (std::abs(dsp::orderOffset(line.frequency, found.spindle)) > kOnComb) {
    const double part = std::min(found.part, 0.5 * (rest.vibration + rest.square));
    found.contrast *= part / found.part;
    found.part = part;
    return found;
  }
  const bool passing = teeth_ > 0 && std::lround(line.frequency / found.spindle) % teeth_ == 0;
  const bool alone = rest.vibration < kAlone * partsAt(found.spindle).vibration;
  if (passing || !alone || found.part > SpeedCandidate::kClearPart) return found;
  const SpeedCandidate beside = searchCombs(low, high, line.frequency);
  const Parts others = restAt(beside.spindle, line);
  const bool better = others.vibration + others.square > kBetterBeside * (rest.vibration + rest.square);
  // Of the combs that are left too few are no neighbours of the best one for its contrast to say much.
  return !beside.atEdge && beside.part > SpeedCandidate::kLeastPart && better ? beside : found;
}

SpeedCandidate SpeedSearch::searchCombs(Hertz low, Hertz high, Hertz notForced) noexcept {
  SpeedCandidate found;
  const int harmonics = std::min(kMostHarmonics, static_cast<int>(kUsableBand * rate_ / std::max(high.value, 1e-3)));
  if (harmonics < 1 || !(high > low) || !(low.value > 0.0) || added_ == 0) return found;
  const double finest = 0.2 * rate_ / window() / harmonics;
  const double step = std::max(finest, (high.value - low.value) / (kMostTrials - 2));
  const auto count = std::min(static_cast<std::size_t>((high.value - low.value) / step) + 1, trials_.size());
  addBoth(notForced);
  tryCombs(low.value, step, harmonics, count);
  std::size_t best = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Hertz f(low.value + static_cast<double>(i) * step);
    if (notForced.value > 0.0 && std::abs(dsp::orderOffset(notForced, f)) < kOnComb) trials_[i] = 0.0;
    if (trials_[i] > trials_[best]) best = i;
  }
  const double peak = trials_[best];
  const double left = best > 0 ? trials_[best - 1] : peak;
  const double right = best + 1 < count ? trials_[best + 1] : peak;
  const double shift = peakShift(left, peak, right);
  found.spindle = Hertz(low.value + (static_cast<double>(best) + shift) * step);
  found.sd = Hertz(step);
  found.part = std::min(peak, 1.0);
  found.atEdge = best == 0 || best + 1 == count;
  // What was left out is no measure of what a comb holds by chance.
  const auto end = trials_.begin() + static_cast<std::ptrdiff_t>(count);
  const auto tried = notForced.value > 0.0 ? std::remove(trials_.begin(), end, 0.0) : end;
  const auto middle = trials_.begin() + (tried - trials_.begin()) / 2;
  std::nth_element(trials_.begin(), middle, tried);
  found.contrast = middle != tried && *middle > 0.0 ? peak / *middle : 0.0;
  found.toothPart = toothPart(found.spindle.value);
  return found;
}

SpeedSearch::Line SpeedSearch::lineAt(std::size_t peak) const noexcept {
  const bool between = peak > 0 && peak + 1 < power_.size();
  const double shift = between ? peakShift(power_[peak - 1], power_[peak], power_[peak + 1]) : 0.0;
  return {Hertz((static_cast<double>(peak) + shift) * spectrum_.binWidth()), lobeAt(power_, peak)};
}

SpeedSearch::Line SpeedSearch::strongest() const noexcept {
  return lineAt(static_cast<std::size_t>(std::max_element(power_.begin(), power_.end()) - power_.begin()));
}

bool SpeedSearch::hasMoved(Hertz from, Hertz to, double least) const noexcept {
  const Parts here = restAt(from);
  const Parts there = restAt(to);
  return here.vibration < least * there.vibration && here.square < least * there.square;
}

FoundSpeed SpeedSearch::find(Hertz low, Hertz high) noexcept {
  const auto usable = static_cast<std::size_t>(kUsableBand * rate_ / spectrum_.binWidth());
  return finder_.find(std::span<const double>(power_).first(std::min(usable, power_.size())), low, high);
}

}  // namespace stillcut::detect
