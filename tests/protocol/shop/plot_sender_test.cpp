// Numbers for PlotJuggler: one datagram a state.
#include "app/shop/plot_sender.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "tests/support/delay_proxy.h"
#include "tests/support/shop/run_lines.h"

namespace stillcut::shop {
namespace {

using testing::RunLines;

TEST(PlotSender, SendsTheNumbersOfAStateWithTheirTime) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  sockaddr_in place = cnc::testing::loopback(0);
  socklen_t size = sizeof place;
  ASSERT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&place), size), 0);
  ASSERT_EQ(::getsockname(socket, reinterpret_cast<sockaddr*>(&place), &size), 0);
  PlotSender sender;
  ASSERT_TRUE(sender.open("127.0.0.1:" + std::to_string(ntohs(place.sin_port))).ok());
  RunLines run;
  sender.hear(run.start());
  sender.hear(run.state("status", 1.5, "chatter", 912.0));
  std::array<char, 4096> bytes;
  const ssize_t n = ::recv(socket, bytes.data(), bytes.size(), 0);
  ASSERT_GT(n, 0);
  const auto told = nlohmann::json::parse(std::string(bytes.data(), static_cast<std::size_t>(n)));
  EXPECT_DOUBLE_EQ(told["timestamp"].get<double>(), 1e-3 * testing::kBegan + 1.5);
  EXPECT_EQ(told["stillcut"]["state_number"], 3);
  EXPECT_EQ(told["stillcut"]["frequency_hz"], 912.0);
  EXPECT_EQ(told["stillcut"]["machine"]["actual_rpm"], 8498.0);
  EXPECT_FALSE(told["stillcut"].contains("state"));                        // PlotJuggler draws numbers
  EXPECT_LT(::recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT), 0);  // the start was none
  ::close(socket);
}

TEST(PlotSender, NeedsAnAddress) {
  for (const char* wrong : {"", "9870", "host:9870", "127.0.0.1:0", "127.0.0.1:x"}) {
    PlotSender sender;
    EXPECT_FALSE(sender.open(wrong).ok()) << wrong;
  }
}

}  // namespace
}  // namespace stillcut::shop
