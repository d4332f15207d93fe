// IioDriver: a PcmDriver on libiio, for sensors of the Linux industrial I/O system, here or on another computer (iiod).
// Every buffered input but the timestamp is a channel, in the order of the device; a channel of several values is as
// many. Of 64 bits the upper 32 are kept. The library loses samples without a word: the device's own timestamps show
// that, and where it has none, the source above finds it by time. Null in a build without
// libiio.
// Thread: as PcmDriver says. A read waits half a second at most.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/daq/pcm_driver.h"

namespace stillcut::app {

// uri: "local:", "ip:HOST", "usb:". trigger: name of one; empty: the device needs none.
std::unique_ptr<daq::PcmDriver> makeIioDriver(const std::string& uri, const std::string& trigger);
// What can stream there, with channels and rates; an error where nothing answers.
Result<std::vector<daq::PcmDevice>> iioDevices(const std::string& uri);
// Where libiio finds others than the local ones: on USB, and those that announce themselves on the network.
std::vector<std::string> iioContexts();

}  // namespace stillcut::app
