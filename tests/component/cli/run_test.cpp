// run: the monitor without a screen, as people and as programs read it.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <thread>
#include <utility>

#include "core/session/file/session_reader.h"
#include "tests/component/cli/in_folder.h"
#include "tests/component/cli/made_files.h"
#include "tests/support/bounded_wait.h"
#include "tests/support/child.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;

constexpr const char* kMachine =
    "version = 1\nmachine = \"Mill 3\"\n[tool]\nlabel = \"T12\"\nteeth = 4\ndiameter_mm = 12.0\n[cut]\n"
    "speed_rpm = 8500.0\nfeed_mm_min = 2720.0\n[source]\nid = \"simulated\"\n[source.settings]\n"
    "scenario = \"cut.toml\"\n[link]\nid = \"simulated\"\n[control]\ndetector = \"energy-ratio\"\n"
    "strategy = \"lobe-center\"\n";

std::vector<json> linesOf(const std::string& text) {
  std::vector<json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(json::parse(line, nullptr, false));
  return lines;
}

std::vector<json> ofType(const std::vector<json>& lines, const std::string& type) {
  std::vector<json> some;
  for (const json& line : lines) {
    if (line.value("type", "") == type) some.push_back(line);
  }
  return some;
}

class Run : public InFolder {
 protected:
  void SetUp() override {
    writeScenario(folder_ / "cut.toml");
    folder_.file("machine.toml", kMachine);
  }
  Outcome monitor(std::vector<std::string> more, const char* profile = "machine.toml") {
    std::vector<std::string> arguments{"run", "--profile", profile, "--flights", "flights"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runCli(folder_ / "", arguments);
  }
};

TEST_F(Run, JsonLinesAreCountedAndHaveTheirFields) {
  const Outcome ran = monitor({"--json", "--status", "--mode", "advise"});
  EXPECT_EQ(ran.exitCode, 0) << ran.err;
  const std::vector<json> lines = linesOf(ran.out);
  ASSERT_GE(lines.size(), 4U) << ran.out;
  std::int64_t before = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_TRUE(lines[i].is_object()) << ran.out;
    EXPECT_EQ(lines[i]["schema"], "stillcut-cli/1");
    EXPECT_EQ(lines[i]["command"], "run");
    EXPECT_EQ(lines[i]["sequence"], i + 1);
    EXPECT_GT(lines[i]["utc_ms"].get<std::int64_t>(), before - 1000);
    before = lines[i]["utc_ms"];
  }
  EXPECT_EQ(lines.front()["type"], "start");
  EXPECT_EQ(lines.front()["machine_name"], "Mill 3");
  EXPECT_EQ(lines.front()["mode"], "advise");
  EXPECT_EQ(lines.front()["channels"][0]["unit"], "m/s\u00b2");
  EXPECT_EQ(lines.back()["type"], "end");
  EXPECT_EQ(lines.back()["exit_code"], 0);
  EXPECT_GE(lines.back()["length_s"], 1.9);
  EXPECT_GE(lines.back()["alarms"], 1);

  const std::vector<json> status = ofType(lines, "status");
  ASSERT_GE(status.size(), 1U);
  EXPECT_EQ(status.back()["mode"], "advise");
  EXPECT_GT(status.back()["in_cut_s"], 0.5);
  EXPECT_LE(status.back()["judged_s"], status.back()["in_cut_s"]);
  EXPECT_EQ(status.back()["machine"]["programmed_rpm"], 8500.0);
  EXPECT_FALSE(status.back()["overrides"]["in_force"]);
}

TEST_F(Run, ChatterIsALineWithFrequencyAndAdvice) {
  const std::vector<json> changes = ofType(linesOf(monitor({"--json"}).out), "change");
  ASSERT_FALSE(changes.empty());
  EXPECT_THAT(changes.front()["state"], testing::AnyOf("air", "not-judged"));
  EXPECT_TRUE(changes.front()["frequency_hz"].is_null()) << "unknown is no 0";
  const auto heard = std::find_if(changes.begin(), changes.end(), [](const json& c) {
    return c["state"] == "chatter" && c["advice"]["kind"] == "speed";
  });
  ASSERT_NE(heard, changes.end());
  EXPECT_NEAR((*heard)["frequency_hz"], 937.0, 25.0);
  EXPECT_GT((*heard)["energy_ratio"], 0.1);
  EXPECT_LT((*heard)["advice"]["speed_rpm"], 8500.0);
  EXPECT_THAT((*heard)["advice"]["sentence"].get<std::string>(), testing::HasSubstr("rpm"));
}

TEST_F(Run, LinesForPeopleHaveTheTimeOfDay) {
  const Outcome ran = monitor({"--status"});
  EXPECT_THAT(ran.out, testing::ContainsRegex("[0-9][0-9]:[0-9][0-9]:[0-9][0-9]\\.[0-9]{3}  chatter at 9[0-9][0-9] Hz, "
                                              "energy ratio [0-9.]+, .*Advice: go to [0-9]+ rpm"));
  EXPECT_THAT(ran.out, testing::ContainsRegex("  = [a-z-]+.*, in the cut [0-9]+ s, judged [0-9]+ s"));
  EXPECT_THAT(ran.out, testing::HasSubstr("ends: the source has no more samples"));
}

TEST_F(Run, AutoIsForProfilesThatAllowIt) {
  const Outcome refused = monitor({"--mode", "auto"});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.err, testing::HasSubstr("does not allow Auto"));
  folder_.file("auto.toml", std::string(kMachine) + "allow_auto = true\n");
  const std::vector<json> lines = linesOf(monitor({"--mode", "auto", "--json"}, "auto.toml").out);
  const bool moved = std::any_of(lines.begin(), lines.end(), [](const json& line) {
    return line["type"] == "change" && line["mode"] == "auto" && line["overrides"]["in_force"] == true;
  });
  EXPECT_TRUE(moved);
}

