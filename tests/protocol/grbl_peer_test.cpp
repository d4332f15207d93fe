// The GRBL link through QSerialPort on a real pty, reached by a typed path, with a scripted controller on its other
// end. Waits are in real time, and each is bounded.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <unistd.h>

#include <QCoreApplication>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "app/io/wires.h"
#include "core/cnc/registry.h"
#include "tests/protocol/bounded_wait.h"
#include "tests/protocol/child.h"
#include "tests/protocol/commander.h"
#include "tests/protocol/fake_grbl.h"

namespace stillcut::cnc {
namespace {

// FakeGrbl on the master end of a pty; a person would type `path`.
class PtyGrbl {
 public:
  explicit PtyGrbl(std::string path) : path_(std::move(path)) { plugIn(); }
  ~PtyGrbl() { pull(); }
  PtyGrbl(const PtyGrbl&) = delete;
  PtyGrbl& operator=(const PtyGrbl&) = delete;

  void plugIn() {
    int slave = -1;
    char name[128] = {};
    termios raw{};
    ::cfmakeraw(&raw);
    ASSERT_EQ(::openpty(&master_, &slave, name, &raw, nullptr), 0);
    keepOpen_ = slave;
    std::filesystem::remove(path_);
    std::filesystem::create_symlink(name, path_);
    stopped_ = false;
    thread_ = std::thread([this] { serve(); });
  }
  // The cable, the adapter and its device file go.
  void pull() {
    if (!thread_.joinable()) return;
    stopped_ = true;
    thread_.join();
    ::close(keepOpen_);
    ::close(master_);
    std::filesystem::remove(path_);
  }
  template <class Change>
  void with(Change&& change) {
    const std::lock_guard lock(mutex_);
    change(grbl_);
  }
  bool stands(int speed, int feed) {
    const std::lock_guard lock(mutex_);
    return grbl_.spindle == speed && grbl_.feed == feed;
  }

 private:
  void serve() {
    while (!stopped_) {
      pollfd input{master_, POLLIN, 0};
      if (::poll(&input, 1, 20) <= 0) continue;
      char bytes[256];
      const auto n = ::read(master_, bytes, sizeof bytes);
      if (n <= 0) continue;
      std::string reply;
      {
        const std::lock_guard lock(mutex_);
        grbl_.take({bytes, static_cast<std::size_t>(n)}, SteadyClock().now(),
                   [&](const std::string& text, double) { reply += text; });
      }
      for (std::size_t at = 0; at < reply.size(); at += 7) {  // in pieces, as adapters deliver
        const std::string_view piece = std::string_view(reply).substr(at, 7);
        if (::write(master_, piece.data(), piece.size()) < 0) return;
      }
    }
  }

  std::string path_;
  int master_ = -1, keepOpen_ = -1;
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  testing::FakeGrbl grbl_;
  std::thread thread_;
};

class GrblOnAPty : public ::testing::Test {
 protected:
  std::unique_ptr<CncLink> make() {
    LinkRequest request;
    request.settings = {{"device", path_}, {"baud", "115200"}};
    request.wires = app::makeWire;
    request.clock = &clock_;
    auto link = makeLink("grbl", request);
    EXPECT_TRUE(link.ok()) << link.error().line();
    return std::move(link).value();
  }
  bool until(const std::function<bool(const MachineState&)>& wanted, double seconds = 8.0) {
    return testing::within(Seconds(seconds), [&] {
      seen_ = link_->read(clock_.now());
      return wanted(seen_);
    });
  }
  static bool valid(const MachineState& m) { return m.valid; }
  bool take() {
    link_->apply(gate_.set(90.0), clock_.now());
    return until([&](const MachineState&) { return controller_.stands(90, 90); });
  }

