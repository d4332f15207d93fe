// HammerSource: the channels of a simulated tap test: hammer, and accelerometers along x and y at the tip. A blow every
// `interval`, some of them as they should not be. Thread: as every DaqSource.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/daq/daq_source.h"
#include "core/milling/simulation/simulated_tap.h"

namespace stillcut::daq {

struct HammerSourceOptions {
  bool alongY = false;
  Seconds interval{1.2};  // between blows
  double pace = 1.0;      // times real time; 0: as fast as it is read
  bool faults = true;     // of eight blows the second bounces, the fourth is an overload, the sixth hardly a touch
  std::uint64_t seed = 1;
};

class HammerSource final : public DaqSource {
 public:
  explicit HammerSource(const HammerSourceOptions& options,
                        milling::TapStructure structure = milling::usualTapStructure());

  Result<SourceFormat> open() override;
  bool read(SampleBlock& block) noexcept override;
  void stop() noexcept override { stopped_.store(true, std::memory_order_relaxed); }
  Message fault() const override { return {}; }

 private:
  void strike() noexcept;
  void waitFor(const SampleBlock& block) const noexcept;

  HammerSourceOptions options_;
  milling::SimulatedTap tap_;
  milling::NoiseSource hand_;  // no two blows are alike
  std::uint64_t frame_ = 0, nextBlow_ = 0, sequence_ = 0;
  int blows_ = 0;
  Instant start_{};
  std::atomic<bool> stopped_{false};
};

}  // namespace stillcut::daq
