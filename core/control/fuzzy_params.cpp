#include "core/control/fuzzy_params.h"

namespace stillcut::control {
namespace {

using config::ParamDecl;
using config::realParam;

constexpr ParamDecl kCycle =
    realParam("fuzzy.cycle", "Control cycle", "ms", 250.0, 50.0, 2000.0, "Speed and feed are changed once per cycle");
constexpr ParamDecl kRangeTime =
    realParam("fuzzy.range-time", "Time for the whole range", "s", 4.0, 1.0, 60.0,
              "At full output the whole range of an override takes this long (the paper's limit: a second)");
constexpr ParamDecl kCoherenceRef = realParam("fuzzy.coherence-reference", "Coherence reference", "", 0.8, 0.1, 0.95,
                                              "Coherence above which speed and feed fall (gamma_ref)");
constexpr ParamDecl kEnergyRef = realParam("fuzzy.energy-reference", "Energy reference", "", 1.5, 1.05, 20.0,
                                           "Vibration over that of the stable cut above which speed and feed fall");
constexpr ParamDecl kEnergyUp = realParam("fuzzy.energy-limit", "Energy limit", "", 5.0, 1.1, 100.0,
                                          "Vibration over that of the stable cut at which the feed goes to its lowest; "
                                          "at twice that the feed is held");
constexpr ParamDecl kHighest = realParam("fuzzy.highest", "Highest overrides", "%", 100.0, 100.0, 150.0,
                                         "Speed and feed rise no further than this share of the programmed values");
constexpr ParamDecl kRest = realParam("fuzzy.rest", "Rest of the speed", "s", 30.0, 0.0, 600.0,
                                      "The speed does not rise for so long after an alarm");
constexpr ParamDecl kLearning = realParam("fuzzy-learning.weight", "Learning weight", "", 0.4, 0.0, 0.8,
                                          "Share of the coherence error that the rules learn (w of eq. 3-32)");
constexpr std::string_view kTunings[] = {"single", "double"};
constexpr ParamDecl kTuning = config::choiceParam("fuzzy-direct.tuning", "Direct tuning", 1, kTunings,
                                                  "By coherence alone (eq. 3-37) or by coherence and energy (3-36)");
constexpr ParamDecl kCoherenceWeight = realParam("fuzzy-direct.coherence-weight", "Coherence weight", "", 0.65, 0.1,
                                                 2.0, "Weight of the coherence error (w_gamma of eq. 3-34)");
constexpr ParamDecl kEnergyWeight = realParam("fuzzy-direct.energy-weight", "Energy weight", "", 1.25, 0.1, 3.0,
                                              "Weight of the energy error (w_E of eq. 3-35)");
constexpr const ParamDecl* kParams[] = {&kCycle,    &kRangeTime,       &kCoherenceRef, &kEnergyRef,
                                        &kEnergyUp, &kHighest,         &kRest,         &kLearning,
                                        &kTuning,   &kCoherenceWeight, &kEnergyWeight};

}  // namespace

config::ParamTable fuzzyParams() {
  return kParams;
}

FuzzyOptions fuzzyOptions(const config::ParamSet& params) {
  FuzzyOptions o;
  o.cycle = params.real(kCycle) / 1000.0;
  o.rangeTime = params.real(kRangeTime);
  o.coherenceRef = params.real(kCoherenceRef);
  o.energyRef = params.real(kEnergyRef);
  o.energyUp = params.real(kEnergyUp);
  o.highest = params.real(kHighest) / 100.0;
  o.rest = params.real(kRest);
  o.learning = params.real(kLearning);
  o.doubleTuning = params.choice(kTuning) == 1;
  o.coherenceWeight = params.real(kCoherenceWeight);
  o.energyWeight = params.real(kEnergyWeight);
  return o;
}

}  // namespace stillcut::control
