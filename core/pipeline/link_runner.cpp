#include "core/pipeline/link_runner.h"

namespace stillcut::pipeline {

void LinkRunner::tick(Instant now) noexcept {
  lastTick_ = now;
  if (!finished_) {
    const auto newest = commands_.latest();
    switch (lease_.poll(newest ? &*newest : nullptr, now)) {
      case safety::LinkAction::Apply:
        link_.apply(*newest, now);
        break;
      case safety::LinkAction::Release:
        link_.release(now);
        break;
      case safety::LinkAction::Nothing:
        break;
    }
    leasesExpired_.store(lease_.expiries(), std::memory_order_relaxed);
  }
  MachineState state = link_.read(now);
  state.endedEngagement = lease_.endedEngagement();
  states_.post(state);
}

void LinkRunner::finish() noexcept {
  if (finished_) return;
  finished_ = true;
  if (lease_.inForce()) link_.release(lastTick_);
  link_.close();
}

}  // namespace stillcut::pipeline
