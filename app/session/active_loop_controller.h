// ActiveDesk: the active work-holder behind the interface that its page knows. The device is opened when the paths are
// first identified; the models are fitted on a thread of their own. Thread: GUI.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "app/session/background_task.h"
#include "core/active/active_engine.h"
#include "core/active/simulated_duplex.h"
#include "core/config/param_set.h"
#include "ui/facade/active_controller.h"

namespace stillcut::app {

class ActiveLoopController final : public ui::ActiveController {
 public:
  // `simulated`: the same device where it is a simulated one: it identifies in air and cuts from the start on.
  ActiveLoopController(std::unique_ptr<active::DuplexDevice> device, const active::ActiveEngineOptions& options,
                       const Clock& clock, active::SimulatedDuplex* simulated = nullptr);

  bool poll() override;
  const ActiveSnapshot* pull() override { return engine_.pull(); }
  const PathFit* fit(int axis) const override;
  QString device() const override { return device_; }
  QString problem() const override { return problem_; }
  Status identify() override;
  Status start() override;
  void stop() override { engine_.stop(); }
  Status setStep(double share) override { return engine_.setStep(share); }
  Status setLeak(double leak) override { return engine_.setLeak(leak); }
  // A parameter was changed on the Tune page; those that do not act while the loop runs are left alone.
  void tune(std::string_view key, double value);

 private:
  void take(const Result<active::PathPairFound>& found);

  active::ActiveEngine engine_;
  active::SimulatedDuplex* simulated_;
  QString device_, problem_;
  bool awaited_ = false;  // a record is being made
  std::optional<std::array<PathFit, kActiveAxes>> fits_;
  BackgroundTask fitting_;  // last: it works on the engine
};

// What the loops of the desktop are timed by.
const Clock& activeClock();
// On a cut of its own of this scenario, paced by the clock; the scenario has passed SimulatedDuplex::check().
std::unique_ptr<ActiveLoopController> makeSimulatedActiveLoopController(const milling::Scenario& scenario,
                                                                        const config::ParamSet& params);

}  // namespace stillcut::app
