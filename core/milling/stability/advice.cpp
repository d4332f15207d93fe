#include "core/milling/stability/advice.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/milling/stability/lobe_refine.h"
#include "core/milling/stability/lobe_sweep.h"

namespace stillcut::milling {

namespace {

constexpr double kDepthSearched = 4.0;  // times the depth asked for
constexpr double kClearOfLimit = 1.1;   // limit over depth that a quiet speed has
constexpr double kClearOfEdge = 0.01;   // of the speed of a pocket's edge
constexpr int kQuietLooks = 60;         // speeds of a pocket compared for their forced vibration
constexpr double kBestStep = 0.5;       // [rev/min]
constexpr double kEdgeStep = 0.05;      // [rev/min]

// The lobes of a cut that is known well, or of those drawn around it: then the limit that a tenth of them undercut.
class DoubtfulLobes {
 public:
  static Result<DoubtfulLobes> make(const CutModel& model, const ModelSpread& spread, const std::string& where) {
    Result<ExactLobes> known = ExactLobes::make(model, where);
    if (!known) return known.error();
    DoubtfulLobes lobes(std::move(known.value()));
    if (!spread.any()) return lobes;
    if (Status ok = check(spread, where); !ok) return ok.error();
    for (const CutModel& one : drawnModels(model, spread)) {
      Result<ExactLobes> drawn = ExactLobes::make(one, where);
      if (!drawn) return drawn.error();
      lobes.drawn_.push_back(std::move(drawn.value()));
    }
    lobes.outside_ = outsideBand(spread);
    return lobes;
  }

  SpeedLimits expected(Rpm speed, const LimitOptions& options, const std::stop_token& stop) const {
    return of(known_, speed, options, stop);
  }

  SpeedLimits limits(Rpm speed, LimitOptions options, const std::stop_token& stop) const {
    if (drawn_.empty()) return expected(speed, options, stop);
    const bool frequencies = std::exchange(options.frequencies, false);
    std::vector<std::pair<Metres, std::size_t>> depths;
    for (std::size_t i = 0; i < drawn_.size(); ++i) {
      depths.emplace_back(limitingDepth(of(drawn_[i], speed, options, stop)), i);
    }
    const auto chosen = depths.begin() + static_cast<std::ptrdiff_t>(outside_);
    std::nth_element(depths.begin(), chosen, depths.end());
    options.frequencies = frequencies;
    options.hint = chosen->first;
    return of(drawn_[chosen->second], speed, options, stop);
  }

  // `sweep` is of the cut as it is known.
  Result<LobeSweep> sweep(LobeSweep sweep, std::span<const Rpm> speeds, const SweepOptions& options,
                          const std::string& where, const std::stop_token& stop) const {
    if (drawn_.empty()) return sweep;
    std::vector<std::vector<SpeedLimits>> all(speeds.size());
    for (const ExactLobes& one : drawn_) {
      Result<LobeSweep> drawn = sweepLobes(one.model(), speeds, options, where, stop);
      if (!drawn || !drawn->finished) return drawn;
      for (std::size_t k = 0; k < speeds.size(); ++k) all[k].push_back(std::move(drawn->speeds[k]));
    }
    const auto lower = [](const SpeedLimits& a, const SpeedLimits& b) { return limitingDepth(a) < limitingDepth(b); };
    for (std::size_t k = 0; k < speeds.size(); ++k) {
      const auto chosen = all[k].begin() + static_cast<std::ptrdiff_t>(outside_);
      std::nth_element(all[k].begin(), chosen, all[k].end(), lower);
      sweep.speeds[k] = std::move(*chosen);
    }
    return sweep;
  }

  const ExactLobes& known() const { return known_; }

 private:
  explicit DoubtfulLobes(ExactLobes known) : known_(std::move(known)) {}

  static SpeedLimits of(const ExactLobes& lobes, Rpm speed, const LimitOptions& options, const std::stop_token& stop) {
    if (!lobes.possible(speed)) return {speed, {}, {}, false};
    return lobes.limits(speed, options, stop).value();
  }

  ExactLobes known_;
  std::vector<ExactLobes> drawn_;
  std::size_t outside_ = 0;
};

class Adviser {
 public:
  Adviser(const CutModel& model, const AdviceRequest& request, const DoubtfulLobes& lobes, std::stop_token stop)
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

  Metres limitOf(const SpeedLimits& limits) const { return limitingDepth(limits); }

  SpeedLimits at(Rpm speed) const {
    return lobes_.limits(speed, {kDepthSearched * request_.depth, true, true, request_.depth}, stop_);
  }

