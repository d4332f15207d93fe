// The wires this build can make: TCP always, serial ports and Modbus where Qt is. Thread: set-up.
#pragma once

#include <memory>

#include "core/cnc/byte_channel.h"
#include "core/cnc/modbus/register_bus.h"

namespace stillcut::app {

Result<std::unique_ptr<cnc::ByteChannel>> makeWire(const cnc::WireAddress& address);
// Null in a build without Qt.
cnc::BusMaker busMaker();
// What serial and Modbus wires need in a program that has no Qt application; keep it until they are gone. Nothing when
// there is one, or in a build without Qt.
std::shared_ptr<void> wireEvents();

}  // namespace stillcut::app
