#include "core/active/simulated_duplex.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace stillcut::active {

namespace {

constexpr std::array<const char*, 2> kAxes{"x", "y"};
constexpr auto kNap = std::chrono::milliseconds(20);

auto earOf(const milling::Scenario& scenario, const char* axis) {
  return std::ranges::find_if(scenario.sensors, [&](const milling::SensorSettings& s) {
    return s.quantity == SensorQuantity::Acceleration && s.axis == axis;
  });
}

}  // namespace

Status SimulatedDuplex::check(const milling::Scenario& scenario) {
  if (!scenario.workHolder) {
    return Error{scenario.name, message("has no active work-holder"),
                 message("strategy 'active' needs a table [work_holder]")};
  }
  for (const char* axis : kAxes) {
    if (earOf(scenario, axis) == scenario.sensors.end()) {
      return Error{scenario.name, message("no accelerometer along %1", axis),
                   message("the active table needs one per axis")};
    }
  }
  return Done{};
}

SimulatedDuplex::SimulatedDuplex(const milling::Scenario& scenario, int frames, std::uint64_t seed, const Clock* clock)
    : scenario_(scenario), air_(scenario), frames_(frames), seed_(seed), clock_(clock) {
  air_.programme.depth = {};
  for (std::size_t a = 0; a < ears_.size(); ++a) {
    const auto ear = earOf(scenario, kAxes[a]);
    ears_[a] = {static_cast<int>(ear - scenario.sensors.begin()), 1.0 / ear->gain};
  }
}

// The plant is made anew: as simulated time stands still meanwhile, this may ask for memory.
void SimulatedDuplex::change(bool cutting) {
  cutting_ = cutting;
  plant_ = std::make_unique<milling::SimulatedCut>(cutting ? scenario_ : air_, seed_);
}

Result<DuplexFormat> SimulatedDuplex::open() {
  change(cutWanted_.load(std::memory_order_relaxed));
  frame_.allocate(static_cast<int>(scenario_.sensors.size()), 1);
  playing_.assign(2 * static_cast<std::size_t>(frames_), 0.0);
  stopped_.store(false, std::memory_order_relaxed);
  if (clock_ != nullptr) next_ = clock_->now();
  return DuplexFormat{scenario_.rate, frames_};
}

bool SimulatedDuplex::wait() noexcept {
  if (clock_ == nullptr) return !stopped_.load(std::memory_order_relaxed);
  next_ += toDuration(Seconds(frames_ / scenario_.rate.value));
  // A machine that stood still for a while does not hurry after it.
  next_ = std::max(next_, clock_->now() - std::chrono::milliseconds(200));
  while (!stopped_.load(std::memory_order_relaxed)) {
    const Duration left = next_ - clock_->now();
    if (left <= Duration::zero()) return true;
    std::this_thread::sleep_for(std::min<Duration>(left, kNap));
  }
  return false;
}

DuplexEvent SimulatedDuplex::read(std::span<double> in) STILLCUT_RT {
  if (!wait()) return DuplexEvent::Gone;
  const bool wanted = cutWanted_.load(std::memory_order_relaxed);
  if (wanted != cutting_) change(wanted);
  const auto frames = static_cast<std::size_t>(frames_);
  for (std::size_t f = 0; f < frames; ++f) {
    plant_->setWorkHolder(playing_[f], playing_[frames + f]);
    if (!plant_->fill(frame_)) {
      change(cutting_);
      (void)plant_->fill(frame_);
    }
    if (observe && cutting_) observe(frame_, *plant_);
    for (std::size_t a = 0; a < ears_.size(); ++a) {
      in[a * frames + f] = ears_[a].scale * frame_.channel(ears_[a].channel)[0];
    }
  }
  std::ranges::fill(playing_, 0.0);  // nothing written in time is silence
  return DuplexEvent::Block;
}

DuplexEvent SimulatedDuplex::write(std::span<const safety::ActuatorCommand> out) STILLCUT_RT {
  std::ranges::transform(out, playing_.begin(), &safety::ActuatorCommand::value);
  return DuplexEvent::Block;
}

}  // namespace stillcut::active
