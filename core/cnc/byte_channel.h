// The wire below a link's protocol. Thread: as core/base/byte_channel.h says.
#pragma once

#include "core/base/byte_channel.h"

namespace stillcut::cnc {

using stillcut::ByteChannel;
using stillcut::WireAddress;
using stillcut::WireMaker;
using stillcut::WireState;

}  // namespace stillcut::cnc
