// The demo's cut in five seconds: entry at 0.6 s, a stable first stage, from 1.6 s too deep for the programmed speed,
// out of the material at 4.7 s. Same physics, sensors, drives and noise as resources/scenarios/demo.toml.
#pragma once

#include <stdexcept>

#include "core/milling/simulation/scenario.h"

namespace stillcut::test {

inline constexpr double kDemoDeepAt = 2.2;  // [s] the full depth is reached
inline constexpr double kDemoExit = 4.7;    // [s]

inline milling::Scenario demoCut(double seconds = 5.0) {
  auto loaded = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml");
  if (!loaded) throw std::runtime_error(loaded.error().line());
  milling::Scenario cut = std::move(loaded).value();
  cut.programme.depth.segments = {{0.0, 1.6, 0.7e-3, 0.7e-3, milling::RampShape::Linear},
                                  {1.6, kDemoDeepAt, 0.7e-3, 1.5e-3, milling::RampShape::Smoothstep}};
  cut.programme.exit->at = seconds - (5.0 - kDemoExit);
  cut.programme.duration = Seconds(seconds);
  if (const Status sound = milling::check(cut, "short demo"); !sound) throw std::runtime_error(sound.error().line());
  return cut;
}

}  // namespace stillcut::test