// A wire on which some samples come, and then nothing though it stays open.
class SilentWire {
 public:
  SilentWire() : listener_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(listener_, 1), 0);
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    sender_ = std::thread([this] {
      peer_ = accept(listener_, nullptr, nullptr);
      std::string samples;
      for (int i = 0; i < 4000; ++i) samples += std::to_string(i % 7) + ".5\n";
      (void)send(peer_, samples.data(), samples.size(), MSG_NOSIGNAL);
    });
  }
  ~SilentWire() {
    shutdown(listener_, SHUT_RDWR);  // should nobody have come
    sender_.join();
    close(peer_);
    close(listener_);
  }
  int port() const { return port_; }

 private:
  int listener_, peer_ = -1, port_ = 0;
  std::thread sender_;
};

TEST_F(Run, SamplesThatStopAreALineAndAnExitCode) {
  SilentWire wire;
  folder_.file("wire.toml",
               "version = 1\nmachine = \"M\"\n[[channels]]\nname = \"x\"\nquantity = \"acceleration\"\n"
               "[source]\nid = \"tcp\"\n[source.settings]\nport = " +
                   std::to_string(wire.port()) + "\nhost = \"127.0.0.1\"\nrate_hz = 8000\nformat = \"text\"\n");
  const Outcome ran = monitor({"--json", "--give-up", "1.5"}, "wire.toml");
  EXPECT_EQ(ran.exitCode, 3) << ran.out << ran.err;
  const std::vector<json> lines = linesOf(ran.out);
  const std::vector<json> stopped = ofType(lines, "stopped");
  ASSERT_EQ(stopped.size(), 1U) << ran.out;
  EXPECT_GE(stopped[0]["silent_s"], 1.0);
  EXPECT_EQ(lines.back()["exit_code"], 3);
  EXPECT_EQ(lines.back()["sentence"], "no samples come any more");
}

TEST_F(Run, TheServiceManagerIsToldOfBeginLifeAndEnd) {
  const std::string place = folder_ / "notify";
  const int manager = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  ASSERT_LT(place.size(), sizeof address.sun_path);
  std::copy(place.begin(), place.end(), address.sun_path);
  ASSERT_EQ(bind(manager, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  setenv("NOTIFY_SOCKET", place.c_str(), 1);
  setenv("WATCHDOG_USEC", "600000", 1);
  const Outcome ran = monitor({"--seconds", "1"});
  unsetenv("NOTIFY_SOCKET");
  unsetenv("WATCHDOG_USEC");
  EXPECT_EQ(ran.exitCode, 0) << ran.err;
  std::vector<std::string> told;
  char text[256];
  for (ssize_t n = 0; (n = recv(manager, text, sizeof text, 0)) > 0;)
    told.emplace_back(text, static_cast<std::size_t>(n));
  close(manager);
  ASSERT_GE(told.size(), 4U);
  EXPECT_EQ(told.front(), "READY=1");
  EXPECT_THAT(told[1], testing::StartsWith("WATCHDOG=1\nSTATUS="));
  EXPECT_EQ(told.back(), "STOPPING=1");
}

// Whoever should read what it says does not, or has gone. A pipe of this test: what stands at its far end.
class Unheard : public Run {
 protected:
  void SetUp() override {
    Run::SetUp();
    ASSERT_EQ(mkfifo((folder_ / "said").c_str(), 0600), 0);
    reader_ = open((folder_ / "said").c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader_, 0);
  }
  void TearDown() override { close(reader_); }
  cnc::testing::Child start() const {
    const std::string demo = STILLCUT_SOURCE_DIR "/resources/scenarios/demo.toml";
    folder_.file("long.toml", std::regex_replace(std::string(kMachine), std::regex("cut.toml"), demo));
    return cnc::testing::Child(
        {"sh", "-c",
         std::string("cd '") + (folder_ / "") +
             "' && exec " STILLCUT_CLI
             " run --profile long.toml --flights flights --record cut.h5 --json --status >said"});
  }
  // It has ended, well and with its recording closed.
  void expectOrderlyEnd(cnc::testing::Child& program) {
    std::optional<int> status;
    ASSERT_TRUE(cnc::testing::within(Seconds(20.0), [&] { return (status = program.ended()).has_value(); }));
    EXPECT_TRUE(WIFEXITED(*status) && WEXITSTATUS(*status) == 0) << *status;
    const auto repaired = record::repairSession(folder_ / "cut.h5");
    ASSERT_TRUE(repaired.ok()) << repaired.error().line();
    EXPECT_FALSE(*repaired) << "it was not closed";
  }
  bool recording() { return std::filesystem::exists(folder_ / "cut.h5"); }

  int reader_ = -1;
};

TEST_F(Unheard, AConsoleThatTakesNoMoreHoldsUpNoEnd) {
  const std::string full(4096, 'x');
  while (write(reader_, full.data(), full.size()) > 0) continue;
  for (char x = 'x'; write(reader_, &x, 1) > 0;) continue;
  cnc::testing::Child program = start();
  ASSERT_TRUE(cnc::testing::within(Seconds(20.0), [&] { return recording(); }));
  program.signal(SIGTERM);
  expectOrderlyEnd(program);
}

TEST_F(Unheard, AReaderThatHasGoneEndsItInOrder) {
  cnc::testing::Child program = start();
  std::array<char, 4096> said{};
  ASSERT_TRUE(cnc::testing::within(Seconds(20.0), [&] { return read(reader_, said.data(), said.size()) > 0; }));
  close(std::exchange(reader_, -1));
  expectOrderlyEnd(program);
}

}  // namespace
}  // namespace stillcut::cli_test
