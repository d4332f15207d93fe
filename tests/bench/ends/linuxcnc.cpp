// The real LinuxCNC, with and without stillcut-hal, headless. stillcut-status is its only witness where stillcut-hal
// moves it, as the manual has it; linuxcncrsh and halrmt are in the other case.
#include <array>
#include <cstdio>
#include <optional>
#include <regex>
#include <vector>

#include "tests/bench/ends/kept.h"
#include "tests/bench/ends/machine.h"
#include "tests/bench/ends/tail.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/delay_proxy.h"
#include "tests/support/linuxcnc/linuxcnc_peer.h"

namespace stillcut::ends {
namespace {

using namespace cnc::testing;

constexpr std::array<int, 4> kPorts{LinuxCncPeer::kPort, LinuxCncPeer::kHalPort, LinuxCncPeer::kComponentPort,
                                    LinuxCncPeer::kStatusPort};

class LinuxCnc final : public Machine {
 public:
  explicit LinuxCnc(bool component)
      : component_(component), peer_(component ? LinuxCncPeer::Overrides::Component : LinuxCncPeer::Overrides::Rsh) {
    if (peer_.ok()) watch();
  }
  ~LinuxCnc() override { unwatch(); }
  LinuxCnc(const LinuxCnc&) = delete;
  LinuxCnc& operator=(const LinuxCnc&) = delete;

  const std::string& why() const { return peer_.why(); }
  void delay(Seconds late) override {
    wires_.clear();
    for (const int port : kPorts) wires_.push_back(std::make_unique<DelayProxy>(port, late));
  }
  std::unique_ptr<cnc::CncLink> link() override {
    const auto port = [&](std::size_t which) { return std::to_string(wires_[which]->port()); };
    std::map<std::string, std::string> settings{{"host", "127.0.0.1"}};
    if (component_) {
      settings.insert({{"hal_component_port", port(2)}, {"status_port", port(3)}});
    } else {
      settings.insert({{"port", port(0)}, {"hal_port", port(1)}});
    }
    return keptLink("linuxcnc", settings, folder_.file(""));
  }
  Stand stands() override {
    lines_->look([&](std::istream& words) { words >> stand_.speed >> stand_.feed >> running_; });
    return stand_;
  }
  void rest() override {
    pull(false);
    hang(false);
    lie(Lie::None);
    if (componentGone_) startAgain();
    componentGone_ = false;
    tell("run " + peer_.file("long.ngc"));
    within(Seconds(10.0), [&] { return stands() == Stand{100, 100} && running_ == 1; });
  }
  bool hand(Stand percent) override {
    tell("hand " + std::to_string(percent.speed) + " " + std::to_string(percent.feed));
    return true;
  }
  bool pull(bool out) override {
    for (const auto& wire : wires_) wire->pull(out);
    return true;
  }
  bool hang(bool hangs) override {
    for (const char* server : {"linuxcncrsh", "stillcut-status"}) {
      const pid_t process = peer_.process(server);
      if (process > 0) ::kill(process, hangs ? SIGSTOP : SIGCONT);
    }
    return true;
  }
  bool power(bool on) override {
    tell(on ? "power on" : "power off");
    return true;
  }
  bool lie(Lie how) override {
    for (const std::size_t which : {0U, 3U}) {
      if (how == Lie::None) {
        wires_[which]->lie(nullptr);
        continue;
      }
      wires_[which]->lie([how, speed = false, feed = false](std::string& bytes) mutable {
        static const std::regex kSpeed("(SPINDLE_OVERRIDE 0) [0-9]+"), kFeed("(FEED_OVERRIDE) [0-9]+");
        const auto change = [&](bool& told, const std::regex& what) {
          if (told || !std::regex_search(bytes, what)) return;
          bytes = std::regex_replace(bytes, what, "$1 93");
          told = how == Lie::Once;
        };
        change(speed, kSpeed);
        change(feed, kFeed);
      });
    }
    return true;
  }
  bool component(int signal) override {
    if (!component_) return false;
    componentGone_ = true;  // HAL keeps the pins of one that died: the machine starts anew
    return ::kill(peer_.process("stillcut-hal"), signal) == 0;
  }

 private:
  void watch() {
    const std::string script = STILLCUT_SOURCE_DIR "/tests/bench/ends/linuxcnc_hand.py", out = folder_.file("stands");
    std::remove(out.c_str());
    lines_.emplace(out);
    stand_ = {};
    hand_ = ::popen(("HOME=" + peer_.file("") + " exec /usr/bin/python3 " + script + " " + out).c_str(), "w");
  }
  void unwatch() {
    if (hand_ != nullptr) ::pclose(hand_);
    hand_ = nullptr;
  }
  void startAgain() {
    unwatch();
    peer_.end();
    peer_.start();
    watch();
  }
  void tell(const std::string& line) const {
    std::fprintf(hand_, "%s\n", line.c_str());
    std::fflush(hand_);
  }

  bool component_;
  LinuxCncPeer peer_;
  TemporaryFolder folder_;
  FILE* hand_ = nullptr;
  std::optional<Tail> lines_;
  Stand stand_;
  int running_ = 0;
  bool componentGone_ = false;
  std::vector<std::unique_ptr<DelayProxy>> wires_;
};

}  // namespace

std::unique_ptr<Machine> makeLinuxCnc(bool component, std::string& why) {
  auto machine = std::make_unique<LinuxCnc>(component);
  why = machine->why();
  return why.empty() ? std::move(machine) : nullptr;
}

}  // namespace stillcut::ends
