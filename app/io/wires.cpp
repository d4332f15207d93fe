#include "app/io/wires.h"

#include "app/io/tcp_wire.h"
#ifdef STILLCUT_SERIAL
#include "app/io/serial_wire.h"
#endif

namespace stillcut::app {

Result<std::unique_ptr<cnc::ByteChannel>> makeWire(const cnc::WireAddress& address) {
  if (!address.host.empty()) return TcpWire::make(address.host, address.port);
#ifdef STILLCUT_SERIAL
  return std::unique_ptr<cnc::ByteChannel>(std::make_unique<SerialWire>(address.device, address.baud));
#else
  return Error{address.device, "serial ports are not part of this build", "configure with STILLCUT_DESKTOP=ON"};
#endif
}

}  // namespace stillcut::app
