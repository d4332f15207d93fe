#include "core/milling/stability/advice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {

namespace {

constexpr double kDepthSearched = 4.0;  // times the depth asked for

class Adviser {
 public:
  Adviser(const CutModel& model, const AdviceRequest& request, const ExactLobes& lobes, std::stop_token stop)
      : model_(model), request_(request), lobes_(lobes), stop_(std::move(stop)) {}

  // Islands count as they are: the depth asked for must itself be stable, and so all below it down to zero.
  SpeedAdvice run(const LobeSweep& sweep) {
    std::size_t i = 0;
    while (i < sweep.speeds.size()) {
      if (!stable(sweep.speeds[i])) {
        ++i;
        continue;
      }
      std::size_t last = i;
      while (last + 1 < sweep.speeds.size() && stable(sweep.speeds[last + 1])) ++last;
      advice_.pockets.push_back(pocket(sweep, i, last));
      i = last + 1;
    }
    if (advice_.pockets.empty()) advice_.deepest = deepest(sweep);
    return std::move(advice_);
  }

 private:
  bool stable(const SpeedLimits& limits) const { return limitOf(limits) > request_.depth; }

  Metres limitOf(const SpeedLimits& limits) const {
    return limits.hasLimit() ? limits.crossings.front().depth : limits.searchedTo;
  }

  SpeedLimits at(Rpm speed) const {
    return lobes_.limits(speed, {kDepthSearched * request_.depth, true, true, request_.depth}, stop_).value();
  }

  // Bisection between a stable and an unstable speed.
  PocketEdge edge(Rpm inside, Rpm outside) const {
    SpeedLimits beyond;
    while (std::abs((outside - inside).value) > 1e-6 * inside.value && !stop_.stop_requested()) {
      const Rpm middle = 0.5 * (inside + outside);
      SpeedLimits limits = at(middle);
      if (stable(limits)) {
        inside = middle;
      } else {
        outside = middle;
        beyond = std::move(limits);
      }
    }
    if (!beyond.hasLimit()) beyond = at(outside);
    return {inside, beyond.hasLimit() ? beyond.crossings.front().frequency : Hertz(0.0)};
  }

  SpeedPocket pocket(const LobeSweep& sweep, std::size_t first, std::size_t last) const {
    const auto& s = sweep.speeds;
    SpeedPocket p;
    p.from = first > 0 ? edge(s[first].speed, s[first - 1].speed) : PocketEdge{s[first].speed, {}};
    p.to = last + 1 < s.size() ? edge(s[last].speed, s[last + 1].speed) : PocketEdge{s[last].speed, {}};
    std::size_t best = first;
    for (std::size_t i = first; i <= last; ++i) {
      if (limitOf(s[i]) > limitOf(s[best])) best = i;
    }
    p.best = s[best].speed;
    p.limit = limitOf(s[best]);
    // Where nothing limits a stretch of speeds its middle is the best.
    std::size_t end = best;
    while (end + 1 <= last && limitOf(s[end + 1]) >= p.limit) ++end;
    p.best = 0.5 * (p.best + s[end].speed);
    p.limit = limitOf(at(p.best));
    p.margin = p.limit / request_.depth - 1.0;
    p.width = std::min(p.best - p.from.speed, p.to.speed - p.best) / p.best;
    p.removal = removal(p.best);
    return p;
  }

  double removal(Rpm speed) const {
    const double width = model_.engagement.radialImmersion * model_.tool.diameter.value;
    const double feed = request_.feedPerTooth.value * model_.tool.teeth * toHertz(speed).value;
    return request_.depth.value * width * feed;
  }

  std::optional<LargestStableDepth> deepest(const LobeSweep& sweep) const {
    std::optional<LargestStableDepth> best;
    for (const SpeedLimits& limits : sweep.speeds) {
      if (!limits.hasLimit()) continue;
      const StabilityLimit& l = limits.crossings.front();
      if (!best || l.depth > best->depth) best = LargestStableDepth{l.speed, l.depth, l.frequency};
    }
    return best;
  }

  const CutModel& model_;
  const AdviceRequest& request_;
  const ExactLobes& lobes_;
  std::stop_token stop_;
  SpeedAdvice advice_;
};

// Spindle speed at which the edge runs at `cuttingSpeed` [m/min].
Rpm speedLimitOfTool(const Tool& tool, double cuttingSpeed) {
  return Rpm(cuttingSpeed / (std::numbers::pi * tool.diameter.value));
}

}  // namespace

Result<SpeedAdvice> adviseSpeeds(const CutModel& model, const AdviceRequest& request, const std::string& where,
                                 const std::stop_token& stop) {
  const Result<ExactLobes> lobes = ExactLobes::make(model, where);
  if (!lobes) return lobes.error();
  if (Status ok = ExactLobes::checkDepth(kDepthSearched * request.depth); !ok) return ok.error();
  if (request.steps < 8 || request.steps > 5000) return Error{where, message("steps must be 8 to 5000")};
  if (!isFinite(request.feedPerTooth) || request.feedPerTooth.value < 0.0) {
    return Error{where, message("feed per tooth must not be negative")};
  }
  Rpm highest = request.highest;
  bool capped = false;
  if (request.cuttingSpeed) {
    if (!std::isfinite(*request.cuttingSpeed) || !(*request.cuttingSpeed > 0.0)) {
      return Error{where, message("the tool's cutting speed must be above zero")};
    }
    const Rpm tool = speedLimitOfTool(model.tool, *request.cuttingSpeed);
    capped = tool < highest;
    if (capped) highest = tool;
  }
  if (!(request.lowest < highest)) {
    return Error{where, capped ? message("the tool's cutting speed lies below the speed range")
                               : message("the speed range is empty")};
  }
  const Result<std::vector<Rpm>> speeds =
      speedSteps(request.lowest, highest, (highest - request.lowest) / static_cast<double>(request.steps), where);
  if (!speeds) return speeds.error();
  SweepOptions options;
  options.limits = {kDepthSearched * request.depth, true, true, {}};
  options.threads = request.threads;
  Result<LobeSweep> sweep = sweepLobes(model, speeds.value(), options, where, stop);
  if (!sweep) return sweep.error();
  SpeedAdvice advice;
  if (sweep->finished) advice = Adviser(model, request, lobes.value(), stop).run(sweep.value());
  advice.highest = highest;
  advice.cappedByTool = capped;
  advice.warnings = sweep->warnings;
  advice.finished = sweep->finished && !stop.stop_requested();
  return advice;
}

}  // namespace stillcut::milling
