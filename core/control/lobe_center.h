// lobe-center: van Dijk 2010, section 4.1: puts the tooth passing, or a harmonic of it, on the chatter frequency.
// Equations and departures: resources/manual/developers/laws.md#lobe-center. Thread: as Strategy.
#pragma once

#include "core/control/frequency_rule.h"

namespace stillcut::control {

config::ParamTable lobeCenterParams();

class LobeCenter final : public FrequencyRule {
 public:
  StrategyInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  void retune(const config::ParamSet& params) override;

 private:
  Aim aim(const RuleView& view) override;
};

}  // namespace stillcut::control
