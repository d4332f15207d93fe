// Finds what a machine may be reached by: the serial ports of this computer, and the servers of LinuxCNC and Modbus on
// hosts that were named. It asks nobody else, sends nothing, and lets go at once.
// Thread: one that may wait: `atMost` in all, besides the names' look-up.
#pragma once

#include <string>
#include <vector>

#include "core/base/units.h"

namespace stillcut::app {

struct SerialPort {
  std::string device;  // "/dev/ttyACM0"
  std::string label;   // maker and product of its USB device; empty: not told
};
// USB serial ports, by name. The folders are the kernel's; tests have their own.
std::vector<SerialPort> serialPorts(const std::string& devices = "/dev", const std::string& classes = "/sys/class/tty");

struct FoundMachine {
  std::string where;  // "/dev/ttyUSB0", "localhost:5007"
  std::string what;   // one sentence for a person
};

std::vector<FoundMachine> findMachines(const std::vector<std::string>& hosts, Seconds atMost);

}  // namespace stillcut::app
