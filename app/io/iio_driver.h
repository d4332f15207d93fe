// IioDriver: a PcmDriver on libiio, for sensors of the Linux industrial I/O system, here or on another computer (iiod).
// Every buffered input but the timestamp is a channel, in the order of the device. The library loses samples without a
// word; the source above finds that by time. Null in a build without libiio.
// Thread: as PcmDriver says. A read waits half a second at most.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/daq/pcm_driver.h"

namespace stillcut::app {

// uri: "local:", "ip:HOST", "usb:". trigger: name of one; empty: the device needs none.
std::unique_ptr<daq::PcmDriver> makeIioDriver(const std::string& uri, const std::string& trigger);
// What can stream there, with channels and rates; empty where nothing answers.
std::vector<daq::PcmDevice> iioDevices(const std::string& uri);

}  // namespace stillcut::app
