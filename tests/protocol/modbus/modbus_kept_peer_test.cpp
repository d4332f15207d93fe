// stillcut-keeper before a real Modbus server (pymodbus) that keeps what was written to it: nobody but the keeper can
// bring it home when the program that wrote is killed or hangs. Waits are in real time and bounded.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "app/io/kept_link.h"
#include "app/io/wires.h"
#include "tests/protocol/commander.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"

namespace stillcut::app {
namespace {

using namespace cnc::testing;

constexpr int kPort = 15023;
constexpr double kPromised = 0.2;  // s
constexpr const char* kScript = STILLCUT_SOURCE_DIR "/tests/protocol/modbus/modbus_peer.py";

enum class Wire { Tcp, Rtu };

class ModbusKept : public ::testing::TestWithParam<Wire> {
 protected:
  void SetUp() override {
    if (std::system("/usr/bin/python3 -c 'import pymodbus, serial_asyncio' 2>/dev/null") != 0)
      GTEST_SKIP() << "python3-pymodbus is not installed";
    std::vector<std::string> server{"/usr/bin/python3", kScript, "tcp", std::to_string(kPort)};
    std::string bus = "host = \"127.0.0.1\"\nport = " + std::to_string(kPort);
    if (GetParam() == Wire::Rtu) {
      if (std::system("command -v socat >/dev/null") != 0) GTEST_SKIP() << "socat is not installed";
      const std::string ours = folder_.file("a"), theirs = folder_.file("b");
      cable_ = std::make_unique<Child>(
          std::vector<std::string>{"socat", "PTY,raw,echo=0,link=" + ours, "PTY,raw,echo=0,link=" + theirs});
      ASSERT_TRUE(
          within(Seconds(5.0), [&] { return std::filesystem::exists(ours) && std::filesystem::exists(theirs); }));
      server = {"/usr/bin/python3", kScript, "rtu", theirs};
      bus = "device = \"" + ours + "\"\nparity = \"none\"";
    }
    server.insert(server.end(), {folder_.file("log"), "retained"});
    server_ = std::make_unique<Child>(server);
    std::ifstream in(STILLCUT_SOURCE_DIR "/resources/machines/modbus-example.toml");
    std::stringstream map;
    map << in.rdbuf();
    std::ofstream(folder_.file("map.toml"))
        << std::regex_replace(map.str(), std::regex("host = [^\n]*\nport = [^\n]*"), bus);
  }
  std::unique_ptr<cnc::CncLink> make() {
    cnc::LinkRequest request;
    request.settings = {{"map", folder_.file("map.toml")}};
    request.wires = makeWire;
    request.buses = busMaker();
    request.clock = &clock_;
    auto link = makeKeptLink("modbus", request, AnalogOutputs::Written, folder_.file(""));
    EXPECT_TRUE(link.ok()) << link.error().line();
    return std::move(link).value();
  }
  // What was written there last, in tenths of a per cent.
  bool lastWritten(const std::string& what, int value) const {
    std::ifstream log(folder_.file("log"));
    int last = -1;
    for (std::string word; log >> word;) {
      int n = 0;
      if (log >> n && word == what) last = n;
    }
    return last == value;
  }
  double homeAfter() {
    const Instant began = clock_.now();
    EXPECT_TRUE(within(Seconds(5.0), [&] {
      return lastWritten("100", 1000) && lastWritten("101", 1000) && lastWritten("control", 0);
    }));
    return secondsBetween(began, clock_.now()).value;
  }

  TemporaryFolder folder_;
  SteadyClock clock_;
  std::unique_ptr<Child> cable_, server_;
};

TEST_P(ModbusKept, AKilledProgramIsHomeInTime) {
  const Commander killed([&] { return make(); });
  ASSERT_TRUE(killed.took());
  killed.signal(SIGKILL);
  EXPECT_LT(homeAfter(), kPromised);
}

TEST_P(ModbusKept, AProgramThatHangsIsHomeInTime) {
  const Commander hung([&] { return make(); });
  ASSERT_TRUE(hung.took());
  hung.signal(SIGSTOP);
  EXPECT_LT(homeAfter(), kPromised);
}

TEST_P(ModbusKept, AKeeperThatDiesIsReplacedAndWhatItLeftBroughtBack) {
  const Commander program([&] { return make(); });
  ASSERT_TRUE(program.took());
  ASSERT_TRUE(within(Seconds(5.0), [&] { return lastWritten("100", 900) && lastWritten("101", 900); }));
  int keeper = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    int process = 0, parent = 0;
    std::string name, state;
    if (stat >> process >> name >> state >> parent && parent == program.process()) keeper = process;
  }
  ASSERT_GT(keeper, 0);
  ::kill(keeper, SIGKILL);
  homeAfter();
}

TEST_P(ModbusKept, WhatIsWrongIsSaidAsWithoutAKeeper) {
  server_.reset();
  const auto link = make();
  EXPECT_TRUE(link->describe().kept);
  EXPECT_EQ(link->describe().label, "Spindle drive by Modbus TCP");
  const Status opened = link->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_NE(opened.error().line().find("unit 1"), std::string::npos) << opened.error().line();
}

INSTANTIATE_TEST_SUITE_P(Wires, ModbusKept, ::testing::Values(Wire::Tcp, Wire::Rtu),
                         [](const auto& wire) { return std::string(wire.param == Wire::Tcp ? "Tcp" : "Rtu"); });

}  // namespace
}  // namespace stillcut::app
