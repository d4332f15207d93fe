#include "core/spindle/speed_belief.h"

#include <algorithm>
#include <cmath>

namespace stillcut::detect {
namespace {

constexpr double kCell = 2e-4;        // relative: a fifth of what a comb must be known to (methods.md section 4)
constexpr double kWander = 1.5e-4;    // relative, of a spindle from look to look, by load and by drift
constexpr int kReach = 3;             // cells that it may move between looks
constexpr double kMemory = 4.0;       // s, after which what was heard is forgotten
constexpr double kIndependent = 1.0;  // s: looks within it repeat each other
// A spindle under closed control turns as told, to a tenth of a per cent; one on a plain converter slips by per cents.
// Which of the two it is nobody says.
constexpr double kControlledSd = 1.5e-3;
constexpr double kControlled = 0.5;    // probability
constexpr double kPlausible = 4.0;     // nepers below the most likely speed: one in fifty
constexpr double kSurprise = 10.0;     // nepers: a line and a half of the strongest
constexpr double kSurprisePart = 0.2;  // ... and of all that fits
constexpr int kSurprises = 3;          // looks on end
constexpr double kEdge = 1e-3;         // relative: so near the end of what was looked at, no peak
constexpr double kSame = 1.5e-3;       // relative: neighbours of the most likely speed are the same speed

}  // namespace

void SpeedBelief::prepare(double range) {
  range_ = range;
  const auto side = static_cast<std::size_t>(std::ceil(std::log1p(range) / kCell));
  log_.assign(2 * side + 1, 0.0);
  moved_.assign(log_.size(), 0.0);
  score_.assign(log_.size(), 0.0);
  begin(range / 3.0);
}

double SpeedBelief::ratioAt(std::size_t cell) const noexcept {
  return std::exp(kCell * (static_cast<double>(cell) - 0.5 * static_cast<double>(log_.size() - 1)));
}

void SpeedBelief::begin(double sd) noexcept {
  priorSd_ = std::max(sd, kCell);
  heard_ = false;
  surprised_ = 0;
  ratio_ = 1.0;
  sd_ = priorSd_;
  certainty_ = 0.0;
  for (std::size_t i = 0; i < log_.size(); ++i) log_[i] = prior(ratioAt(i));
}

double SpeedBelief::prior(double ratio) const noexcept {
  const auto density = [&](double sd) {
    const double off = (ratio - 1.0) / sd;
    return std::exp(-0.5 * off * off) / sd;
  };
  const double controlled = std::min(kControlledSd, priorSd_);
  return std::log(kControlled * density(controlled) + (1.0 - kControlled) * density(priorSd_) + 1e-30) +
         std::log(controlled);
}

bool SpeedBelief::plausible(std::size_t cell) const noexcept {
  return log_[cell] > -kPlausible;
}

double SpeedBelief::likelihood(std::size_t cell) const noexcept {
  return std::exp(log_[cell]);
}

void SpeedBelief::drift() noexcept {
  const auto size = static_cast<int>(log_.size());
  for (int i = 0; i < size; ++i) {
    double best = log_[static_cast<std::size_t>(i)];
    for (int d = -kReach; d <= kReach; ++d) {
      if (i + d < 0 || i + d >= size) continue;
      const double step = d * kCell / kWander;
      best = std::max(best, log_[static_cast<std::size_t>(i + d)] - 0.5 * step * step);
    }
    moved_[static_cast<std::size_t>(i)] = best;
  }
}

void SpeedBelief::look(const TwoSeries& lines, Hertz told, Seconds since) noexcept {
  if (!(told.value > 0.0) || lines.lines() < 1) return;
  const double before = *std::max_element(log_.begin(), log_.end());
  drift();
  const double forget = std::min(1.0, since.value / kMemory);
  const double counts = heard_ ? std::min(1.0, since.value / kIndependent) : 1.0;
  for (std::size_t i = 0; i < log_.size(); ++i) {
    const double ratio = ratioAt(i);
    score_[i] = lines.fit(told * ratio).score;
    log_[i] = (1.0 - forget) * moved_[i] + forget * prior(ratio) + counts * score_[i];
  }
  surprise(counts);
  chooseNewest(before);
  const double most = *std::max_element(log_.begin(), log_.end());
  for (double& l : log_) l -= most;
  heard_ = true;
  judge();
}

// moved_: as it was before the look. before: its most.
void SpeedBelief::chooseNewest(double before) noexcept {
  const auto fit = [this](std::size_t i) { return score_[i] + prior(ratioAt(i)); };
  const auto top = static_cast<std::size_t>(std::max_element(log_.begin(), log_.end()) - log_.begin());
  std::size_t alone = 0;
  double most = fit(0);
  for (std::size_t i = 1; i < log_.size(); ++i) {
    const double now = fit(i);
    if (now > most) alone = i;
    most = std::max(most, now);
  }
  const std::size_t newest = fitsBetter(alone, top) ? alone : top;
  newest_ = ratioAt(newest);
  newestWasLikely_ = moved_[newest] > before - kPlausible;
}

// The newest look, and by far. Where chatter fills the cut two speeds may fit nearly as well, and take turns.
bool SpeedBelief::fitsBetter(std::size_t cell, std::size_t than) const noexcept {
  return score_[cell] - score_[than] > std::max(kSurprise, kSurprisePart * score_[cell]);
}

void SpeedBelief::surprise(double counts) noexcept {
  const auto top = std::max_element(log_.begin(), log_.end()) - log_.begin();
  const auto best = std::max_element(score_.begin(), score_.end()) - score_.begin();
  const bool other = fitsBetter(static_cast<std::size_t>(best), static_cast<std::size_t>(top));
  surprised_ = other && heard_ ? surprised_ + 1 : 0;
  if (surprised_ < kSurprises) return;
  surprised_ = 0;
  for (std::size_t i = 0; i < log_.size(); ++i) log_[i] = prior(ratioAt(i)) + std::max(counts, 0.5) * score_[i];
}

void SpeedBelief::judge() noexcept {
  const auto top = static_cast<std::size_t>(std::max_element(log_.begin(), log_.end()) - log_.begin());
  const double best = ratioAt(top);
  double all = 0.0;
  double near = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < log_.size(); ++i) {
    const double p = std::exp(log_[i]);
    const double off = ratioAt(i) / best - 1.0;
    all += p;
    if (std::abs(off) >= kSame) continue;
    near += p;
    mean += p * off;
    square += p * off * off;
  }
  mean /= near;
  ratio_ = best * (1.0 + mean);
  const auto fromEnd = [&](double ratio) { return std::log1p(range_) - std::abs(std::log(ratio)); };
  atEdge_ = std::min(fromEnd(ratio_), fromEnd(newest_)) < kEdge;
  sd_ = std::max(0.25 * kCell, std::sqrt(std::max(0.0, square / near - mean * mean)));
  certainty_ = near / all;
}

}  // namespace stillcut::detect
