// The GRBL link through QSerialPort to a board behind a pty that starts anew at every opening of its port. Waits are in
// real time, and each is bounded.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "app/io/wires.h"
#include "core/cnc/registry.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"

namespace stillcut::cnc {
namespace {

namespace fs = std::filesystem;

class GrblBoard : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const fs::path script = fs::path(STILLCUT_SHARED_DIR) / "cases_files/arduino.py";
    if (!fs::exists(script)) GTEST_SKIP() << "the shared board is not here";
    board_ = std::make_unique<testing::Child>(
        std::vector<std::string>{"/usr/bin/python3", script.string(), port_, GetParam()});
    ASSERT_TRUE(testing::within(Seconds(5.0), [&] { return fs::exists(port_); }));
    LinkRequest request;
    request.settings = {{"device", port_}};
    request.wires = app::makeWire;
    request.clock = &clock_;
    auto link = makeLink("grbl", request);
    ASSERT_TRUE(link.ok()) << link.error().line();
    link_ = std::move(link).value();
  }
  int startsLogged() const {
    std::ifstream log(port_ + ".log");
    int starts = 0;
    for (std::string line; std::getline(log, line);) starts += line.ends_with("RESET") ? 1 : 0;
    return starts;
  }

  testing::TemporaryFolder folder_;
  std::string port_ = folder_.file("board");
  std::unique_ptr<testing::Child> board_;
  SteadyClock clock_;
  std::unique_ptr<CncLink> link_;
};

// Opened on one thread and read on another, as a run does it.
TEST_P(GrblBoard, IsOpenedOnceAndRead) {
  const Status opened = link_->open();
  ASSERT_TRUE(opened.ok()) << opened.error().line();
  bool valid = false;
  std::thread reader([&] {
    int looks = 0;
    valid = testing::within(Seconds(5.0), [&] { return link_->read(clock_.now()).valid && ++looks > 100; });
    link_->close();
  });
  reader.join();
  EXPECT_TRUE(valid);
  EXPECT_EQ(startsLogged(), 1);
}
// A run that ends before its link thread begins, on a thread that never saw the port.
TEST_P(GrblBoard, OpenedAndNeverReadItIsLetGo) {
  ASSERT_TRUE(link_->open().ok());
  std::thread([&] { link_.reset(); }).join();
  EXPECT_TRUE(testing::within(Seconds(5.0), [&] {
    std::ifstream log(port_ + ".log");
    const std::string text(std::istreambuf_iterator<char>(log), {});
    return text.find("closed") != std::string::npos;
  }));
}
INSTANTIATE_TEST_SUITE_P(DeafFor, GrblBoard, ::testing::Values("0.4", "1.6", "3.0"));

}  // namespace
}  // namespace stillcut::cnc
