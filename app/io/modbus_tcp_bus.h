// ModbusTcpBus: a RegisterBus over Qt SerialBus. Its answers name the question by a number, so that none is taken for
// another's; RTU has no such number and goes its own way (core/cnc/modbus/rtu_bus.h). The client object is made by
// connect() and destroyed by close(), so that it lives on the thread that uses it; its events are turned by state(),
// take() and wait(), because the link thread has no event loop of its own. connectDevice() returns true before TCP is
// up: only ConnectedState counts.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/cnc/modbus/register_bus.h"

class QModbusReply;
class QModbusTcpClient;

namespace stillcut::app {

class ModbusTcpBus final : public cnc::RegisterBus {
 public:
  explicit ModbusTcpBus(cnc::BusAddress address);
  ~ModbusTcpBus() override;

  std::string_view address() const noexcept override { return name_; }
  void connect() noexcept override;
  cnc::WireState state() noexcept override;
  bool read(cnc::RegisterTable table, int first, int count) noexcept override;
  bool write(cnc::RegisterTable table, int first, int count, const cnc::RegisterWords& words) noexcept override;
  bool busy() const noexcept override { return reply_ != nullptr; }
  std::optional<cnc::BusReply> take() noexcept override;
  void wait(Duration atMost) noexcept override;
  void close() noexcept override;

 private:
  bool finished() const noexcept;
  void turnEvents(int milliseconds) const noexcept;

  cnc::BusAddress address_;
  std::string name_;
  std::unique_ptr<QModbusTcpClient> client_;
  std::unique_ptr<QModbusReply> reply_;
};

}  // namespace stillcut::app
