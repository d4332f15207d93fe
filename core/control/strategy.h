// Strategy: one published law that turns verdicts into requests. How to add one: core/control/ADDING.md.
// A pure decision from verdict, machine state and measured time: it keeps its own memory and touches nothing else.
// Thread: worker. prepare() may allocate and throw; the rest may do neither. Should it throw all the same, the chain
// takes that as a fault and drops to monitoring: nothing inside may be noexcept, which would end the program.
#pragma once

#include <string_view>

#include "core/config/param_set.h"
#include "core/model/cut_setup.h"
#include "core/model/machine_state.h"
#include "core/model/override_request.h"
#include "core/model/rule_tables.h"
#include "core/model/verdict.h"

namespace stillcut::control {

struct StrategyInfo {
  std::string_view id;      // "lobe-center"
  std::string_view label;   // "Centre of the lobe"
  std::string_view source;  // "van Dijk 2010, section 4.1"
  // Id of the detector whose indicators it weighs besides the verdict in charge ("coherence"); it runs whenever the
  // strategy does. Empty: the verdict in charge is enough.
  std::string_view requiredDetector = {};
};

struct StrategyInput {
  Instant now{};  // end of the block the verdict is from
  Seconds dt{};   // measured time since the previous decision
  Verdict verdict;
  // As read, but for operatorSpeed and operatorFeed: the knobs by which the gate divides what is asked for
  // (safety::WishKnobs). While something of ours is in force they may differ from the newest read: a
  // knob that is turned then scales what is in force, and a strategy that saw it turned would count it twice.
  MachineState machine;
  // H(f_c) = |1/D(f_c)|^2 (van Dijk 2010 eq. 26), of whichever detector reports it, for the strategies that lower it;
  // negative: unknown, the verdict's severity stands in for it.
  double perturbation = -1.0;
  double vibration = -1.0;  // rms of the first channel, SI; negative: unknown
  // gamma_max, 0 .. 1, and E_r (eq. 3-8, the sensor's SI unit) of Xu 2003; negative: unknown.
  double coherence = -1.0;
  double energy = -1.0;
};

class Strategy {
 public:
  virtual ~Strategy() = default;
  // Who it is; the same before and after prepare(). Any thread.
  virtual StrategyInfo describe() const = 0;
  // For one cut, before the first decide(), also again after a cut; not real-time. Throws std::runtime_error with one
  // line for values that cannot be used with each other or with this cut.
  virtual void prepare(const CutSetup& setup, const config::ParamSet& params) = 0;
  // New values of parameters that are not locked while running; its memory stays. A value that cannot be used with the
  // others leaves all as they were. Between blocks, real-time.
  virtual void retune(const config::ParamSet& /*params*/) {}
  // One block's verdict gives one request. Real-time; an exception is taken as a fault and drops to monitoring. An
  // unusable verdict or machine state gives Hold or None, never a Set.
  virtual OverrideRequest decide(const StrategyInput& input) = 0;
  // As after prepare(): nothing known of the cut, nothing asked for. Real-time.
  virtual void reset() = 0;
  // The operator has taken the machine back, or changed who may drive it: what was asked for so far is over and may not
  // come back with the next grant. What was learned of the cut may stay. Real-time.
  virtual void relinquish() { reset(); }
  // Of a fuzzy strategy: its rules as of the last cycle, what was learned included. False, and `into` left alone: it
  // has none. Any thread, for a screen: each cell is true by itself.
  virtual bool readRules(RuleTables& /*into*/) const { return false; }
};

}  // namespace stillcut::control
