#include "app/io/wires.h"

#include "app/io/tcp_wire.h"
#ifdef STILLCUT_SERIAL
#include <QCoreApplication>
#include <utility>

#include "app/io/modbus_tcp_bus.h"
#include "app/io/serial_wire.h"
#include "core/cnc/modbus/rtu_bus.h"
#endif

namespace stillcut::app {

Result<std::unique_ptr<cnc::ByteChannel>> makeWire(const cnc::WireAddress& address) {
  if (!address.host.empty()) return TcpWire::make(address.host, address.port);
#ifdef STILLCUT_SERIAL
  return std::unique_ptr<cnc::ByteChannel>(std::make_unique<SerialWire>(address.device, address.baud));
#else
  return Error{address.device, message("serial ports are not part of this build"),
               message("configure with STILLCUT_DESKTOP=ON")};
#endif
}

cnc::BusMaker busMaker() {
#ifdef STILLCUT_SERIAL
  return [](const cnc::BusAddress& address, const Clock& clock) -> Result<std::unique_ptr<cnc::RegisterBus>> {
    if (!address.wire.host.empty()) return std::unique_ptr<cnc::RegisterBus>(std::make_unique<ModbusTcpBus>(address));
    auto wire = std::make_unique<SerialWire>(address.wire.device, address.wire.baud, address.parity, address.stopBits);
    return std::unique_ptr<cnc::RegisterBus>(std::make_unique<cnc::RtuBus>(address, std::move(wire), clock));
  };
#else
  return {};
#endif
}

std::shared_ptr<void> wireEvents() {
#ifdef STILLCUT_SERIAL
  if (QCoreApplication::instance() == nullptr) {
    static int argc = 1;
    static char name[] = "stillcut-cli";
    static char* argv[] = {name, nullptr};
    return std::make_shared<QCoreApplication>(argc, argv);
  }
#endif
  return nullptr;
}

}  // namespace stillcut::app
