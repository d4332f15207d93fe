// Numbers of the fuzzy strategies and their declarations. Thread: set-up.
#pragma once

#include <array>

#include "core/base/result.h"
#include "core/config/param_set.h"
#include "core/control/fuzzy_rules.h"

namespace stillcut::control {

struct FuzzyOptions {
  double cycle = 0.25;            // [s]
  double rangeTime = 4.0;         // [s] for the whole range at full output
  double coherenceRef = 0.8;      // gamma_ref
  double energyRef = 1.5;         // E_ref, in stable cuts
  double energyUp = 5.0;          // E_up
  double highest = 1.0;           // of the programme
  double rest = 30.0;             // [s]
  double learning = 0.4;          // w of eq. 3-32
  bool doubleTuning = true;       // eq. 3-36, else 3-37
  double coherenceWeight = 0.65;  // w_gamma
  double energyWeight = 1.25;     // w_E
  SetCentres centres = kUniformCentres;
  RuleTable speedRules = kSpeedRules, feedRules = kFeedRules;
};

// All of them. The rules are parameters like others, one per cell, so that a run with other rules is recorded and
// decided again like any other.
config::ParamTable fuzzyParams();
// The cells alone, row by row: 81 of the speed, 81 of the feed. And the centres of small, medium and big.
config::ParamTable fuzzyRuleParams();
config::ParamTable fuzzyCentreParams();
FuzzyOptions fuzzyOptions(const config::ParamSet& params);
// Whether they can be used with each other: the energy's limit above its reference, tables that fall. Real-time.
bool usableTogether(const FuzzyOptions& options);
// The same with the key and the reason; not real-time.
Status checkFuzzyOptions(const FuzzyOptions& options);

}  // namespace stillcut::control
