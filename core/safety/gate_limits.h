// GateLimits: every number that the gate obeys, and their declarations. How far the overrides may go is in
// core/config/override_limits.h; here is how fast, how often, and how long the gate waits for what.
// Thread: gateLimits() at set-up; the rest are plain values.
#pragma once

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/config/override_limits.h"
#include "core/safety/intervention_rules.h"

namespace stillcut::safety {

// Overrides are read back in steps of at most 1 %.
inline constexpr double kReadbackRounding = 0.01;

// A move needs samples judged within this: a spindle is there in as long, and what was heard before tells of another
// cut. What is older is held, and by `verdictAge` given up.
inline constexpr Seconds kMoveAge{0.2};

struct GateLimits {
  config::OverrideLimits overrides;
  // Granted by whoever set this run up (profile or scenario), never by a parameter.
  bool autoAllowed = false;

  double speedStep = 0.05;        // largest change of our speed factor per step
  double speedSlew = 1.0;         // largest change of our speed factor per second
  double feedStep = 0.05;         // the same for feed
  double feedSlew = 2.0;          //
  double recoveryFraction = 0.2;  // of step and slew, back toward 100 % when nothing chatters
  Seconds filter{0.02};           // time constant on the wanted factors
  double deadband = 0.005;        // wanted changes up to this are ignored
  int changesPerMinute = 12;      // moves that start from rest or turn back
  Seconds coolDown{20.0};         // after that many
  double speedTolerance = 0.02;   // spindle counts as at speed
  Seconds machineAge{0.3};        // older: stale; gateLimits() makes it of the link's period
  Seconds verdictAge{0.3};        // verdict and request
  Seconds holdTime{0.5};          // bad input: hold this long, then release
  Seconds reengageDelay{1.0};     // after a release: good input for this long before the overrides are taken again
  Seconds operatorPause{2.0};     // after the operator's knob moved
  // Override read back must agree within this. Longer than a link needs that has to find out by itself that the
  // overrides are locked (cnc/lock_judge.h): a lock is not taken for somebody's reset.
  Seconds takeTime{2.0};
  Seconds followTime{5.0};  // actual speed must agree within this
  Seconds lease{0.2};       // of every Set
  InterventionRules interventions;
};

// A machine state is stale after three of its link's periods and `step`, the time between two looks at it.
Seconds staleAfter(Seconds linkPeriod, Seconds step);

// All `gate.*` declarations, those of the override limits included.
config::ParamTable gateParams();

// Reads and cross-checks. Error: key and reason. autoAllowed stays false: set it from profile or scenario.
// `linkPeriod`: as the link declares it (cnc::LinkInfo), 0: no machine. A state is stale after three of them, unless
// told otherwise.
Result<GateLimits> gateLimits(const config::ParamSet& params, const CutSetup& setup, std::string_view where,
                              Seconds linkPeriod = {});

}  // namespace stillcut::safety
