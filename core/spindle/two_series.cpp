#include "core/spindle/two_series.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kRange = 1e3;         // 30 dB: lines further below the strongest say nothing
constexpr double kSpeedWander = 1e-4;  // relative, of a spindle within a window: blurs line n by n times that
constexpr double kNoSecond = 0.02;     // orders: a second series nearer to the first is the first, blurred
constexpr double kOffsetCost = 4.6;    // nepers: log of the 100 offsets among which the best one was chosen
constexpr double kOn = 0.135;          // of the Gaussian: within two standard deviations of where an order is
constexpr double kMember = 0.01;       // 20 dB below the family's strongest line

double offsetOf(double frequency, double spindle) {
  const double order = frequency / spindle;
  return order - std::round(order);
}

}  // namespace

void TwoSeries::begin(Hertz doubt) noexcept {
  doubt_ = doubt.value;
  count_ = 0;
}

void TwoSeries::add(std::span<const SpectralLine> lines) noexcept {
  double most = 0.0;
  for (const SpectralLine& line : lines) {
    if (!line.machines) most = std::max(most, line.power);
  }
  if (!(most > 0.0)) return;
  const std::size_t others = count_;
  for (const SpectralLine& line : lines) {
    if (line.machines) continue;
    const double weight = std::log1p(kRange * line.power / most);
    if (Weighted* same = heardBefore(line.frequency.value, others)) {
      if (weight > same->weight) *same = {line.frequency.value, weight};
    } else if (count_ < kMostLines) {
      lines_[count_++] = {line.frequency.value, weight};
    }
  }
}

// By another channel: of the first `others`.
TwoSeries::Weighted* TwoSeries::heardBefore(double frequency, std::size_t others) noexcept {
  for (std::size_t i = 0; i < others; ++i) {
    if (std::abs(lines_[i].frequency - frequency) < 2.0 * doubt_) return &lines_[i];
  }
  return nullptr;
}

double TwoSeries::onOrder(double frequency, double spindle, double relative) const noexcept {
  const double width = std::hypot(doubt_, relative * frequency) / spindle;
  const double off = offsetOf(frequency, spindle) / width;
  return off * off > 40.0 ? 0.0 : std::exp(-0.5 * off * off);
}

TwoSeries::Fit TwoSeries::fit(Hertz spindle) const noexcept {
  std::array<double, kCells> cells{};
  Fit fit;
  for (std::size_t i = 0; i < count_; ++i) {
    const double on = onOrder(lines_[i].frequency, spindle.value, kSpeedWander);
    fit.score += lines_[i].weight * on;
    const double place = (offsetOf(lines_[i].frequency, spindle.value) + 0.5) * kCells - 0.5;
    const double cell = std::floor(place);
    const double part = place - cell;
    const auto left = static_cast<std::size_t>((static_cast<int>(cell) + kCells) % kCells);
    const double off = lines_[i].weight * (1.0 - on);
    cells[left] += (1.0 - part) * off;
    cells[(left + 1) % kCells] += part * off;
  }
  // As wide as a line is known to be, in cells, to both sides.
  const double sigma = std::max(1.0, kCells * doubt_ / spindle.value);
  const int reach = std::min(kCells / 4, static_cast<int>(std::ceil(2.0 * sigma)));
  std::array<double, kCells / 4 + 1> kernel{};
  for (int d = 0; d <= reach; ++d) kernel[static_cast<std::size_t>(d)] = std::exp(-0.5 * d * d / (sigma * sigma));
  const double least = std::max(kNoSecond, 2.0 * doubt_ / spindle.value);
  double best = 0.0;
  for (int c = 0; c < kCells; ++c) {
    const double offset = (c + 0.5) / kCells - 0.5;
    if (std::abs(offset) < least) continue;
    double sum = 0.0;
    for (int d = -reach; d <= reach; ++d) {
      sum += kernel[static_cast<std::size_t>(std::abs(d))] * cells[static_cast<std::size_t>((c + d + kCells) % kCells)];
    }
    if (sum <= best) continue;
    best = sum;
    fit.offset = offset;
  }
  fit.score += std::max(0.0, best - kOffsetCost);
  return fit;
}

int TwoSeries::onOrders(Hertz spindle) const noexcept {
  const auto on = [&](const Weighted& line) { return onOrder(line.frequency, spindle.value, kSpeedWander) > kOn; };
  return static_cast<int>(std::count_if(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(count_), on));
}

double TwoSeries::explained(Hertz spindle) const noexcept {
  double all = 0.0;
  for (std::size_t i = 0; i < count_; ++i) all += lines_[i].weight;
  return all > 0.0 ? fit(spindle).score / all : 0.0;
}

FreeFamily TwoSeries::freeOf(std::span<const SpectralLine> lines, Hertz spindle, double spindleDoubt) const noexcept {
  FreeFamily free;
  double all = 0.0;
  double off = 0.0;
  double most = 0.0;
  const double relative = std::max(kSpeedWander, spindleDoubt);
  for (const SpectralLine& line : lines) {
    if (line.machines) continue;
    const double part = line.power * (1.0 - onOrder(line.frequency.value, spindle.value, relative));
    all += line.power;
    off += part;
    if (part <= most) continue;
    most = part;
    free.line = line.frequency;
  }
  if (!(off > 0.0)) return free;
  free.power = off;
  free.share = off / all;
  free.offset = offsetOf(free.line.value, spindle.value);
  for (const SpectralLine& line : lines) {
    if (line.machines || line.power < kMember * most) continue;
    const double apart = offsetOf(line.frequency.value - free.line.value, spindle.value) * spindle.value;
    const double doubt = 2.0 * std::hypot(doubt_, relative * (line.frequency.value - free.line.value));
    if (std::abs(apart) <= doubt) ++free.members;
  }
  return free;
}

}  // namespace stillcut::detect
