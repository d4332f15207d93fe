// An active work-holder whose story a test writes by hand.
#pragma once

#include <optional>

#include "ui/facade/active_controller.h"

namespace stillcut::ui {

class FakeActiveDesk final : public ActiveController {
 public:
  bool poll() override { return true; }
  const ActiveSnapshot* pull() override { return snapshot ? &*snapshot : nullptr; }
  const PathFit* fit(int axis) const override {
    return fits[static_cast<std::size_t>(axis)] ? &*fits[static_cast<std::size_t>(axis)] : nullptr;
  }
  QString device() const override { return QStringLiteral("simulated work-holder"); }
  QString problem() const override { return said; }
  Status identify() override {
    ++identifications;
    return Done{};
  }
  Status start() override {
    if (!fits[0]) return Error{message("start"), message("no model of the path"), message("identify it first")};
    ++starts;
    return Done{};
  }
  void stop() override { ++stops; }
  Status setStep(double) override { return Done{}; }
  Status setLeak(double) override { return Done{}; }

  std::optional<ActiveSnapshot> snapshot;
  std::array<std::optional<PathFit>, kActiveAxes> fits;
  QString said;
  int identifications = 0, starts = 0, stops = 0;
};

// Ford's path as it might be measured: one mode at 1 kHz, the model a little late, coherence low at the end.
inline PathFit exampleFit() {
  PathFit fit;
  for (int k = 1; k <= 200; ++k) {
    const double f = 12.5 * k, r = f / 1000.0;
    const std::complex<double> mode = 1e6 * r * r / std::complex<double>(1.0 - r * r, 0.04 * r);
    fit.frequency.push_back(f);
    fit.measured.push_back(mode * (1.0 + 0.02 * std::sin(0.9 * k)));
    fit.modelled.push_back(mode * std::polar(1.0, -0.2 * r));
    fit.coherence.push_back(f < 2200.0 ? 0.98 - 0.02 * std::cos(0.7 * k) : 0.5);
  }
  fit.path = {true, instantFromNs(2'000'000'000), Seconds(0.4e-3), 0.031, 1.22, Seconds(0.19e-3), Hertz(1024.0), true};
  return fit;
}

inline ActiveSnapshot exampleActive() {
  ActiveSnapshot s;
  s.number = 1;
  s.time = instantFromNs(64'000'000'000);
  s.open = true;
  s.rate = Hertz(48000.0);
  s.blockFrames = 32;
  s.worstBlock = Seconds(42e-6);
  s.axes[0].state = ActuatorState::On;
  s.axes[0].strokePeak = 0.42;
  s.axes[0].lineCount = 3;
  s.axes[0].lines[0] = {Hertz(339.0), 23.4, true};
  s.axes[0].lines[1] = {Hertz(1024.0), 24.9, true};
  s.axes[0].lines[2] = {Hertz(100.0), 0.0, false};
  s.axes[1].state = ActuatorState::Off;
  s.axes[1].release = ActuatorRelease::Diverging;
  s.axes[1].limitedFraction = 0.2;
  s.axes[1].strokePeak = 1.0;
  s.paths[0] = exampleFit().path;
  return s;
}

}  // namespace stillcut::ui
