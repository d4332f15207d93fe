// SimulatedDuplex: the work-holder of a simulated cut as a block device. A block of one frame is the loop as it was in
// the paper: what is written acts until the next reading; with N frames it acts N - 1 readings later. Paced by the
// clock, or as fast as it is read. Begins in air; the cut begins when it is asked for, from its beginning, and again
// when it is over. Thread: as DuplexDevice says; cut() on any.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

#include "core/active/duplex_device.h"
#include "core/base/time.h"
#include "core/milling/simulation/simulated_cut.h"

namespace stillcut::active {

class SimulatedDuplex final : public DuplexDevice {
 public:
  // `scenario` has a work-holder and an accelerometer on each axis: see check(). Without a clock: not paced.
  SimulatedDuplex(const milling::Scenario& scenario, int frames, std::uint64_t seed = 0, const Clock* clock = nullptr);
  static Status check(const milling::Scenario& scenario);

  std::string name() const override { return "simulated: " + scenario_.name; }
  Result<DuplexFormat> open() override;
  DuplexEvent read(std::span<double> in) STILLCUT_RT override;
  DuplexEvent write(std::span<const safety::ActuatorCommand> out) STILLCUT_RT override;
  void stop() noexcept override { stopped_.store(true, std::memory_order_relaxed); }
  void close() noexcept override {}

  void cut(bool on) noexcept { cutWanted_.store(on, std::memory_order_relaxed); }
  const milling::SimulatedCut& plant() const { return *plant_; }
  // Every frame of a cut, in device units; before open().
  std::function<void(const SampleBlock&, const milling::SimulatedCut&)> observe;

 private:
  void change(bool cutting);
  bool wait() noexcept;

  milling::Scenario scenario_, air_;
  int frames_;
  std::uint64_t seed_;
  const Clock* clock_;
  struct ErrorSensor {
    int channel = 0;
    double scale = 1.0;  // SI per device unit
  };
  std::array<ErrorSensor, 2> ears_;
  std::unique_ptr<milling::SimulatedCut> plant_;
  SampleBlock frame_;
  std::vector<double> playing_;
  bool cutting_ = false;
  Instant next_{};  // when the next block is whole
  std::atomic<bool> cutWanted_{false}, stopped_{false};
};

}  // namespace stillcut::active