  // Bisection between a stable and an unstable speed.
  PocketEdge edge(Rpm inside, Rpm outside) const {
    SpeedLimits beyond;
    while (std::abs((outside - inside).value) >
               std::max(request_.finest.value, std::min(kEdgeStep, 1e-4 * inside.value)) &&
           !stop_.stop_requested()) {
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
    p.best = end > best ? 0.5 * (p.best + s[end].speed)
                        : climbed(p.best, best > first ? s[best - 1].speed : p.from.speed,
                                  best < last ? s[best + 1].speed : p.to.speed);
    const bool begins = first > 0, ends = last + 1 < s.size();
    p.best = clearOfEdges(p.best, begins ? p.from.speed : Rpm(0.0), ends ? p.to.speed : Rpm(0.0), p);
    p.limit = limitOf(at(p.best));
    p.open = nothingFound(p.limit);
    p.expected = p.limit;
    if (request_.spread.any()) {
      p.expected = limitOf(lobes_.expected(p.best, {kDepthSearched * request_.depth, true, false, p.limit}, stop_));
    }
    p.margin = p.limit / request_.depth - 1.0;
    p.width = std::min(p.best - p.from.speed, p.to.speed - p.best) / p.best;
    p.removal = removal(p.best);
    if (request_.feedPerTooth.value > 0.0) {
      p.forced = forcedVibration(model_, p.best, request_.depth, request_.feedPerTooth);
      if (p.forced) p.quietest = quietest(p.from.speed, p.to.speed);
    }
    return p;
  }

  bool nothingFound(Metres limit) const { return limit >= (1.0 - 1e-9) * kDepthSearched * request_.depth; }

  // Inside the pocket, and where chatter begins at an edge (0: it does not) a little away from that.
  static Rpm clearOfEdges(Rpm best, Rpm low, Rpm high, const SpeedPocket& p) {
    const Rpm quarter = 0.25 * (p.to.speed - p.from.speed);
    const Rpm from = low.value > 0.0 ? low + std::min(kClearOfEdge * low, quarter) : p.from.speed;
    const Rpm to = high.value > 0.0 ? high - std::min(kClearOfEdge * high, quarter) : p.to.speed;
    return std::clamp(best, from, to);
  }

  // The speed of the largest limit between two that lie lower: finer and finer grids around the best so far.
  Rpm climbed(Rpm best, Rpm low, Rpm high) const {
    constexpr int kCells = 8;
    Metres limit = limitOf(at(best));
    while (high - low > std::max(request_.finest, Rpm(kBestStep)) && !stop_.stop_requested()) {
      const Rpm from = low, step = (high - low) / static_cast<double>(kCells);
      for (int i = 1; i < kCells; ++i) {
        const Rpm speed = from + static_cast<double>(i) * step;
        const Metres there = limitOf(at(speed));
        if (there > limit) {
          limit = there;
          best = speed;
        }
      }
      low = std::max(low, best - step);
      high = std::min(high, best + step);
    }
    return best;
  }

  std::optional<QuietestSpeed> quietest(Rpm from, Rpm to) const {
    std::vector<QuietestSpeed> looks;
    for (int i = 0; i <= kQuietLooks; ++i) {
      const Rpm speed = from + (to - from) * (static_cast<double>(i) / kQuietLooks);
      if (auto forced = forcedVibration(model_, speed, request_.depth, request_.feedPerTooth)) {
        looks.push_back({speed, {}, *forced, false});
      }
    }
    std::sort(looks.begin(), looks.end(),
              [](const auto& a, const auto& b) { return a.forced.acceleration < b.forced.acceleration; });
    for (QuietestSpeed& look : looks) {
      look.limit = limitOf(at(look.speed));
      look.open = nothingFound(look.limit);
      if (look.limit >= kClearOfLimit * request_.depth) return look;
    }
    return std::nullopt;
  }

  double removal(Rpm speed) const {
    if (model_.turning) {
      const double around = std::numbers::pi * model_.tool.diameter.value * toHertz(speed).value;
      return request_.depth.value * request_.feedPerTooth.value * model_.tool.teeth * around;
    }
    const double width = model_.engagement.radialImmersion * model_.tool.diameter.value;
    const double feed = request_.feedPerTooth.value * model_.tool.teeth * toHertz(speed).value;
    return request_.depth.value * width * feed;
  }

  std::optional<LargestStableDepth> deepest(const LobeSweep& sweep) const {
    const auto& s = sweep.speeds;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s[i].hasLimit() && (!best || limitOf(s[i]) > limitOf(s[*best]))) best = i;
    }
    if (!best) return std::nullopt;
    const Rpm speed =
        climbed(s[*best].speed, s[*best > 0 ? *best - 1 : 0].speed, s[std::min(*best + 1, s.size() - 1)].speed);
    const SpeedLimits limits = at(speed);
    const StabilityLimit& l = limits.hasLimit() ? limits.crossings.front() : s[*best].crossings.front();
    return LargestStableDepth{l.speed, l.depth, l.frequency};
  }

  const CutModel& model_;
  const AdviceRequest& request_;
  const DoubtfulLobes& lobes_;
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
  const Result<DoubtfulLobes> lobes = DoubtfulLobes::make(model, request.spread, where);
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
  if (Status ok = lobes->known().checkSpeed(request.lowest); !ok) return ok.error();
  const std::vector<Rpm> speeds = speedsAcross(model, request.lowest, highest, request.steps);
  if (speeds.back() < highest) {
    return Error{where, message("the speed range holds more lobes than can be looked at"),
                 message("raise the lowest speed")};
  }
  SweepOptions options;
  options.limits = {kDepthSearched * request.depth, true, true, {}};
  options.threads = request.threads;
  Result<LobeSweep> sweep = sweepLobes(model, speeds, options, where, stop);
  if (!sweep) return sweep.error();
  if (sweep->finished) sweep = lobes->sweep(std::move(sweep.value()), speeds, options, where, stop);
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
