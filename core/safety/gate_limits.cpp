#include "core/safety/gate_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace stillcut::safety {
namespace {

using config::autoParam;
using config::integerParam;
using config::locked;
using config::ParamDecl;
using config::realParam;

constexpr ParamDecl kSpeedStep = locked(
    realParam("gate.speed-step", "Speed change per step", "%", 5.0, 0.01, 20.0,
              "Largest change of the speed override in one step of the gate, in percent of the programmed speed"));
constexpr ParamDecl kSpeedSlew =
    locked(realParam("gate.speed-slew", "Speed change per second", "%/s", 100.0, 0.1, 500.0,
                     "Fastest change of the speed override, in percent of the programmed speed per second"));
constexpr ParamDecl kFeedStep =
    locked(realParam("gate.feed-step", "Feed change per step", "%", 5.0, 0.01, 50.0,
                     "Largest change of the feed override in one step of the gate, in percent of the programmed feed"));
constexpr ParamDecl kFeedSlew =
    locked(realParam("gate.feed-slew", "Feed change per second", "%/s", 200.0, 0.1, 1000.0,
                     "Fastest change of the feed override, in percent of the programmed feed per second"));
constexpr ParamDecl kRecoveryShare =
    locked(realParam("gate.recovery-share", "Recovery rate", "%", 20.0, 1.0, 20.0,
                     "Rate of the way back toward 100 % when nothing chatters, as a share of the rate away from it"));
constexpr ParamDecl kFilter = locked(realParam("gate.filter", "Smoothing", "ms", 20.0, 0.0, 1000.0,
                                               "Time constant of the low-pass on the wanted overrides"));
constexpr ParamDecl kDeadband = locked(realParam("gate.deadband", "Dead band", "%", 0.5, 0.01, 5.0,
                                                 "Wanted changes up to this are not worth moving the machine"));
constexpr ParamDecl kChangesPerMinute =
    locked(integerParam("gate.changes-per-minute", "Changes per minute", 12, 1, 120,
                        "Moves that start from rest or turn back, at most so many in any minute"));
constexpr ParamDecl kCoolDown =
    locked(realParam("gate.cool-down", "Cool-down", "s", 20.0, 1.0, 600.0,
                     "Pause after the changes per minute are used up; the second time Auto falls back to Advise"));
constexpr ParamDecl kSpeedTolerance =
    locked(realParam("gate.speed-tolerance", "Speed tolerance", "%", 2.0, 0.1, 10.0,
                     "The spindle counts as at speed, and an override as taken, within this"));
constexpr ParamDecl kMachineAge =
    locked(autoParam("gate.machine-age", "Machine state age", "ms", 10.0, 5000.0,
                     "A machine state older than this is stale; auto: three of the link's own periods and a block"));
constexpr ParamDecl kVerdictAge = locked(realParam("gate.verdict-age", "Verdict age", "ms", 300.0, 10.0, 5000.0,
                                                   "A verdict or request older than this is stale"));
constexpr ParamDecl kHoldTime =
    locked(realParam("gate.hold-time", "Hold before release", "ms", 500.0, 0.0, 5000.0,
                     "On bad input the overrides are held this long, then the programmed values come back"));
constexpr ParamDecl kRestTime =
    locked(realParam("gate.rest-time", "Rest after release", "s", 1.0, 0.0, 60.0,
                     "After a release the input must be good for this long before the overrides are taken again"));
constexpr ParamDecl kKnobTime = locked(realParam("gate.knob-time", "Pause after the knob", "s", 2.0, 0.0, 60.0,
                                                 "After the operator turned a knob nothing new is asked this long"));
constexpr ParamDecl kTakeTime =
    locked(realParam("gate.take-time", "Time to take an override", "s", 2.0, 0.1, 10.0,
                     "The override read back must agree with the command within this, or the machine is let go"));
constexpr ParamDecl kFollowTime =
    locked(realParam("gate.follow-time", "Time for the spindle to follow", "s", 5.0, 0.2, 60.0,
                     "The spindle must reach the commanded speed within this, or the machine is let go"));
constexpr ParamDecl kLease =
    locked(realParam("gate.lease", "Lease", "ms", 200.0, 20.0, 2000.0,
                     "A command that is not renewed within this ends, and the programmed values come back"));

constexpr const ParamDecl* kOwn[] = {
    &kSpeedStep, &kSpeedSlew,        &kFeedStep, &kFeedSlew,       &kRecoveryShare, &kFilter,
    &kDeadband,  &kChangesPerMinute, &kCoolDown, &kSpeedTolerance, &kMachineAge,    &kVerdictAge,
    &kHoldTime,  &kRestTime,         &kKnobTime, &kTakeTime,       &kFollowTime,    &kLease};

constexpr auto joined() {
  std::array<const ParamDecl*, std::size(kOwn) + std::size(config::kOverrideLimitParams)> all{};
  std::size_t n = 0;
  for (const ParamDecl* decl : config::kOverrideLimitParams) all[n++] = decl;
  for (const ParamDecl* decl : kOwn) all[n++] = decl;
  return all;
}
constexpr auto kAll = joined();

// Of the link's periods. A state that misses one reading is nothing, three in a row are a link in trouble.
constexpr double kStalePeriods = 3.0;
// The link's thread waits its turn on a busy computer like everybody else.
constexpr Seconds kYoungestStale{0.1};
// Shorter than this, and a state would be stale although the link does all that it can.
constexpr double kFewestPeriods = 2.0;

Error refuse(std::string_view where, const ParamDecl& key, const Message& what, const Message& why) {
  return Error{std::string(where) + ": " + std::string(key.key), what, why};
}

Status fitToLink(GateLimits& limits, const config::ParamSet& params, Seconds linkPeriod, Seconds block,
                 std::string_view where) {
  const bool automatic = params.isAutomatic(kMachineAge);
  limits.machineAge = automatic ? staleAfter(linkPeriod, block) : Seconds(params.real(kMachineAge) / 1000.0);
  const Seconds fewest = linkPeriod * kFewestPeriods;
  const Message why = message("the link reads the machine every %1 ms: at least two of its periods",
                              std::lround(1e3 * linkPeriod.value));
  if (limits.machineAge < fewest) {
    return refuse(where, kMachineAge, message("every machine state would be stale"), why);
  }
  if (limits.takeTime < fewest) {
    return refuse(where, kTakeTime, message("no override could be seen in force in time"), why);
  }
  return Done{};
}

}  // namespace

