#include "core/pipeline/link_runner.h"

#include <algorithm>

namespace stillcut::pipeline {

namespace {

// Between two looks at two clocks this thread may be kept waiting for a while.
constexpr Duration kShortestSleep = std::chrono::milliseconds(100);
constexpr Duration kLongestGap = std::chrono::milliseconds(500);

}  // namespace

// A computer that was put to sleep has not renewed anything meanwhile, whatever the clock says that slept with it.
void LinkRunner::watchTime(Instant now) noexcept {
  const Duration ahead = boot_ != nullptr ? boot_->now() - now : Duration{};
  const Duration slept = ticked_ ? ahead - ahead_ : Duration{};
  const bool hasSlept = slept > kShortestSleep;
  if (hasSlept) asleep_ += slept;
  if (!ticked_ || hasSlept) ahead_ = ahead;
  if (hasSlept || (ticked_ && now - lastTick_ > kLongestGap)) stalls_.fetch_add(1, std::memory_order_relaxed);
  ticked_ = true;
  lastTick_ = now;
  lastTick_ns_.store(toNs(now), std::memory_order_relaxed);
}

void LinkRunner::tick(Instant now) noexcept {
  watchTime(now);
  if (!finished_) {
    const auto newest = commands_.latest();
    switch (lease_.poll(newest ? &*newest : nullptr, now + asleep_)) {
      case safety::LinkAction::Apply:
        effect_.commanded(newest->speed(), newest->feed(), now);
        released_.set();
        link_.apply(*newest, now);
        break;
      case safety::LinkAction::Release:
        effect_.commanded(Ratio(1.0), Ratio(1.0), now);
        released_.release(now);
        link_.release(now);
        break;
      case safety::LinkAction::Nothing:
        break;
    }
    leasesExpired_.store(lease_.expiries(), std::memory_order_relaxed);
  }
  MachineState state = link_.read(now);
  state.endedEngagement = std::max(state.endedEngagement, lease_.endedEngagement());
  released_.look(state);
  notYetBack_.store(released_.notYetBack(), std::memory_order_relaxed);
  measure(state);
  states_.post(state);
}

void LinkRunner::measure(MachineState& state) noexcept {
  const bool steady = state.valid && state.overridesEnabled && state.controlOurs && !state.feedHold;
  if (!steady) {
    effect_.forget();
  } else if (state.link.overrides != Instant{} && state.operatorSpeed.value > 0.0 && state.operatorFeed.value > 0.0) {
    effect_.shown(Ratio(state.speedOverride / state.operatorSpeed), Ratio(state.feedOverride / state.operatorFeed),
                  state.link.overrides);
  }
  state.link.commanded = effect_.newest();
  state.link.effect = effect_.typical();
}

void LinkRunner::finish() noexcept {
  if (finished_) return;
  finished_ = true;
  if (lease_.inForce()) link_.release(lastTick_);
  link_.close();
}

}  // namespace stillcut::pipeline
