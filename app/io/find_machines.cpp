#include "app/io/find_machines.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string_view>
#include <utility>

#include "app/io/tcp_wire.h"
#include "core/base/time.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;

struct Service {
  int port;
  std::string_view what;
};
// Not stillcut-hal's: it has one client, which a look would put off.
constexpr std::array<Service, 3> kServices{{{5007, "linuxcncrsh: the link 'linuxcnc'"},
                                            {5006, "halrmt: the link 'linuxcnc' measures the spindle with it"},
                                            {502, "a Modbus server: the link 'modbus', with a map of its registers"}}};

void addSerialPorts(std::vector<FoundMachine>& found) {
  for (SerialPort& port : serialPorts()) {
    found.push_back({std::move(port.device), "a serial port: the links 'grbl' and 'modbus'"});
  }
}

struct Knock {
  std::string where;
  std::string_view what;
  std::unique_ptr<cnc::ByteChannel> wire;
  int tries = 2;  // "localhost" is ::1 and 127.0.0.1
  bool open = false;
};

// The first line of a file the kernel keeps; empty: there is none.
std::string lineOf(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

}  // namespace

std::vector<SerialPort> serialPorts(const std::string& devices, const std::string& classes) {
  std::error_code none;
  std::vector<SerialPort> ports;
  for (const auto& entry : fs::directory_iterator(devices, none)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("ttyUSB") && !name.starts_with("ttyACM")) continue;
    // The interface's folder lies in that of its USB device, or one deeper.
    fs::path usb = fs::canonical(fs::path(classes) / name / "device", none);
    std::string label;
    for (int up = 0; up < 3 && !usb.empty() && label.empty(); ++up, usb = usb.parent_path()) {
      const std::string maker = lineOf(usb / "manufacturer");
      const std::string product = lineOf(usb / "product");
      label = maker + (maker.empty() || product.empty() ? "" : " ") + product;
    }
    ports.push_back({entry.path().string(), label});
  }
  std::sort(ports.begin(), ports.end(), [](const SerialPort& a, const SerialPort& b) { return a.device < b.device; });
  return ports;
}

std::vector<FoundMachine> findMachines(const std::vector<std::string>& hosts, Seconds atMost) {
  std::vector<FoundMachine> found;
  addSerialPorts(found);
  std::vector<Knock> knocks;
  for (const std::string& host : hosts) {
    for (const Service& service : kServices) {
      auto wire = TcpWire::make(host, service.port);
      if (!wire) {
        found.push_back({host, wire.error().line()});
        break;
      }
      knocks.push_back({host + ":" + std::to_string(service.port), service.what, std::move(wire).value()});
    }
  }
  const SteadyClock clock;
  const Instant end = clock.now() + toDuration(atMost);
  bool waiting = true;
  while (waiting && clock.now() < end) {
    waiting = false;
    for (Knock& k : knocks) {
      if (k.open) continue;
      if (k.wire->state() == cnc::WireState::Closed && k.tries > 0) {
        --k.tries;
        k.wire->connect();
      }
      k.open = k.wire->state() == cnc::WireState::Open;
      const bool pending = !k.open && (k.tries > 0 || k.wire->state() == cnc::WireState::Opening);
      if (pending) k.wire->wait(std::chrono::milliseconds(1));
      waiting = waiting || pending;
    }
  }
  for (const Knock& k : knocks) {
    if (k.open) found.push_back({k.where, std::string(k.what)});
  }
  return found;
}

}  // namespace stillcut::app
