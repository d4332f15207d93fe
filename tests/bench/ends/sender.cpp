// GRBL on a pty through a real CNCjs, as tests/protocol/sender/sender_peer_test.cpp has it; the wire to CNCjs is late.
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "app/io/tcp_wire.h"
#include "tests/bench/ends/kept.h"
#include "tests/bench/ends/machine.h"
#include "tests/bench/ends/scripted_grbl.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/delay_proxy.h"
#include "tests/support/grbl/pty_grbl.h"

namespace stillcut::ends {
namespace {

using namespace cnc::testing;

constexpr int kPort = 8018;

class Sender final : public Machine {
 public:
  explicit Sender(const std::string& modules) {
    const std::string port = std::to_string(kPort);
    cncjs_.emplace(shell("HOME=" + folder_.file("") + " exec node " + modules + "/cncjs/bin/cncjs -H 127.0.0.1 -p " +
                         port + " -c " + folder_.file("rc") + " >" + folder_.file("log") + " 2>&1"));
    within(Seconds(30.0), [] {
      const auto wire = std::move(app::TcpWire::make("127.0.0.1", kPort)).value();
      wire->connect();
      wire->wait(std::chrono::milliseconds(20));
      return wire->state() == WireState::Open;
    });
    operator_.emplace(shell("exec node " STILLCUT_SOURCE_DIR "/tests/protocol/sender/sender_operator.js " + modules +
                            " " + port + " " + path_));
  }
  void delay(Seconds late) override { wire_.emplace(kPort, late); }
  std::unique_ptr<cnc::CncLink> link() override {
    return keptLink("grbl", {{"sender", "true"}, {"host", "127.0.0.1"}, {"port", std::to_string(wire_->port())}},
                    folder_.file(""));
  }
  Stand stands() override { return standsIn(controller_); }
  void rest() override {
    pull(false);
    hang(false);
    lie(Lie::None);
    hand({100, 100});
  }
  bool hand(Stand percent) override {
    turn(controller_, percent);
    return true;
  }
  bool pull(bool out) override {
    wire_->pull(out);
    return true;
  }
  bool hang(bool hangs) override {
    cncjs_->signal(hangs ? SIGSTOP : SIGCONT);
    return true;
  }
  // As long as what it stands for: the frame tells its size before it.
  bool lie(Lie how) override {
    lieInReports(*wire_, how, "\"ov\":\\[83,100,83\\]", "\"ov\":[93,100,93]");
    return true;
  }

 private:
  static std::vector<std::string> shell(const std::string& line) { return {"sh", "-c", line}; }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("machine");
  PtyGrbl controller_{path_};
  std::optional<Child> cncjs_, operator_;
  std::optional<DelayProxy> wire_;
};

}  // namespace

std::unique_ptr<Machine> makeSender(std::string& why) {
  const char* const modules = std::getenv("STILLCUT_CNCJS");
  if (modules == nullptr || !std::filesystem::exists(std::string(modules) + "/cncjs/bin/cncjs")) {
    why = "CNCjs is not installed (STILLCUT_CNCJS names its node_modules: npm install --ignore-scripts cncjs)";
    return nullptr;
  }
  return std::make_unique<Sender>(modules);
}

}  // namespace stillcut::ends
