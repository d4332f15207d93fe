// ModbusLink: a spindle drive or PLC gateway behind Modbus TCP or RTU, by a register map. Our factors have registers of
// their own; the machine multiplies with the operator's knob, or has none.
// One request at a time: what is to be written first, then whatever register is due longest, with its neighbours
// (read_plan.h). While we are in command
// the heartbeat counts; a machine whose map says `watchdog` restores 100 % when it stops. Registers that the map leaves
// out: overrides in force are taken as written, "running" as a programmed speed above 0, "at speed" from the speeds.
// Another master's heartbeat, where it is read back, has the overrides: nothing of ours is taken beside it.
// A value that can not be (outside of the map's range or of its kind's; a spindle twice as fast as it was ever told to
// turn) is not believed, and one that jumps only when two readings on end show it.
// Thread: as CncLink says; a tick waits at most kWait a request and kRequests requests; all of letting go takes at most
// kReleaseTime.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>

#include "core/cnc/cnc_link.h"
#include "core/cnc/delay_gauge.h"
#include "core/cnc/modbus/believed_reading.h"
#include "core/cnc/modbus/heartbeat_watch.h"
#include "core/cnc/modbus/read_plan.h"
#include "core/cnc/modbus/register_bus.h"
#include "core/cnc/modbus/register_map.h"
#include "core/cnc/release_budget.h"

namespace stillcut::cnc {

class ModbusLink final : public CncLink {
 public:
  // `clock` bounds what open() and release() wait.
  ModbusLink(RegisterMap map, std::unique_ptr<RegisterBus> bus, const Clock& clock);
  ~ModbusLink() override;

  LinkInfo describe() const override;
  Status open() override;
  MachineState read(Instant now) noexcept override;
  void apply(const OverrideCommand& command, Instant now) noexcept override;
  void release(Instant now) noexcept override;
  void adopt(std::optional<Ratio> speed, std::optional<Ratio> feed) noexcept override {
    touched_ = touched_ || speed || feed;
  }
  void close() noexcept override;

  static constexpr Duration kWait = std::chrono::milliseconds(2);
  static constexpr int kRequests = 4;
  static constexpr Duration kReleaseTime = std::chrono::milliseconds(1000);

 private:
  struct RegisterReading : BelievedReading {
    Instant due{};
  };
  struct RegisterWrite {
    double wanted = 0.0;            // in the map's unit
    std::optional<double> written;  // acknowledged last
    bool sure = false;              // nothing was sent since: a write may act and its reply be lost
    Instant when{};
    Instant notBefore{};  // refused: the others go first
  };
  enum class Underway : std::uint8_t { Nothing, Read, Write };

  void pump(Instant now) noexcept;
  void takeReply(Instant now) noexcept;
  void takeReading(const BusReply& reply, Instant now) noexcept;
  void takeValue(MachineSignal s, const RegisterWords& words, Instant now) noexcept;
  bool beat(Instant now) noexcept;
  bool writeNext(Instant now) noexcept;
  bool readNext(Instant now) noexcept;
  bool write(MachineCommand which, Instant now) noexcept;
  void broke(Instant now) noexcept;
  bool atBase() const noexcept;
  bool stands(MachineCommand which, double value) const noexcept;
  MachineState state(Instant now) const noexcept;
  // When the oldest of these was read; 0: none is in the map, or not all have been.
  Instant readAt(std::initializer_list<MachineSignal> of) const noexcept;
  double number(MachineSignal s, double otherwise) const noexcept;
  bool flag(MachineSignal s, bool otherwise) const noexcept { return number(s, otherwise ? 1.0 : 0.0) != 0.0; }
  const RegisterReading& seen(MachineSignal s) const { return seen_[static_cast<std::size_t>(s)]; }
  RegisterWrite& order(MachineCommand o) { return orders_[static_cast<std::size_t>(o)]; }
  const RegisterWrite& order(MachineCommand o) const { return orders_[static_cast<std::size_t>(o)]; }

  bool isSlow() const noexcept;
  bool anotherMaster(Instant now) const noexcept;

  RegisterMap map_;
  ReadPlan plan_;
  std::unique_ptr<RegisterBus> bus_;
  const Clock& clock_;
  std::array<RegisterReading, kMachineSignals> seen_{};
  std::array<RegisterWrite, kMachineCommands> orders_{};
  HeartbeatWatch heartbeats_;
  Underway underway_ = Underway::Nothing;
  std::size_t which_ = 0;
  double writing_ = 0.0;
  bool inCommand_ = false;
  bool beatLast_ = false;   // the last that was written was the heartbeat
  bool wroteLast_ = false;  // the last question was no reading
  bool touched_ = false;    // something of ours may stand in the machine
  int failures_ = 0;        // in a row
  Instant nextTry_{}, acknowledged_{};
  ReleaseBudget releaseBudget_;
  Instant askedAt_{};  // by the clock, for the round trip
  DelayGauge roundTrip_;
  double fastest_ = 0.0;  // the highest programmed speed that was believed, rev/min
  struct Refused {
    MachineSignal which{};
    double value = 0.0;
  };
  std::optional<Refused> refused_;  // read last, and can not be
};

}  // namespace stillcut::cnc
