// PcmDuplex: an audio-class interface as the device of the active work-holder: two inputs measure the table, two of
// its outputs drive the piezo amplifier. Whole numbers of 32 bits; what full scale is in SI of the sensor and in metres
// of stroke comes from the profile. PcmDuplexDriver is the library boundary: what is above it is tested with drivers
// that fall behind, fall silent and disappear; what is below it are the calls of one library.
// Thread: as DuplexDevice says; read(), write() and restart() of the driver on the loop's thread, real-time; close()
// there too once nothing comes any more, so that what is queued is not played.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/active/duplex_device.h"

namespace stillcut::active {

struct PcmDuplexRequest {
  std::string device = "hw:0";
  Hertz rate{48000.0};
  int frames = 32;              // of a period, about
  int inputs = 2, outputs = 2;  // channels, at the least
};

struct PcmDuplexFormat {
  int frames = 32;
  int inputs = 2, outputs = 2;  // interleaved
  bool together = true;         // both start at one instant, each time
};

// What read() and write() say below 0; 0: done.
enum PcmDuplexFault : int { kDuplexLost = -1, kDuplexGone = -2 };

class PcmDuplexDriver {
 public:
  virtual ~PcmDuplexDriver() = default;
  // Exactly this rate, without resampling, inputs and outputs on one clock and started together, with silence queued;
  // or one line that says what the device could do instead.
  virtual Result<PcmDuplexFormat> open(const PcmDuplexRequest& request) = 0;
  // One whole period. kDuplexGone when none came within half a second.
  virtual int read(std::int32_t* into) noexcept = 0;
  virtual int write(const std::int32_t* from) noexcept = 0;  // a whole period; kDuplexLost: came too late
  // After a loss: streams again, with silence queued. False: it does not.
  virtual bool restart() noexcept = 0;
  virtual void close() noexcept = 0;  // drops what is queued; open() may follow
};

struct PcmDuplexSettings {
  PcmDuplexRequest request;
  std::array<int, 2> input{0, 1}, output{0, 1};  // channel of x and of y, from 0
  std::array<double, 2> sensor{1.0, 1.0};        // SI of the sensor at full scale
  std::array<double, 2> stroke{1e-6, 1e-6};      // metres at full scale
};

class PcmDuplex final : public DuplexDevice {
 public:
  PcmDuplex(PcmDuplexSettings settings, std::unique_ptr<PcmDuplexDriver> driver);

  std::string name() const override { return settings_.request.device; }
  Result<DuplexFormat> open() override;
  DuplexEvent read(std::span<double> in) STILLCUT_RT override;
  DuplexEvent write(std::span<const safety::ActuatorCommand> out) STILLCUT_RT override;
  void stop() noexcept override { stopped_.store(true, std::memory_order_relaxed); }
  void close() noexcept override { driver_->close(); }

 private:
  DuplexEvent after(int fault) STILLCUT_RT;

  PcmDuplexSettings settings_;
  std::unique_ptr<PcmDuplexDriver> driver_;
  PcmDuplexFormat format_;
  std::vector<std::int32_t> in_, out_;
  std::atomic<bool> stopped_{false};
};

}  // namespace stillcut::active
