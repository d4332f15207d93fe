// The wires this build can make: TCP always, serial ports where Qt is. Thread: set-up.
#pragma once

#include "core/cnc/byte_channel.h"

namespace stillcut::app {

Result<std::unique_ptr<cnc::ByteChannel>> makeWire(const cnc::WireAddress& address);

}  // namespace stillcut::app
