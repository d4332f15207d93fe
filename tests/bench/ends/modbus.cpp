// A PLC by pymodbus, over TCP or a serial line, whose registers keep what was written. What stands in it is read from
// its log.
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>

#include "tests/bench/ends/kept.h"
#include "tests/bench/ends/machine.h"
#include "tests/bench/ends/tail.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/delay_proxy.h"

namespace stillcut::ends {
namespace {

using namespace cnc::testing;

constexpr int kPort = 15027;
constexpr const char* kScript = STILLCUT_SOURCE_DIR "/tests/protocol/modbus/modbus_peer.py";

class Modbus final : public Machine {
 public:
  explicit Modbus(bool serial) : serial_(serial) {
    const std::string port = std::to_string(kPort);
    if (!serial_) {
      server_.emplace(words({kScript, "tcp", port, folder_.file("log"), "retained"}));
      return;
    }
    // A serial line that is late: a pty at either end of a TCP connection.
    const std::string far = folder_.file("far");
    farEnd_.emplace(socat(far, "TCP-LISTEN:" + port + ",bind=127.0.0.1,reuseaddr,nodelay"));
    within(Seconds(5.0), [&] { return std::filesystem::exists(far); });
    server_.emplace(words({kScript, "rtu", far, folder_.file("log"), "retained"}));
  }
  ~Modbus() override {
    if (held_ >= 0) ::close(held_);
  }
  Modbus(const Modbus&) = delete;
  Modbus& operator=(const Modbus&) = delete;

  void delay(Seconds late) override {
    if (wire_) {
      wire_->delay(late);
    } else {
      wire_.emplace(kPort, late);
      if (serial_) connect();
    }
    const std::string bus = serial_ ? "device = \"" + folder_.file("near") + "\"\nbaud = 115200\nparity = \"none\""
                                    : "host = \"127.0.0.1\"\nport = " + std::to_string(wire_->port());
    std::ifstream in(STILLCUT_SOURCE_DIR "/resources/machines/modbus-example.toml");
    std::stringstream map;
    map << in.rdbuf();
    const std::string here = std::regex_replace(map.str(), std::regex("host = [^\n]*\nport = [^\n]*"), bus);
    // As its owner has to say it: rather too long than too short.
    const long answer_ms = 200 + std::lround(3e3 * late.value);
    std::ofstream(folder_.file("map.toml"))
        << std::regex_replace(here, std::regex("answer_ms = 200"), "answer_ms = " + std::to_string(answer_ms));
  }
  std::unique_ptr<cnc::CncLink> link() override {
    return keptLink("modbus", {{"map", folder_.file("map.toml")}}, folder_.file(""));
  }
  Stand stands() override {
    log_.look([&](std::istream& words) {
      std::string what;
      int value = 0;
      words >> what >> value;
      if (what == "100") stand_.speed = static_cast<int>(std::lround(0.1 * value));
      if (what == "101") stand_.feed = static_cast<int>(std::lround(0.1 * value));
    });
    return stand_;
  }
  bool pull(bool out) override {
    wire_->pull(out, serial_);
    return true;
  }
  bool hang(bool hangs) override {
    server_->signal(hangs ? SIGSTOP : SIGCONT);
    return true;
  }
  // A bit of each register is another, in answers to both ways of reading one. A serial line has a checksum for that.
  bool lie(Lie how) override {
    if (serial_ || !wire_) return false;
    if (how == Lie::None) {
      wire_->lie(nullptr);
      return true;
    }
    wire_->lie([how, told = false](std::string& bytes) mutable {
      constexpr std::size_t kFunction = 7, kFirst = 9;
      if (told || bytes.size() <= kFirst + 1 || (bytes[kFunction] != 3 && bytes[kFunction] != 4)) return;
      for (std::size_t at = kFirst + 1; at < bytes.size(); at += 2) bytes[at] = static_cast<char>(bytes[at] ^ 0x40);
      told = how == Lie::Once;
    });
    return true;
  }
  void rest() override {
    pull(false);
    hang(false);
    lie(Lie::None);
    const auto link = keptLink("modbus", {{"map", folder_.file("map.toml")}}, folder_.file(""));
    const SteadyClock clock;
    if (link->open()) {
      link->adopt(Ratio(1.0), Ratio(1.0));  // whatever was left there
      link->release(clock.now());
    }
    within(Seconds(2.0), [&] {
      link->read(clock.now());
      return stands() == Stand{100, 100};
    });
  }

 private:
  void connect() {
    const std::string near = folder_.file("near");
    nearEnd_.emplace(socat(near, "TCP:127.0.0.1:" + std::to_string(wire_->port()) + ",nodelay"));
    within(Seconds(5.0), [&] { return std::filesystem::exists(near); });
    held_ = ::open(near.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);  // the line outlives each program
  }
  static std::vector<std::string> words(const std::vector<std::string>& arguments) {
    std::string line = "exec /usr/bin/python3";
    for (const std::string& a : arguments) line += " " + a;
    return {"sh", "-c", line + " 2>/dev/null"};  // it complains of each program that is killed
  }
  static std::vector<std::string> socat(const std::string& link, const std::string& other) {
    return {"socat", "PTY,raw,echo=0,link=" + link, other};
  }

  bool serial_;
  TemporaryFolder folder_;
  int held_ = -1;
  std::optional<Child> farEnd_, server_, nearEnd_;
  Tail log_{folder_.file("log")};
  Stand stand_{100, 100};
  std::optional<DelayProxy> wire_;
};

}  // namespace

std::unique_ptr<Machine> makeModbus(bool serial, std::string& why) {
  if (std::system("/usr/bin/python3 -c 'import pymodbus, serial_asyncio' 2>/dev/null") != 0)
    why = "python3-pymodbus or python3-serial-asyncio is not installed";
  if (serial && std::system("command -v socat >/dev/null") != 0) why = "socat is not installed";
  return why.empty() ? std::make_unique<Modbus>(serial) : nullptr;
}

}  // namespace stillcut::ends