  testing::TemporaryFolder folder_;
  std::string path_ = folder_.file("machine");
  PtyGrbl controller_{path_};
  SteadyClock clock_;
  testing::CommandMaker gate_;
  MachineState seen_;
  std::unique_ptr<CncLink> link_ = make();
};

TEST_F(GrblOnAPty, TypedPathOpensReadsMovesAndBringsBack) {
  ASSERT_TRUE(link_->open().ok());
  ASSERT_TRUE(until(valid));
  EXPECT_EQ(seen_.programmedSpeed.value, 8800.0);
  EXPECT_GT(seen_.link.roundTrip.value, 0.0);
  ASSERT_TRUE(take());
  EXPECT_TRUE(until([](const MachineState& m) { return std::abs(m.speedOverride.value - 0.9) < 1e-9; }));
  link_->release(clock_.now());
  EXPECT_TRUE(controller_.stands(100, 100));
}

TEST_F(GrblOnAPty, EndOfTheProgramBringsBack) {
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  link_.reset();
  EXPECT_TRUE(testing::within(Seconds(2.0), [&] { return controller_.stands(100, 100); }));
}

TEST_F(GrblOnAPty, PulledAdapterIsDownAndOneThatComesBackIsBroughtBack) {
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  controller_.pull();
  EXPECT_TRUE(until([](const MachineState& m) { return !m.valid && !m.linkUp; }));
  link_->release(clock_.now());
  EXPECT_TRUE(controller_.stands(90, 90));  // no way there, and GRBL has no watchdog
  controller_.plugIn();
  EXPECT_TRUE(until([&](const MachineState& m) { return m.valid && controller_.stands(100, 100); }));
}

TEST_F(GrblOnAPty, ControllerThatRestartsIsSeenAnew) {
  ASSERT_TRUE(until(valid));
  ASSERT_TRUE(take());
  controller_.with([](testing::FakeGrbl& g) { g.feed = g.spindle = 100; });  // a soft reset
  link_->release(clock_.now());
  EXPECT_TRUE(until([&](const MachineState& m) { return m.valid && controller_.stands(100, 100); }));
}

// The command line finds its way by the typed path, writes the link and its delay into the profile, and compares later.
TEST_F(GrblOnAPty, TriedLinkIsSavedWithItsDelay) {
  link_.reset();
  const std::string profile = folder_.file("mill.toml"), said = folder_.file("said");
  std::ofstream(profile) << "version = 1\nmachine = \"Mill\"\n";
  const auto tries = [&](const std::string& more) {
    const std::string line = std::string(STILLCUT_CLI) + " devices --profile " + profile + more + " >" + said;
    const int status = std::system(line.c_str());
    std::ifstream in(said);
    return std::pair(status, std::string(std::istreambuf_iterator<char>(in), {}));
  };
  const auto [first, firstSaid] = tries(" --try grbl --with device=" + path_ + " --save");
  ASSERT_EQ(first, 0) << firstSaid;
  EXPECT_EQ(firstSaid.find("when this was saved"), std::string::npos);
  std::ifstream in(profile);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_NE(text.find("delay_ms = "), std::string::npos) << text;
  const auto [second, secondSaid] = tries("");
  EXPECT_EQ(second, 0) << secondSaid;
  EXPECT_NE(secondSaid.find("when this was saved"), std::string::npos) << secondSaid;
  EXPECT_TRUE(controller_.stands(100, 100));  // nothing moved
}

// What the manual says of a controller without a watchdog, and what the next start makes of it.
TEST_F(GrblOnAPty, KilledProgramLeavesTheOverridesAndTheNextStartTakesThemForTheOperators) {
  link_.reset();
  {
    const testing::Commander killed([&] { return make(); });
    ASSERT_TRUE(killed.took());
    killed.signal(SIGKILL);
  }
  EXPECT_FALSE(testing::within(Seconds(0.5), [&] { return !controller_.stands(90, 90); }));
  link_ = make();
  EXPECT_FALSE(link_->describe().machineWatchdog);  // so the screen asks twice before Auto
  ASSERT_TRUE(until(valid));
  EXPECT_NEAR(seen_.operatorSpeed.value, 0.9, 1e-9);
}

}  // namespace
}  // namespace stillcut::cnc
