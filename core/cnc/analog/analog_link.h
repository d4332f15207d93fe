// AnalogLink: a machine whose overrides are voltages (a hand terminal's potentiometers, an external speed command).
// Nothing comes back on these wires: the programmed speed and feed are what the profile says, the overrides in force
// are what was written, and no measured speed is claimed. The outputs keep their last voltage when we die: describe()
// says that there is no watchdog. From open() to close() both outputs hold a voltage; both ends are the programmed one.
// Sources: Xu 2003 (1.3-4.8 V for 0-150 % feed; 1-10 V for 50-500 or 500-5000 rev/min by gear), van Dijk 2010 (hand
// terminal, 50-120 % speed and 0-100 % feed).
// Thread: as CncLink says; a write to the output takes microseconds.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/cnc/analog/analog_map.h"
#include "core/cnc/cnc_link.h"

namespace stillcut::cnc {

// The driver call, and nothing else. Thread: link thread, after open().
class AnalogOutput {
 public:
  virtual ~AnalogOutput() = default;
  // One line on failure: the file, and what is missing.
  virtual Status open(const AnalogDevice& device) = 0;
  // False: the device is gone or refuses the channel.
  virtual bool write(int channel, double volts) noexcept = 0;
};

class AnalogLink final : public CncLink {
 public:
  AnalogLink(AnalogMap map, std::unique_ptr<AnalogOutput> output, Rpm programmedSpeed, MetresPerSecond programmedFeed);
  ~AnalogLink() override;

  LinkInfo describe() const override;
  Status open() override;
  MachineState read(Instant now) noexcept override;
  void apply(const OverrideCommand& command, Instant now) noexcept override;
  void release(Instant now) noexcept override;

 private:
  bool writeBoth(double speed, double feed) noexcept;
  static bool writeOne(AnalogOutput& output, const std::optional<AnalogChannel>& to, double value) noexcept;

  AnalogMap map_;
  std::unique_ptr<AnalogOutput> output_;
  Rpm programmedSpeed_;
  MetresPerSecond programmedFeed_;
  Ratio speed_{1.0}, feed_{1.0};  // last written
  Instant taken_{};               // the card took them
  bool opened_ = false, working_ = false;
};

}  // namespace stillcut::cnc