Seconds staleAfter(Seconds linkPeriod, Seconds step) {
  return std::max(kYoungestStale, linkPeriod * kStalePeriods) + step;
}

config::ParamTable gateParams() {
  return kAll;
}

Result<GateLimits> gateLimits(const config::ParamSet& params, const CutSetup& setup, std::string_view where,
                              Seconds linkPeriod) {
  const Result<config::OverrideLimits> overrides = config::checkOverrideLimits(params, setup, where);
  if (!overrides) return overrides.error();
  const auto share = [&](const ParamDecl& decl) { return params.real(decl) / 100.0; };
  const auto milli = [&](const ParamDecl& decl) { return Seconds(params.real(decl) / 1000.0); };
  GateLimits limits;
  limits.overrides = *overrides;
  limits.speedStep = share(kSpeedStep);
  limits.speedSlew = share(kSpeedSlew);
  limits.feedStep = share(kFeedStep);
  limits.feedSlew = share(kFeedSlew);
  limits.recoveryFraction = share(kRecoveryShare);
  limits.filter = milli(kFilter);
  limits.deadband = share(kDeadband);
  limits.changesPerMinute = params.integer(kChangesPerMinute);
  limits.coolDown = Seconds(params.real(kCoolDown));
  limits.speedTolerance = share(kSpeedTolerance);
  limits.verdictAge = milli(kVerdictAge);
  limits.holdTime = milli(kHoldTime);
  limits.reengageDelay = Seconds(params.real(kRestTime));
  limits.operatorPause = Seconds(params.real(kKnobTime));
  limits.takeTime = Seconds(params.real(kTakeTime));
  limits.followTime = Seconds(params.real(kFollowTime));
  limits.lease = milli(kLease);
  if (setup.rate.value > 0.0 && limits.lease.value < 2.0 * setup.blockFrames / setup.rate.value) {
    return refuse(where, kLease, message("the lease is shorter than two blocks"),
                  message("it would run out between two commands"));
  }
  const Seconds block(setup.rate.value > 0.0 ? setup.blockFrames / setup.rate.value : 0.0);
  if (const Status fits = fitToLink(limits, params, linkPeriod, block, where); !fits) return fits.error();
  return limits;
}

}  // namespace stillcut::safety
