// The link against newer ways of linuxcncrsh, spoken in front of a real LinuxCNC with a spindle that takes time. They
// wait for it in real time, and each wait is bounded.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/io/tcp_wire.h"
#include "tests/protocol/linuxcnc_bench.h"
#include "tests/support/child.h"

namespace stillcut::cnc {
namespace {

using testing::linkToLinuxCnc;
using testing::LinuxCncPeer;
namespace fs = std::filesystem;

constexpr int kPort = 5017;

class LinuxCncNewerReal : public testing::LinuxCncBench, public ::testing::WithParamInterface<const char*> {
 protected:
  static void SetUpTestSuite() { peer_ = new LinuxCncPeer; }
  static void TearDownTestSuite() {
    delete peer_;
    peer_ = nullptr;
  }
  void SetUp() override {
    if (!peer_->ok()) GTEST_SKIP() << peer_->why();
    const fs::path script = fs::path(STILLCUT_SHARED_DIR) / "cases_files" / GetParam();
    if (!fs::exists(script)) GTEST_SKIP() << "the shared speaker of this way is not here";
    peer_->run("long.ngc");
    const std::string run =
        "cd " + folder_.file("") + " && exec /usr/bin/python3 " + script.string() + " " + std::to_string(kPort);
    speaker_ = std::make_unique<testing::Child>(std::vector<std::string>{"sh", "-c", run});
    ASSERT_TRUE(testing::within(Seconds(5.0), [] {
      const auto wire = std::move(app::TcpWire::make("127.0.0.1", kPort)).value();
      wire->connect();
      wire->wait(std::chrono::milliseconds(20));
      return wire->state() == WireState::Open;
    }));
    link_ = linkToLinuxCnc({{"port", std::to_string(kPort)}});
    ASSERT_TRUE(until(cutting)) << "program " << seen_.programRunning << ", speed " << seen_.actualSpeed.value;
  }
  void TearDown() override { link_.reset(); }

  static LinuxCncPeer* peer_;
  testing::TemporaryFolder folder_;
  std::unique_ptr<testing::Child> speaker_;
};
LinuxCncPeer* LinuxCncNewerReal::peer_ = nullptr;

TEST_P(LinuxCncNewerReal, BothOverridesActTheSpindleFollowsAndEveryEndGoesHome) {
  const auto followed = [](const MachineState& m) {
    return at(m, 0.9) && std::abs(m.actualSpeed.value - 7200.0) < 20.0;
  };
  EXPECT_TRUE(untilCommanding(90.0, followed))
      << seen_.speedOverride.value << " " << seen_.feedOverride.value << " " << seen_.actualSpeed.value;
  link_->release(clock_.now());
  EXPECT_TRUE(until([](const MachineState& m) { return at(m, 1.0) && std::abs(m.actualSpeed.value - 8000.0) < 20.0; }));
  ASSERT_TRUE(untilCommanding(90.0, [](const MachineState& m) { return at(m, 0.9); }));
  link_.reset();
  const std::string left = LinuxCncPeer::talk({"get feed_override", "get spindle_override 0"});
  EXPECT_NE(left.find("FEED_OVERRIDE 100"), std::string::npos) << left;
  EXPECT_NE(left.find("SPINDLE_OVERRIDE 0 100"), std::string::npos) << left;
}
INSTANTIATE_TEST_SUITE_P(As, LinuxCncNewerReal, ::testing::Values("rsh_210.py", "rsh_master.py"),
                         [](const auto& p) { return std::string(p.param).substr(4, 3) == "210" ? "Ten" : "Master"; });

}  // namespace
}  // namespace stillcut::cnc
