// SimulatedMachine: the control of the simulated mill. Commands go through a PlantPort to the plant that the simulated
// source advances; they act after the scenario's override delay, on a spindle with inertia.
// For tests it also plays the operator and the accidents: knobs, M49, a reset of the overrides, a link that is lost,
// another client.
#pragma once

#include <memory>

#include "core/cnc/cnc_link.h"
#include "core/milling/simulation/plant_port.h"
#include "core/milling/simulation/scenario.h"

namespace stillcut::cnc {

class SimulatedMachine final : public CncLink {
 public:
  SimulatedMachine(const milling::Scenario& scenario, std::shared_ptr<milling::PlantPort> port);

  LinkInfo describe() const override;
  Status open() override;
  MachineState read(Instant now) noexcept override;
  void apply(const OverrideCommand& command, Instant now) noexcept override;
  void release(Instant now) noexcept override;

  // Link thread, at once. Ratios are those of the operator's own knobs.
  void turnKnobs(Ratio speed, Ratio feed) noexcept;
  void enableOverrides(bool enabled) noexcept;  // false: M49
  // A script of the machine puts its overrides back to 100 %; as a shared knob would, they stay there until the
  // overrides are taken anew.
  void resetOverrides() noexcept;
  // Down: reads are invalid and commands are lost; the machine's watchdog restores 100 %.
  void loseLink(bool lost) noexcept;
  void giveControlAway(bool away) noexcept { controlOurs_ = !away; }

 private:
  void post(Ratio speed, Ratio feed, Instant when) noexcept;

  milling::OverrideSettings ranges_;
  Seconds block_;
  std::shared_ptr<milling::PlantPort> port_;
  milling::PlantCommand order_;
  Instant lastTime_{};
  std::uint64_t engagement_ = 0, resetEngagement_ = 0;
  bool linkUp_ = true, controlOurs_ = true;
};

}  // namespace stillcut::cnc
