#include "core/control/monitor.h"

#include "core/control/common_reasons.h"

namespace stillcut::control {

StrategyInfo Monitor::describe() const {
  return {"monitor", "Monitoring only", ""};
}

void Monitor::prepare(const CutSetup& /*setup*/, const config::ParamSet& /*params*/) {}

OverrideRequest Monitor::decide(const StrategyInput& input) {
  OverrideRequest request;
  request.time = input.now;
  request.kind = RequestKind::Release;
  request.reason = monitoringAt(input);
  return request;
}

}  // namespace stillcut::control
