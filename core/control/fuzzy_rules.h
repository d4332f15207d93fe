// Xu 2003, section 3.3: the fuzzy machine without its purpose. Inputs are normalised to -1 .. 1 and belong to nine
// triangular sets NX, NB, NM, NS, ZE, PS, PM, PB, PX (the energy to seven, NB .. PB); rules hold singletons 1 .. 9 (ZE
// = 5), both tables editable; a rule counts as much as its weakest input (eq. 3-22, 3-24); the answer is the weighted
// average (eq. 3-23). The triangles are uniform unless set otherwise: figure 3.6 gives no numbers. The paper's example
// of eq. 3-23 prints 5.88 with a wrong denominator; weights .1 .1 .3 .7 on 5 5 5 4 give 4.4167. Where the coherence's
// triangles have their peaks can be set, alike on both sides of zero; each reaches to its neighbours' peaks, so that
// the degrees sum to 1 wherever they are. Figure 3.9 prints PB for energy PB; energy above its reference must lower
// speed and feed (table 3.1), so its sign is turned. Pure functions of values, real-time safe.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/base/realtime.h"

namespace stillcut::control {

inline constexpr int kCoherenceSets = 9;
inline constexpr int kEnergySets = 7;
inline constexpr double kZero = 5.0;  // the singleton that asks for nothing

// Peaks of small, medium and big on the normalised axis, rising, between 0 (ZE) and 1 (the outermost).
using SetCentres = std::array<double, 3>;
inline constexpr SetCentres kUniformCentres{0.25, 0.5, 0.75};

using RuleTable = std::array<std::array<double, kCoherenceSets>, kCoherenceSets>;  // [E gamma][C gamma]

extern const RuleTable kSpeedRules;                         // figure 3.7
extern const RuleTable kFeedRules;                          // figure 3.8
extern const std::array<double, kEnergySets> kEnergyRules;  // figure 3.9, sign turned

// More coherence error, and more of its change, must never ask for more speed or feed (table 3.1;
// figures 3.7, 3.8, 3.17 and 3.18 fall everywhere). A user may put a rule up to one singleton over those it must not
// exceed; beyond that the table pulls toward chatter.
inline constexpr double kMostRise = 1.0;
struct RisingRule {
  std::size_t row = 0, column = 0;          // asks for more than
  std::size_t overRow = 0, overColumn = 0;  // this one, of less error or less change
};
// The rule that rises most over one before it in its column or row; empty: none by more than kMostRise.
std::optional<RisingRule> risingRule(const RuleTable& table) STILLCUT_RT;

// Degrees of belonging to `Sets` uniform triangles over -1 .. 1; they sum to 1. Outside: the outermost set.
template <int Sets>
std::array<double, Sets> memberships(double x) STILLCUT_RT;
// Nine triangles with their peaks at 0, +-centres and +-1.
std::array<double, kCoherenceSets> memberships(double x, const SetCentres& centres) STILLCUT_RT;

// Eq. 3-23, one rule after another.
class WeightedAverage {
 public:
  void add(double weight, double value) STILLCUT_RT {
    weights_ += weight;
    sum_ += weight * value;
  }
  double value() const STILLCUT_RT { return weights_ > 0.0 ? sum_ / weights_ : kZero; }

 private:
  double weights_ = 0.0, sum_ = 0.0;
};

struct FuzzyInputs {
  double coherence = 0.0;  // E gamma, normalised
  double change = 0.0;     // C gamma, normalised
  double energy = 0.0;     // EE, normalised
  bool energyKnown = false;
};

// Strength of every coherence rule, by row and column.
RuleTable firing(const FuzzyInputs& in, const SetCentres& centres = kUniformCentres) STILLCUT_RT;
// -1 (down as fast as allowed) .. 1: all rules that fire, of the table and of the energy row.
double infer(const RuleTable& table, const FuzzyInputs& in, const SetCentres& centres = kUniformCentres) STILLCUT_RT;

}  // namespace stillcut::control
