#include "app/session/active_loop_controller.h"

#include <algorithm>
#include <utility>

#include "app/compose/active_setup.h"
#include "ui/base/say.h"

namespace stillcut::app {

ActiveLoopController::ActiveLoopController(std::unique_ptr<active::DuplexDevice> device,
                                           const active::ActiveEngineOptions& options, const Clock& clock,
                                           active::SimulatedDuplex* simulated)
    : engine_(std::move(device), options, clock),
      simulated_(simulated),
      device_(QString::fromStdString(engine_.device().name())) {}

Status ActiveLoopController::identify() {
  if (fitting_.state().running)
    return Error{message("active work-holder"), message("the last record is still being worked on")};
  if (!engine_.isOpen()) {
    fits_.reset();
    if (Status opened = engine_.open(); !opened) return opened;
  }
  if (Status begun = engine_.identify(); !begun) return begun;
  fits_.reset();
  if (simulated_ != nullptr) simulated_->cut(false);  // not before: a cut that is held goes on
  problem_.clear();
  awaited_ = true;
  return Done{};
}

Status ActiveLoopController::start() {
  Status begun = engine_.start();
  if (!begun) return begun;
  problem_.clear();
  if (simulated_ != nullptr) simulated_->cut(true);  // the tool enters under control; chatter that is grown is not held
  return begun;
}

bool ActiveLoopController::poll() {
  engine_.renew();
  bool changed = fitting_.collect();
  if (awaited_ && engine_.recorded()) {
    awaited_ = false;
    fitting_.start(ui::TaskState::What::None, {}, [this](BackgroundTask::Progress&) -> Result<BackgroundTask::Apply> {
      return BackgroundTask::Apply([this, found = engine_.fit()] { take(found); });
    });
  }
  if (fits_ && !engine_.isOpen()) {  // unplugged
    fits_.reset();
    problem_ = QCoreApplication::translate("Session", "The device is gone; identify again when it is back");
    changed = true;
  }
  return changed;
}

void ActiveLoopController::take(const Result<active::PathPairFound>& found) {
  Status taken{Done{}};
  if (!found) {
    taken = found.error();
  } else {
    taken = engine_.install(*found);
  }
  if (!taken) {
    problem_ = ui::sayError(taken.error());
    return;
  }
  fits_.emplace();
  for (std::size_t a = 0; a < kActiveAxes; ++a) (*fits_)[a] = active::fitOf((*found)[a], engine_.paths()[a]);
}

const Clock& activeClock() {
  static const SteadyClock kClock;
  return kClock;
}

void ActiveLoopController::tune(std::string_view key, double value) {
  if (key == "active.step") (void)setStep(value);
  if (key == "active.leak") (void)setLeak(value);
}

std::unique_ptr<ActiveLoopController> makeSimulatedActiveLoopController(const milling::Scenario& scenario,
                                                                        const config::ParamSet& params) {
  constexpr int kFrames = 1;          // as the paper's loop
  constexpr Seconds kLongCut{600.0};  // it goes on as it ends: begun anew, it would meet a table at rest elsewhere
  milling::Scenario longer = scenario;
  longer.programme.duration = std::max(scenario.programme.duration, kLongCut);
  auto device = std::make_unique<active::SimulatedDuplex>(longer, kFrames, scenario.seed, &activeClock());
  active::SimulatedDuplex* simulated = device.get();
  const active::ActiveEngineOptions options = activeOptions(*scenario.workHolder, params);
  return std::make_unique<ActiveLoopController>(std::move(device), options, activeClock(), simulated);
}

const PathFit* ActiveLoopController::fit(int axis) const {
  return fits_ && axis >= 0 && axis < kActiveAxes ? &(*fits_)[static_cast<std::size_t>(axis)] : nullptr;
}

}  // namespace stillcut::app
