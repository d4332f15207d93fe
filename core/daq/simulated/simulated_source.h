// SimulatedSource: samples of a simulated cut. Owns the plant and advances it; a simulated machine may share it through
// the port.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/daq/daq_source.h"
#include "core/milling/simulation/plant_port.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::daq {

struct SimulatedPace {
  // Paced: the cut begins with the first read(), which returns when the block's last sample is due on the steady clock.
  // Stream time is then the steady clock's, as for a live device. Otherwise as fast as possible, stream time from 0.
  bool realTime = false;
  double multiplier = 1.0;  // seconds of cut per second, paced only
};

class SimulatedSource final : public DaqSource {
 public:
  // `scenario` has passed check(). Seed 0: the scenario's own. `port` may be null (nobody turns the overrides).
  SimulatedSource(const milling::Scenario& scenario, std::uint64_t seed, std::shared_ptr<milling::PlantPort> port,
                  SimulatedPace pace = {});

  Result<SourceFormat> open() override;
  bool read(SampleBlock& block) noexcept override;
  void stop() noexcept override { stopped_.store(true, std::memory_order_relaxed); }
  Message fault() const override { return {}; }

  // The plant and its truth: driver thread, or any thread once reading has ended.
  const milling::SimulatedCut& plant() const { return plant_; }
  milling::SimulatedCut& plant() { return plant_; }

 private:
  void begin() noexcept;
  void waitFor(const SampleBlock& block) noexcept;

  milling::SimulatedCut plant_;
  std::shared_ptr<milling::PlantPort> port_;
  SimulatedPace pace_;
  bool started_ = false;  // paced only
  Instant start_{};
  std::atomic<bool> stopped_{false};
};

}  // namespace stillcut::daq
