// GRBL through a real CNCjs, which has a scripted controller on a pty. CNCjs comes from the npm registry:
// STILLCUT_CNCJS names the node_modules that it was installed into (npm install --ignore-scripts cncjs), else this is
// skipped. Waits are in real time, and each is bounded.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/io/tcp_wire.h"
#include "app/io/wires.h"
#include "core/cnc/registry.h"
#include "tests/protocol/commands.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"
#include "tests/support/grbl/pty_grbl.h"

namespace stillcut::cnc {
namespace {

constexpr int kPort = 8017;

class GrblBehindCncjs : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* const modules = std::getenv("STILLCUT_CNCJS");
    if (modules == nullptr || !std::filesystem::exists(std::string(modules) + "/cncjs/bin/cncjs")) {
      GTEST_SKIP() << "CNCjs is not installed (STILLCUT_CNCJS)";
    }
    const std::string port = std::to_string(kPort), quiet = " >" + folder_.file("log") + " 2>&1";
    cncjs_ = run("HOME=" + folder_.file("") + " exec node " + modules + "/cncjs/bin/cncjs -H 127.0.0.1 -p " + port +
                 " -c " + folder_.file("rc") + quiet);
    ASSERT_TRUE(testing::within(Seconds(30.0), [] {
      const auto wire = std::move(app::TcpWire::make("127.0.0.1", kPort)).value();
      wire->connect();
      wire->wait(std::chrono::milliseconds(20));
      return wire->state() == WireState::Open;
    }));
    operator_ = run("exec node " STILLCUT_SOURCE_DIR "/tests/protocol/sender/sender_operator.js " +
                    std::string(modules) + " " + port + " " + path_);
    link_ = make();
    ASSERT_TRUE(until([](const MachineState& m) { return m.valid && m.programRunning; }, 20.0));
  }
  void TearDown() override { link_.reset(); }
  static std::unique_ptr<testing::Child> run(const std::string& line) {
    return std::make_unique<testing::Child>(std::vector<std::string>{"sh", "-c", line});
  }
  std::unique_ptr<CncLink> make() {
    LinkRequest request;
    request.settings = {{"sender", "true"}, {"host", "127.0.0.1"}, {"port", std::to_string(kPort)}};
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

  testing::TemporaryFolder folder_;
  std::string path_ = folder_.file("machine");
  testing::PtyGrbl controller_{path_};
  SteadyClock clock_;
  testing::CommandMaker gate_;
  std::unique_ptr<testing::Child> cncjs_, operator_;
  MachineState seen_;
  std::unique_ptr<CncLink> link_;
};

TEST_F(GrblBehindCncjs, BothOverridesActAndEveryEndGoesHome) {
  EXPECT_EQ(seen_.programmedSpeed.value, 8800.0);
  link_->apply(gate_.set(88.0), clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) {
    return m.valid && std::abs(m.speedOverride.value - 0.88) < 1e-9 && std::abs(m.feedOverride.value - 0.88) < 1e-9;
  }));
  EXPECT_TRUE(controller_.stands(88, 88));
  link_->release(clock_.now());
  EXPECT_TRUE(testing::within(Seconds(1.0), [&] { return controller_.stands(100, 100); }));
  link_->apply(gate_.set(91.0), clock_.now());
  ASSERT_TRUE(until([&](const MachineState&) { return controller_.stands(91, 91); }))
      << seen_.valid << " " << seen_.speedOverride.value << " of " << seen_.operatorSpeed.value << ", "
      << seen_.feedOverride.value << " of " << seen_.operatorFeed.value << ", " << controller_.steps() << " steps";
  link_.reset();
  EXPECT_TRUE(testing::within(Seconds(1.0), [&] { return controller_.stands(100, 100); }));
}

TEST_F(GrblBehindCncjs, ASenderThatEndsIsDownAndTheNextOneIsJoined) {
  link_->apply(gate_.set(90.0), clock_.now());
  ASSERT_TRUE(until([&](const MachineState&) { return controller_.stands(90, 90); }));
  operator_.reset();
  cncjs_.reset();
  EXPECT_TRUE(until([](const MachineState& m) { return !m.valid && !m.linkUp; }));
  EXPECT_TRUE(controller_.stands(90, 90)) << "nobody leads there";
  SetUp();  // a sender again, its operator, and a link
  link_->release(clock_.now());
}

}  // namespace
}  // namespace stillcut::cnc
