#include "app/io/find_machines.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

#include "app/io/tcp_wire.h"
#include "core/base/time.h"

namespace stillcut::app {
namespace {

namespace fs = std::filesystem;

struct Service {
  int port;
  std::string_view what, link;
  bool host;                 // a setting of the link; else its map has it
  std::string_view setting;  // that takes the port, where it is not there by itself
};
constexpr std::array<Service, 5> kServices{{
    {5007, "linuxcncrsh, for 'linuxcnc'", "linuxcnc", true, {}},
    {5006, "halrmt, spindle speed for 'linuxcnc'", "linuxcnc", true, {}},
    {5008, "stillcut-hal, watchdog for 'linuxcnc'", "linuxcnc", true, "hal_component_port"},
    {5009, "stillcut-status, beside any screen, for 'linuxcnc'", "linuxcnc", true, "status_port"},
    {502, "Modbus server, for 'modbus' with a map", "modbus", false, {}},
}};
constexpr std::string_view kSerialPort = "serial port, for 'grbl' or 'modbus'";
constexpr std::size_t kAtOnce = 32;  // hosts: a few sockets each

void addSerialPorts(std::vector<FoundMachine>& found) {
  for (const SerialPort& port : serialPorts()) {
    found.push_back({port.device + (port.label.empty() ? "" : " (" + port.label + ")"),
                     std::string(kSerialPort),
                     {"grbl", {{"device", port.device}}}});
  }
}

struct Knock {
  std::string host;
  const Service* service;
  std::unique_ptr<cnc::ByteChannel> wire;
  int tries = 2;  // "localhost" is ::1 and 127.0.0.1
  bool open = false;

  // True: it may still open.
  bool pending() {
    if (open) return false;
    if (wire->state() == cnc::WireState::Closed && tries > 0) {
      --tries;
      wire->connect();
    }
    open = wire->state() == cnc::WireState::Open;
    return !open && (tries > 0 || wire->state() == cnc::WireState::Opening);
  }
  FoundMachine found() const {
    config::ComponentChoice link{std::string(service->link), {}};
    if (service->host) link.settings["host"] = host;
    if (!service->setting.empty()) link.settings[std::string(service->setting)] = std::to_string(service->port);
    return {host + ":" + std::to_string(service->port), std::string(service->what), std::move(link)};
  }
};

void knockOn(std::span<const std::string> hosts, Seconds atMost, const std::function<bool()>& toEnd,
             std::vector<FoundMachine>& found) {
  std::vector<Knock> knocks;
  for (const std::string& host : hosts) {
    if (toEnd()) return;
    for (const Service& service : kServices) {
      auto wire = TcpWire::make(host, service.port);
      if (!wire) {
        found.push_back({host, wire.error().line(), {}});
        break;
      }
      knocks.push_back({host, &service, std::move(wire).value()});
    }
  }
  const SteadyClock clock;
  const Instant end = clock.now() + toDuration(atMost);
  Knock* waiting = nullptr;
  do {
    waiting = nullptr;
    for (Knock& k : knocks) {
      if (k.pending()) waiting = &k;
    }
    if (waiting != nullptr) waiting->wire->wait(std::chrono::milliseconds(1));
  } while (waiting != nullptr && clock.now() < end && !toEnd());
  for (const Knock& k : knocks) {
    if (k.open) found.push_back(k.found());
  }
}

// "192.168.1.0/28" taken apart.
struct Subnet {
  std::uint32_t first = 0;
  int bits = 0;
};
std::optional<Subnet> subnet(const std::string& word) {
  const std::size_t slash = word.find('/');
  in_addr address{};
  if (slash == std::string::npos || ::inet_pton(AF_INET, word.substr(0, slash).c_str(), &address) != 1) return {};
  const std::string_view digits = std::string_view(word).substr(slash + 1);
  Subnet net;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), net.bits);
  if (error != std::errc() || end != digits.data() + digits.size() || net.bits < 0 || net.bits > 32) return {};
  const std::uint32_t mask = net.bits == 0 ? 0U : ~0U << static_cast<unsigned>(32 - net.bits);
  net.first = ntohl(address.s_addr) & mask;
  return net;
}

// The first line of a file the kernel keeps; empty: there is none.
std::string lineOf(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

}  // namespace

std::string lastingName(const std::string& device, const std::string& devices) {
  std::error_code none;
  const fs::path port = fs::canonical(device, none);
  std::string lasting;
  for (const auto& entry : fs::directory_iterator(fs::path(devices) / "serial/by-id", none)) {
    std::error_code dangling;
    if (port.empty() || fs::canonical(entry.path(), dangling) != port) continue;
    // Of several the first, so that it is the same each time.
    if (lasting.empty() || entry.path().string() < lasting) lasting = entry.path().string();
  }
  return lasting.empty() ? device : lasting;
}

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
      label = maker;
      if (!maker.empty() && !product.empty()) label += ' ';
      label += product;
    }
    ports.push_back({lastingName(entry.path().string(), devices), label});
  }
  std::sort(ports.begin(), ports.end(), [](const SerialPort& a, const SerialPort& b) { return a.device < b.device; });
  return ports;
}

Result<std::vector<std::string>> hostsIn(const std::string& typed) {
  constexpr int kSmallestNet = 24;
  std::string spaced = typed;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream words(spaced);
  std::vector<std::string> hosts;
  for (std::string word; words >> word;) {
    if (word.find('/') == std::string::npos) {
      hosts.push_back(word);
      continue;
    }
    const auto net = subnet(word);
    if (!net) return Error{word, message("is no subnet"), message("as 192.168.1.0/24")};
    if (net->bits < kSmallestNet)
      return Error{word, message("is more than 256 addresses"), message("/24 or a larger number")};
    for (std::uint32_t i = 0; i < 1U << static_cast<unsigned>(32 - net->bits); ++i) {
      in_addr address{htonl(net->first + i)};
      std::array<char, INET_ADDRSTRLEN> text{};
      hosts.emplace_back(::inet_ntop(AF_INET, &address, text.data(), text.size()));
    }
  }
  return hosts;
}

std::vector<std::string_view> foundSentences() {
  std::vector<std::string_view> all{kSerialPort};
  for (const Service& service : kServices) all.push_back(service.what);
  return all;
}

std::vector<FoundMachine> findMachines(const std::vector<std::string>& hosts, Seconds atMost,
                                       const std::function<bool()>& toEnd) {
  const auto ends = [&toEnd] { return toEnd && toEnd(); };
  std::vector<FoundMachine> found;
  addSerialPorts(found);
  const std::span<const std::string> all(hosts);
  for (std::size_t first = 0; first < all.size() && !ends(); first += kAtOnce) {
    knockOn(all.subspan(first, std::min(kAtOnce, all.size() - first)), atMost, ends, found);
  }
  return found;
}

}  // namespace stillcut::app
