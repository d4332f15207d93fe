#include "core/learn/lobe_posterior.h"

#include <algorithm>
#include <cmath>

namespace stillcut::learn {
namespace {

// The grid reaches a little beyond the range: lobes are looked up at speeds around a cut's.
SpeedGrid gridOf(const LearnRange& range) {
  SpeedGrid grid;
  grid.lowest = 0.93 * range.lowest.value;
  grid.highest = 1.07 * range.highest.value;
  // 0.6 % from one speed to the next: half of what their place is off by.
  grid.points = std::clamp(static_cast<int>(std::log(grid.highest / grid.lowest) / 0.006), 64, 512);
  return grid;
}

}  // namespace

LearnRange rangeOf(std::span<const CutEvidence> cuts, Rpm lowest, Rpm highest, Metres deepest) {
  LearnRange range{lowest, highest, deepest};
  for (const CutEvidence& cut : cuts) {
    range.lowest = std::min(range.lowest, cut.speed);
    range.highest = std::max(range.highest, cut.speed);
    range.deepest = std::max(range.deepest, 2.0 * cut.depth);
  }
  return range;
}

LobePosterior::LobePosterior(const MachinePrior& prior, const LearnRange& range, const LearnParams& params)
    : prior_(prior),
      range_(range),
      params_(params),
      grid_(gridOf(range)),
      random_(params.seed),
      cloud_(prior, grid_, range.deepest.value, params.guesses, random_),
      fresh_(prior, grid_, range.deepest.value, params.guesses / 2, random_) {}

std::size_t LobePosterior::shapeOf(const milling::Engagement& engagement, int teeth) {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    if (shapes_[i].covers(engagement, teeth)) return i;
  }
  shapes_.push_back(makeShape(engagement, teeth, params_));
  cloud_.addShape(shapes_.back());
  fresh_.addShape(shapes_.back());
  return shapes_.size() - 1;
}

Status LobePosterior::add(const CutEvidence& cut) {
  if (Status ok = check(cut, "cut"); !ok) return ok;
  if (cut.speed < range_.lowest || cut.speed > range_.highest) {
    return Error{message("cut"), message("its speed lies outside what is looked at")};
  }
  cuts_.push_back(cut);
  shapeOfCut_.push_back(shapeOf(cut.engagement, cut.teeth));
  const auto newest = condense(std::span(cuts_).last(1), std::span(shapeOfCut_).last(1), shapes_, params_);
  const double expected = cloud_.logPredictive(newest.front(), params_);
  expected_.push_back(expected);
  // The density of a frequency is no probability: only the verdict's part of it is given.
  Term verdict = newest.front();
  verdict.frequency = 0.0;
  lastExpected_ = std::exp(cloud_.logPredictive(verdict, params_));
  if (const std::size_t other = cutsOfAnother(); other > 0) {
    beginAnew(other);
    return Done{};
  }
  cloud_.update(condense(cuts_, shapeOfCut_, shapes_, params_), params_, random_);
  return Done{};
}

// The newest cuts as a fresh tool would have made them, against what was expected of the one that was learned.
std::size_t LobePosterior::cutsOfAnother() {
  const std::size_t most = std::min<std::size_t>(static_cast<std::size_t>(params_.changedMostCuts), cuts_.size() - 1);
  double expected = expected_.back();
  std::size_t best = 0;
  double bestOdds = params_.changedOdds;
  for (std::size_t k = 2; k <= most; ++k) {
    expected += expected_[expected_.size() - k];
    const auto terms = condense(std::span(cuts_).last(k), std::span(shapeOfCut_).last(k), shapes_, params_);
    const double odds = fresh_.logEvidence(terms, params_) - expected;
    if (odds > bestOdds) {
      bestOdds = odds;
      best = k;
    }
  }
  return best;
}

void LobePosterior::beginAnew(std::size_t keep) {
  const std::size_t gone = cuts_.size() - keep;
  forgotten_ += static_cast<int>(gone);
  startedAnew_ = message(
      "the last %1 cuts do not fit the %2 before: another tool, holder or clamping? The lobes were started anew", keep,
      gone);
  const auto drop = [&](auto& list) { list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(gone)); };
  drop(cuts_);
  drop(shapeOfCut_);
  drop(expected_);
  cloud_ = GuessCloud(prior_, grid_, range_.deepest.value, params_.guesses, random_);
  for (const Shape& s : shapes_) cloud_.addShape(s);
  cloud_.update(condense(cuts_, shapeOfCut_, shapes_, params_), params_, random_);
}

}  // namespace stillcut::learn
