// A machine is held by one program: the second is told so before it says a word to the machine.
#include "app/io/one_program_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "tests/support/grbl/fake_grbl.h"
#include "tests/support/temp_folder.h"

namespace stillcut::app {
namespace {

using namespace cnc::testing;
using record::TempFolder;
using testing::HasSubstr;

struct Bench {
  std::unique_ptr<cnc::CncLink> make(const std::map<std::string, std::string>& settings) {
    cnc::LinkRequest request;
    request.settings = settings;
    request.clock = &clock;
    request.wires = [this](const WireAddress&) -> Result<std::unique_ptr<cnc::ByteChannel>> {
      return std::unique_ptr<cnc::ByteChannel>(std::make_unique<ScriptedWire>(clock, faults, grbl));
    };
    auto link = makeOneProgramLink("grbl", request, folder / "");
    EXPECT_TRUE(link.ok()) << link.error().line();
    return std::move(link).value();
  }
  const TempFolder folder;
  test::VirtualClock clock{instantFromNs(1'000'000'000)};
  WireFaults faults;
  FakeGrbl grbl;
};

TEST(OneProgramLink, TheSecondIsToldAndSaysNothingToTheMachine) {
  Bench b;
  const std::map<std::string, std::string> mill{{"host", "localhost"}, {"port", "5023"}};
  const auto first = b.make(mill);
  ASSERT_TRUE(first->open().ok());
  const int reports = b.grbl.reports;
  const auto second = b.make({{"host", "127.0.0.1"}, {"port", "5023"}});
  const Status refused = second->open();
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().line(), HasSubstr("127.0.0.1:5023: the run that is going on holds this machine"));
  EXPECT_EQ(b.grbl.reports, reports);
  const auto other = b.make({{"host", "localhost"}, {"port", "5024"}});
  EXPECT_TRUE(other->open().ok()) << "another machine";
  first->close();
  EXPECT_TRUE(second->open().ok()) << "let go of";
}

// "ttyUSB0" and its name that lasts are one port.
TEST(OneProgramLink, APortWithTwoNamesIsOneMachine) {
  Bench b;
  const std::string port = b.folder / "ttyUSB0", lasting = b.folder / "usb-Maker_Mill-if00";
  std::ofstream(port) << "";
  std::filesystem::create_symlink(port, lasting);
  const auto first = b.make({{"device", port}});
  ASSERT_TRUE(first->open().ok());
  const auto second = b.make({{"device", lasting}});
  const Status refused = second->open();
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().line(), HasSubstr("holds this machine"));
  first->close();
  EXPECT_TRUE(second->open().ok());
}

TEST(OneProgramLink, WhereNoLockCanBeMadeTheMachineIsHeldWithoutOne) {
  Bench b;
  cnc::LinkRequest request;
  request.settings = {{"host", "localhost"}, {"port", "5023"}};
  request.clock = &b.clock;
  request.wires = [&](const WireAddress&) -> Result<std::unique_ptr<cnc::ByteChannel>> {
    return std::unique_ptr<cnc::ByteChannel>(std::make_unique<ScriptedWire>(b.clock, b.faults, b.grbl));
  };
  auto link = makeOneProgramLink("grbl", request, b.folder / "no-such-folder");
  ASSERT_TRUE(link.ok());
  EXPECT_TRUE((*link)->open().ok());
}

}  // namespace
}  // namespace stillcut::app
