// monitor: watches and never asks for anything. What another strategy had put in force goes back to the programmed
// values: this is also where a strategy that failed falls back to. Thread: as Strategy.
#pragma once

#include "core/control/strategy.h"

namespace stillcut::control {

class Monitor final : public Strategy {
 public:
  StrategyInfo describe() const override;
  void prepare(const CutSetup& setup, const config::ParamSet& params) override;
  OverrideRequest decide(const StrategyInput& input) override;
  void reset() override {}
};

}  // namespace stillcut::control
