// Finds what a machine may be reached by: the serial ports of this computer, and the servers of LinuxCNC and Modbus on
// hosts that were named. It asks nobody else, sends nothing, and lets go at once.
// Thread: one that may wait: `atMost` for every 32 hosts, besides the names' look-up.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/config/profile.h"

namespace stillcut::app {

struct SerialPort {
  std::string device;  // by the name that lasts, "/dev/serial/by-id/...", where there is one; else "/dev/ttyACM0"
  std::string label;   // maker and product of its USB device; empty: not given
};
// The name by which a port is found again wherever it is plugged in and whatever else is; where it has none, `device`.
std::string lastingName(const std::string& device, const std::string& devices = "/dev");
// USB serial ports, by name. The folders are the kernel's; tests have their own.
std::vector<SerialPort> serialPorts(const std::string& devices = "/dev", const std::string& classes = "/sys/class/tty");

struct FoundMachine {
  std::string where;             // "/dev/ttyUSB0 (maker and product)", "localhost:5007"
  std::string what;              // one sentence for a person
  config::ComponentChoice link;  // what a profile would say of it; no id: it is no machine
};

// "mill, 192.168.1.0/28": names and addresses, and all of a subnet of at most 256 addresses.
Result<std::vector<std::string>> hostsIn(const std::string& typed);

// All that `what` can be, but for what is wrong with a name.
std::vector<std::string_view> foundSentences();

// `toEnd`: asked between any two steps; true: what was found so far is all.
std::vector<FoundMachine> findMachines(const std::vector<std::string>& hosts, Seconds atMost,
                                       const std::function<bool()>& toEnd = nullptr);

}  // namespace stillcut::app
