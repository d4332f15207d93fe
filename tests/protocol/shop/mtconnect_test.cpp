// The adapter as an MTConnect agent meets it: SHDR lines over TCP.
#include "app/shop/mtconnect_adapter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/bounded_wait.h"
#include "tests/support/delay_proxy.h"
#include "tests/support/shop/run_lines.h"

namespace stillcut::shop {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::RunLines;

// An agent: connects, says a word, and hears.
class Agent {
 public:
  explicit Agent(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const sockaddr_in place = cnc::testing::loopback(port);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0)
      throw std::runtime_error("no");
  }
  ~Agent() { ::close(socket_); }
  void say(const std::string& words) const { ::send(socket_, words.data(), words.size(), MSG_NOSIGNAL); }
  // As much of it as the line takes; false: the line is over.
  bool sayWhatGoes(const std::string& words) const {
    return ::send(socket_, words.data(), words.size(), MSG_NOSIGNAL | MSG_DONTWAIT) >= 0 || errno == EAGAIN;
  }
  // All that was heard, once it holds `words`.
  std::string hear(MtConnectAdapter& adapter, const std::string& words) {
    cnc::testing::within(Seconds(20.0), [&] {
      adapter.turn();
      std::array<char, 4096> bytes;
      const ssize_t n = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (n > 0) text_.append(bytes.data(), static_cast<std::size_t>(n));
      over_ = n == 0;
      return over_ || text_.find(words) != std::string::npos;
    });
    return std::exchange(text_, {});
  }
  bool over() const { return over_; }

 private:
  int socket_;
  std::string text_;
  bool over_ = false;
};

class MtConnect : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(adapter_.listen("0").ok()); }
  MtConnectAdapter adapter_;
  RunLines run_;
};

TEST_F(MtConnect, AnswersAPingWithItsPeriod) {
  Agent agent(adapter_.port());
  agent.say("* PING\n");
  EXPECT_EQ(agent.hear(adapter_, "\n"), "* PONG 10000\n");
}

TEST_F(MtConnect, ChatterIsACondition) {
  Agent agent(adapter_.port());
  agent.say("* PING\n");
  agent.hear(adapter_, "PONG");
  adapter_.hear(run_.start());
  adapter_.hear(run_.state("change", 1.0, "stable"));
  EXPECT_THAT(agent.hear(adapter_, "|chatter|"), HasSubstr("2026-11-18T11:06:41.000Z|chatter|NORMAL||||\n"));
  adapter_.hear(run_.state("change", 2.0, "onset", 912.0));
  EXPECT_THAT(agent.hear(adapter_, "|chatter|"), HasSubstr("|chatter|WARNING|chatter|0.02||onset at 912 Hz\n"));
  adapter_.hear(run_.state("change", 3.0, "chatter", 912.0));
  EXPECT_THAT(agent.hear(adapter_, "|chatter|"), HasSubstr("|chatter|FAULT|chatter|0.6||chatter at 912 Hz\n"));
  adapter_.hear(run_.state("change", 4.0, "not-judged"));
  EXPECT_THAT(agent.hear(adapter_, "|chatter|"), HasSubstr("|chatter|UNAVAILABLE||||the sensor is at its limit\n"));
}

TEST_F(MtConnect, WhoComesLaterHasEverythingAndThenTheChanges) {
  adapter_.hear(run_.start());
  adapter_.hear(run_.state("status", 1.0, "stable"));
  Agent agent(adapter_.port());
  const std::string all = agent.hear(adapter_, "|tool|T12\n");
  for (const char* item : {"|avail|AVAILABLE\n", "|spindle_speed|8498\n", "|spindle_programmed|8500\n", "|feed|45\n",
                           "|feed_override|90\n", "|spindle_override|100\n", "|chatter|NORMAL||||\n"})
    EXPECT_THAT(all, HasSubstr(item));
  adapter_.hear(run_.state("status", 2.0, "stable"));
  adapter_.hear(run_.state("status", 3.0, "air"));
  EXPECT_THAT(agent.hear(adapter_, "AIR"), Not(HasSubstr("spindle")));
  adapter_.hear(run_.line("end", 4.0));
  EXPECT_THAT(agent.hear(adapter_, "|spindle_speed|"), HasSubstr("|avail|UNAVAILABLE\n"));
}

TEST_F(MtConnect, WordsThatAreTheFormatsOwnDoNotBreakIt) {
  Agent agent(adapter_.port());
  adapter_.turn();
  adapter_.hear(run_.start("T|1\n2"));
  EXPECT_THAT(agent.hear(adapter_, "|tool|"), HasSubstr("|tool|T 1 2\n"));
}

TEST_F(MtConnect, AnAgentThatFloodsOrNeverReadsIsLetGo) {
  Agent flooding(adapter_.port()), other(adapter_.port());
  flooding.say(std::string(100'000, 'x'));
  flooding.hear(adapter_, "never said");
  EXPECT_TRUE(flooding.over());
  other.say("* PING\n");
  EXPECT_THAT(other.hear(adapter_, "PONG"), HasSubstr("PONG"));
}

TEST_F(MtConnect, AnAgentThatAsksWithoutPauseAndNeverReadsIsLetGo) {
  Agent asking(adapter_.port()), other(adapter_.port());
  std::string pings;
  for (int k = 0; k < 5000; ++k) pings += "* PING\n";
  EXPECT_TRUE(cnc::testing::within(Seconds(20.0), [&] {
    const bool goes = asking.sayWhatGoes(pings);
    adapter_.turn();
    return !goes;
  }));
  other.say("* PING\n");
  EXPECT_THAT(other.hear(adapter_, "PONG"), HasSubstr("PONG"));
}

TEST(MtConnectPlace, IsAPortOrAnAddressWithOne) {
  for (const char* wrong : {"", "x", "70000", "-1", "host:7878", "1.2.3:1"}) {
    MtConnectAdapter adapter;
    EXPECT_FALSE(adapter.listen(wrong).ok()) << wrong;
  }
  MtConnectAdapter first, second;
  ASSERT_TRUE(first.listen("127.0.0.1:0").ok());
  EXPECT_FALSE(second.listen(std::to_string(first.port())).ok() && first.port() == second.port());
}

}  // namespace
}  // namespace stillcut::shop
