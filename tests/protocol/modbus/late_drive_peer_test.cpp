// The Modbus link through QSerialPort on a real pty, with a drive on its other end that answers late every now and
// then. It waits in real time, and each wait is bounded.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "app/io/wires.h"
#include "core/cnc/modbus/modbus_link.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"

namespace stillcut::cnc {
namespace {

namespace fs = std::filesystem;

class ModbusLate : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    const fs::path files = fs::path(STILLCUT_SHARED_DIR) / "cases_files";
    if (!fs::exists(files / "mbrtu.py")) GTEST_SKIP() << "the shared late drive is not here";
    drive_ = std::make_unique<testing::Child>(std::vector<std::string>{
        "/usr/bin/python3", (files / "mbrtu.py").string(), port_, std::to_string(GetParam()), "40"});
    ASSERT_TRUE(testing::within(Seconds(5.0), [&] { return fs::exists(port_); }));
    auto map = loadRegisterMap((files / "mb.toml").string());
    ASSERT_TRUE(map.ok()) << map.error().line();
    map->bus.wire.device = port_;
    auto bus = app::busMaker()(map->bus, clock_);
    ASSERT_TRUE(bus.ok());
    link_ = std::make_unique<ModbusLink>(std::move(map).value(), std::move(bus).value(), clock_);
  }

  testing::TemporaryFolder folder_;
  std::string port_ = folder_.file("drive");
  std::unique_ptr<testing::Child> drive_;
  SteadyClock clock_;
  std::unique_ptr<ModbusLink> link_;
};

TEST_P(ModbusLate, GivesNoWrongState) {
  ASSERT_TRUE(link_->open().ok());
  int looks = 0, valid = 0;
  testing::within(Seconds(6.0), [&] {
    const MachineState m = link_->read(clock_.now());
    ++looks;
    if (!m.valid) return false;
    ++valid;
    EXPECT_EQ(m.programmedSpeed.value, 8000.0);
    EXPECT_NEAR(m.actualSpeed.value, 8000.0, 1e-6);
    EXPECT_NEAR(toMmPerMin(m.programmedFeed), 1200.0, 1e-6);
    EXPECT_EQ(m.speedOverride.value, 1.0);
    EXPECT_TRUE(m.programRunning);
    return ::testing::Test::HasFailure();
  });
  EXPECT_GT(valid, looks / 2) << "of " << looks;
}
INSTANTIATE_TEST_SUITE_P(By, ModbusLate, ::testing::Values(150, 250), ::testing::PrintToStringParamName());

}  // namespace
}  // namespace stillcut::cnc
