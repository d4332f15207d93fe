// How far the overrides may go on this machine with this tool: declared once, read by the gate (which enforces it) and
// by the strategies (which look for a target inside it).
// Thread: checkOverrideLimits() at set-up; the rest are pure functions of values, real-time safe.
#pragma once

#include <algorithm>
#include <limits>

#include "core/base/realtime.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/config/param_set.h"
#include "core/model/cut_setup.h"
#include "core/model/machine_state.h"

namespace stillcut::config {

inline constexpr ParamDecl kLowestSpeedOverride =
    locked(realParam("gate.lowest-speed-override", "Lowest speed override", "%", 50.0, 10.0, 100.0,
                     "Spindle speed is never driven below this fraction of the programmed speed"));
inline constexpr ParamDecl kHighestSpeedOverride =
    locked(realParam("gate.highest-speed-override", "Highest speed override", "%", 120.0, 100.0, 200.0,
                     "Spindle speed is never driven above this fraction of the programmed speed"));
inline constexpr ParamDecl kLowestFeedOverride =
    locked(realParam("gate.lowest-feed-override", "Lowest feed override", "%", 50.0, 0.0, 100.0,
                     "Feed is never driven below this fraction of the programmed feed"));
inline constexpr ParamDecl kHighestFeedOverride =
    locked(realParam("gate.highest-feed-override", "Highest feed override", "%", 120.0, 100.0, 200.0,
                     "Feed is never driven above this fraction of the programmed feed"));
inline constexpr ParamDecl kLowestSpeed =
    locked(autoParam("gate.lowest-speed", "Lowest speed", "rpm", 1.0, 200000.0,
                     "Spindle speed is never driven below this; auto: no such limit"));
inline constexpr ParamDecl kHighestSpeed =
    locked(autoParam("gate.highest-speed", "Highest speed", "rpm", 1.0, 200000.0,
                     "Spindle speed is never driven above this: the machine's limit; auto: none"));
inline constexpr ParamDecl kHighestCuttingSpeed =
    locked(autoParam("gate.highest-cutting-speed", "Highest cutting speed", "m/min", 1.0, 20000.0,
                     "The edge is never driven faster than this; needs the tool's diameter; auto: no such limit"));
inline constexpr ParamDecl kHighestFeedPerTooth =
    locked(realParam("gate.highest-feed-per-tooth", "Highest feed per tooth", "%", 100.0, 100.0, 150.0,
                     "Our overrides never raise the feed per tooth above this fraction of the programmed one"));
inline constexpr ParamDecl kLowestFeedPerTooth = locked(realParam(
    "gate.lowest-feed-per-tooth", "Lowest feed per tooth", "%", 30.0, 0.0, 90.0,
    "Our overrides never lower the feed per tooth below this fraction of the programmed one: the edge would rub"));
inline constexpr ParamDecl kToolSpeed =
    locked(autoParam("gate.tool-highest-speed", "Highest speed of the tool", "rpm", 1.0, 200000.0,
                     "What the maker allows the tool; auto: no such limit"));
inline constexpr ParamDecl kHolderSpeed =
    locked(autoParam("gate.holder-highest-speed", "Highest speed of the holder", "rpm", 1.0, 200000.0,
                     "What holder and balancing allow; auto: no such limit"));
inline constexpr ParamDecl kLowestFeed = locked(autoParam("gate.lowest-feed", "Lowest feed", "mm/min", 0.1, 200000.0,
                                                          "Feed is never driven below this; auto: no such limit"));
inline constexpr ParamDecl kHighestFeed = locked(autoParam("gate.highest-feed", "Highest feed", "mm/min", 0.1, 200000.0,
                                                           "Feed is never driven above this; auto: no such limit"));

inline constexpr const ParamDecl* kOverrideLimitParams[] = {
    &kLowestSpeedOverride, &kHighestSpeedOverride, &kLowestFeedOverride, &kHighestFeedOverride,
    &kLowestSpeed,         &kHighestSpeed,         &kToolSpeed,          &kHolderSpeed,
    &kHighestCuttingSpeed, &kLowestFeed,           &kHighestFeed,        &kLowestFeedPerTooth,
    &kHighestFeedPerTooth};

struct OverrideLimits {
  Ratio lowestSpeed{0.5}, highestSpeed{1.2};  // lowest <= 1 <= highest, and lowest < highest
  Ratio lowestFeed{0.5}, highestFeed{1.2};
  Rpm slowest{0.0};
  Rpm fastest{std::numeric_limits<double>::infinity()};  // of machine, tool, holder and cutting speed
  MetresPerSecond slowestFeed{0.0};
  MetresPerSecond fastestFeed{std::numeric_limits<double>::infinity()};
  double feedPerTooth = 1.0;        // highest ratio of our feed factor to our speed factor, >= 1
  double lowestFeedPerTooth = 0.3;  // lowest one, < 1

  // The feed factor nearest to `feed` that this speed factor allows each tooth.
  constexpr double perTooth(double feed, double speed) const noexcept {
    return std::clamp(feed, lowestFeedPerTooth * speed, feedPerTooth * speed);
  }
};

// What a machine's own override can do (LinkInfo); 1..1 means that it has none.
struct MachineOverrides {
  Ratio lowestSpeed{0.5}, highestSpeed{1.2};
  Ratio lowestFeed{0.5}, highestFeed{1.2};
};

// Reads and cross-checks: crossed or empty ranges and a cutting speed without a diameter are refused, with the key.
// `where` names the origin for the error.
Result<OverrideLimits> checkOverrideLimits(const ParamSet& params, const CutSetup& setup, std::string_view where);

// Narrows the four override ranges in `params` to what the machine can do, so that gate and strategies agree.
Status narrowToMachine(ParamSet& params, const MachineOverrides& machine, std::string_view where);

// Where our factor may be.
struct FactorRange {
  double low = 1.0;
  double high = 1.0;
  constexpr double clamp(double v) const noexcept { return std::clamp(v, low, high); }
  constexpr bool contains(double v) const noexcept { return v >= low && v <= high; }
};

// Both our factor and its product with the operator's knob stay inside the limits. 1 is always inside: what operator
// and program chose is not ours to correct, we only never drive it further out.
// Of the machine: programmed values and knobs. For every speed factor in its range some feed factor in its own keeps
// the feed per tooth inside.
FactorRange speedFactors(const OverrideLimits& limits, const MachineState& machine) STILLCUT_RT;
FactorRange feedFactors(const OverrideLimits& limits, const MachineState& machine) STILLCUT_RT;

// The same as spindle speeds: programmed times knob times factor.
struct SpeedRange {
  Rpm low{};
  Rpm high{};
  constexpr bool contains(Rpm n) const noexcept { return n >= low && n <= high; }
};
SpeedRange reachableSpeeds(const OverrideLimits& limits, const MachineState& machine) STILLCUT_RT;

}  // namespace stillcut::config
