// stillcut-hal's server on real sockets of this host: who is served, who is turned away.
#include "app/hal/line_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <memory>
#include <vector>

#include "app/hal/local_user.h"
#include "tests/support/child.h"
#include "tests/support/virtual_clock.h"

namespace stillcut::hal {
namespace {

class Caller {
 public:
  explicit Caller(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<std::uint16_t>(port));
    ::inet_pton(AF_INET, "127.0.0.1", &place.sin_addr);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&place), sizeof place), 0);
  }
  ~Caller() { ::close(socket_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;
  void say(const char* line) const { ::send(socket_, line, std::char_traits<char>::length(line), MSG_NOSIGNAL); }
  // What has come within `ms`; "gone": hung up.
  std::string hear(int ms = 200) const {
    pollfd entry{socket_, POLLIN, 0};
    if (::poll(&entry, 1, ms) <= 0) return {};
    std::array<char, 256> bytes{};
    const ssize_t n = ::recv(socket_, bytes.data(), bytes.size(), 0);
    return n > 0 ? std::string(bytes.data(), static_cast<std::size_t>(n)) : "gone";
  }

 private:
  int socket_;
};

class LineServerTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(server_.listen("127.0.0.1", 0).ok()); }
  std::unique_ptr<Caller> call() {
    auto caller = std::make_unique<Caller>(server_.port());
    turn();
    return caller;
  }
  void turn() {
    for (int i = 0; i < 10; ++i) server_.serve(std::chrono::milliseconds(1), handlers_);
  }

  test::VirtualClock clock_{instantFromNs(1'000'000'000)};
  LineServer server_{clock_};
  std::vector<int> gone_;
  LineServer::Handlers handlers_{[](int client, std::string_view line) -> std::string_view {
                                   static std::string answer;
                                   answer = std::to_string(client) + " " + std::string(line) + "\n";
                                   return answer;
                                 },
                                 [this](int client) { gone_.push_back(client); }};
};

TEST_F(LineServerTest, EachClientHasItsOwnAnswersAndNoneEvictsAnother) {
  std::vector<std::unique_ptr<Caller>> callers;
  for (std::size_t i = 0; i < LineServer::kClients; ++i) callers.push_back(call());
  for (const auto& caller : callers) caller->say("hello\n");
  turn();
  for (std::size_t i = 0; i < callers.size(); ++i) EXPECT_EQ(callers[i]->hear(), std::to_string(i + 1) + " hello\n");
  EXPECT_EQ(call()->hear(), "gone") << "one too many";
  EXPECT_TRUE(gone_.empty());
  callers[1].reset();
  turn();
  EXPECT_EQ(gone_, std::vector<int>{2});
  const auto next = call();
  next->say("in its place\n");
  turn();
  EXPECT_EQ(next->hear(), "5 in its place\n");
}

// A pulled cable hangs nobody up: who says nothing for a second gives way to who comes.
TEST_F(LineServerTest, TheOneThatHasFallenSilentGivesWay) {
  std::vector<std::unique_ptr<Caller>> callers;
  for (std::size_t i = 0; i < LineServer::kClients; ++i) callers.push_back(call());
  clock_.advance(Seconds(1.5));
  for (const std::size_t i : {0U, 1U, 3U}) callers[i]->say("here\n");
  turn();
  const auto fresh = call();
  fresh->say("me\n");
  turn();
  EXPECT_EQ(fresh->hear(), "5 me\n");
  EXPECT_EQ(gone_, std::vector<int>{3});
  EXPECT_EQ(callers[2]->hear(), "gone");
}

TEST_F(LineServerTest, EndlessLineIsDroppedAndTheServerGoesOn) {
  const auto caller = call();
  const std::string endless(4000, 'x');
  for (int i = 0; i < 20; ++i) {
    caller->say(endless.c_str());
    turn();
  }
  caller->say("\nstill there\n");
  turn();
  EXPECT_NE(caller->hear().find("still there"), std::string::npos);
}

// The override of a machine is its own user's to move. As root the caller is another user; as anybody else the server
// is another user's, which comes to the same.
TEST_F(LineServerTest, AnotherUsersProgramIsHungUpOnAndTakesNobodysPlace) {
  constexpr uid_t kNobody = 65534;
  const bool root = ::geteuid() == 0;
  LineServer server(clock_, root ? 0 : ::geteuid() + 1);
  ASSERT_TRUE(server.listen("127.0.0.1", 0).ok());
  int lines = 0;
  const LineServer::Handlers counting{[&](int, std::string_view) -> std::string_view { return ++lines, ""; },
                                      [](int) {}};
  for (std::size_t k = 0; k <= LineServer::kClients; ++k) {
    const pid_t child = ::fork();
    if (child == 0) {
      if (root && ::setuid(kNobody) != 0) ::_exit(2);
      const Caller caller(server.port());
      caller.say("set 50 50 1 100 100\n");
      ::_exit(caller.hear(5000) == "gone" ? 0 : 1);
    }
    int status = -1;
    while (::waitpid(child, &status, WNOHANG) == 0) server.serve(std::chrono::milliseconds(1), counting);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(lines, 0);
  if (!root) return;
  const Caller own(server.port());
  own.say("here\n");
  for (int i = 0; i < 10; ++i) server.serve(std::chrono::milliseconds(1), counting);
  EXPECT_EQ(lines, 1);
}

// A line of the kernel's list, as it was seen for a client that had closed its end: user 0, whoever it was.
TEST(LocalUser, AnEndThatIsNoLongerHeldIsNobodys) {
  const cnc::testing::TemporaryFolder folder;
  std::ofstream(folder.file("tcp"))
      << "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when retrnsmt   uid  timeout inode\n"
         "   0: 0100007F:E5A0 0100007F:80C5 04 00000000:00000000 01:00000A6E 00000000     0        0 0 3\n"
         "   1: 0100007F:E5A1 0100007F:1F90 01 00000000:00000000 00:00000000 00000000     0        0 76 1\n"
         "   2: 0100007F:E5A1 0100007F:80C5 01 00000000:00000000 00:00000000 00000000  1000        0 77 1\n";
  sockaddr_in peer{};
  sockaddr_in here{};
  here.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  here.sin_port = htons(0x80C5);
  peer.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  peer.sin_port = htons(0xE5A0);
  EXPECT_EQ(localUser(peer, here, folder.file("tcp")), std::nullopt);
  peer.sin_port = htons(0xE5A1);
  // Root has a connection from the same port, to another end.
  EXPECT_EQ(localUser(peer, here, folder.file("tcp")), uid_t{1000});
  peer.sin_port = htons(0xE5A2);
  EXPECT_EQ(localUser(peer, here, folder.file("tcp")), std::nullopt);
  EXPECT_TRUE(isLoopback(peer));
  peer.sin_addr.s_addr = htonl(0xC0A80105);
  EXPECT_FALSE(isLoopback(peer));
}

}  // namespace
}  // namespace stillcut::hal
