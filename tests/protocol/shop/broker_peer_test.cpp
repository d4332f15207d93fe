// stillcut-shop and a real mosquitto: whatever happens to the line, the broker and the program, a shop gets everything,
// in order, and once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/shop/real_broker.h"
#include "tests/support/shop/run_lines.h"
#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using record::TempFolder;
using testing::Child;
using testing::CutLine;
using testing::json;
using testing::RealBroker;
using testing::RunLines;
using testing::Subscriber;
using testing::within;

constexpr const char* kRoot = "works/hall1/mill3/stillcut";
constexpr Seconds kPatience{60.0};

class Shop : public ::testing::Test {
 protected:
  void SetUp() override {
    if (testing::brokerProgram().empty()) GTEST_SKIP() << testing::kNoBroker;
  }
  std::vector<std::string> words(int port, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all{STILLCUT_SHOP, "--from",   folder_ / "run.jsonl", "--root",
                                 kRoot,         "--outbox", folder_ / "box",       "--broker",
                                 "127.0.0.1",   "--port",   std::to_string(port)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  void append(const std::vector<json>& lines) {
    std::ofstream file(folder_ / "run.jsonl", std::ios::app);
    for (const json& line : lines) file << line.dump() << '\n';
  }
  // A run of `seconds`, in chatter for two of every ten.
  static std::vector<json> aRun(int seconds, std::int64_t began = testing::kBegan) {
    RunLines run(began);
    std::vector<json> lines{run.start()};
    for (int k = 0; k < seconds; ++k) {
      lines.push_back(k % 10 == 4 || k % 10 == 5 ? run.state("status", k, "chatter", 912.0)
                                                 : run.state("status", k, "stable"));
    }
    return lines;
  }
  // What came below the machine's topic but `online`, each as it came.
  static std::vector<std::uint64_t> sequences(const Subscriber& subscriber) {
    std::vector<std::uint64_t> all;
    for (const Subscriber::Heard& m : subscriber.heard()) {
      if (!m.retained && !m.topic.ends_with("/online")) all.push_back(json::parse(m.payload)["sequence"]);
    }
    return all;
  }
  static std::vector<std::uint64_t> upTo(std::uint64_t n) {
    std::vector<std::uint64_t> all(n);
    for (std::uint64_t k = 0; k < n; ++k) all[k] = k + 1;
    return all;
  }
  // Everything, in order, when what comes again is left out by its number; and only what was under way comes again.
  static void expectOnceInOrder(const std::vector<std::uint64_t>& sequences, std::uint64_t last, std::size_t repeats) {
    std::vector<std::uint64_t> once;
    std::size_t repeated = 0;
    for (const std::uint64_t n : sequences) {
      if (once.empty() || n > once.back()) {
        once.push_back(n);
      } else {
        ++repeated;
        EXPECT_GT(n + 41, once.back()) << "an old one came again";
      }
    }
    for (std::size_t k = 0; k < once.size(); ++k) {
      ASSERT_EQ(once[k], k + 1) << "not in order: after it came "
                                << ::testing::PrintToString(std::vector(
                                       once.begin() + static_cast<std::ptrdiff_t>(k),
                                       once.begin() + static_cast<std::ptrdiff_t>(std::min(k + 30, once.size()))));
    }
    EXPECT_EQ(once.size(), last);
    EXPECT_LE(repeated, repeats);
    RecordProperty("repeated", static_cast<int>(repeated));
  }
  int runToEnd(const std::vector<std::string>& arguments) {
    Child child(arguments);
    std::optional<int> status;
    within(kPatience, [&] { return (status = child.ended()).has_value(); });
    return status && WIFEXITED(*status) ? WEXITSTATUS(*status) : -1;
  }
  TempFolder folder_;
};

// The messages of a run of n seconds: meta, n features, and of every ten seconds two alarms and two states more than
// the first.
std::uint64_t messagesOf(int seconds) {
  return 1 + static_cast<std::uint64_t>(seconds + seconds / 10 * 4 + 1);
}

TEST_F(Shop, TopicsAreAsTheManualSays) {
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port());
  append(aRun(10));
  EXPECT_EQ(runToEnd(words(broker.port(), {"--until-end"})), 0);
  ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= messagesOf(10) + 2; }));
  const auto heard = subscriber.heard();
  EXPECT_EQ(heard.front().topic, std::string(kRoot) + "/online");
  EXPECT_EQ(json::parse(heard.front().payload)["online"], true);
  EXPECT_EQ(heard.back().topic, std::string(kRoot) + "/online");
  EXPECT_EQ(json::parse(heard.back().payload)["online"], false);
  std::set<std::string> topics;
  for (const auto& m : heard) {
    topics.insert(m.topic.substr(std::string(kRoot).size() + 1));
    EXPECT_EQ(json::parse(m.payload)["schema"], "stillcut-shop/1");
  }
  EXPECT_EQ(topics, (std::set<std::string>{"online", "meta", "state", "features", "event/alarm"}));
  EXPECT_EQ(sequences(subscriber), upTo(messagesOf(10)));
  // Who comes later has the newest of what is kept, and nothing else.
  const Subscriber late(broker.port(), "works/#");
  ASSERT_TRUE(within(kPatience, [&] { return late.count() >= 3; }));
  for (const auto& m : late.heard()) EXPECT_TRUE(m.retained) << m.topic;
}

TEST_F(Shop, ALineThatIsCutAtRandomLosesAndDoublesNothing) {
  constexpr int kSeconds = 700;
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port());
  append(aRun(kSeconds));
  for (const unsigned seed : {1U}) {
    CutLine line(broker.port(), seed, 300, 40'000);
    EXPECT_EQ(runToEnd(words(line.port(), {"--until-end"})), 0);
    EXPECT_GT(line.cuts(), 15);
    RecordProperty("cuts", line.cuts());
  }
  ASSERT_TRUE(within(kPatience, [&] { return sequences(subscriber).size() >= messagesOf(kSeconds); }));
  EXPECT_EQ(sequences(subscriber), upTo(messagesOf(kSeconds)));
}

// The program dies at random, twenty times. What was under way comes again with its number; by that it is told once.
TEST_F(Shop, AProgramThatIsKilledLosesNothingAndRepeatsAFewWithTheirNumbers) {
  constexpr int kKills = 20, kEach = 80, kSeconds = kKills * kEach;  // seconds
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port());
  const auto lines = aRun(kSeconds);
  std::mt19937 random(7);
  for (int k = 0; k < kKills; ++k) {
    // There is always more to tell than it may tell before it dies, however fast it is.
    append({lines.begin() + k * kEach, lines.begin() + (k + 1) * kEach});
    const std::size_t enough = subscriber.count() + 10 + random() % 90;
    Child child(words(broker.port()));
    ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= enough; }));
  }
  append({lines.begin() + kSeconds, lines.end()});
  EXPECT_EQ(runToEnd(words(broker.port(), {"--until-end"})), 0);
  const auto all = [&] {
    const auto some = sequences(subscriber);
    return std::set<std::uint64_t>(some.begin(), some.end());
  };
  ASSERT_TRUE(within(kPatience, [&] { return all().size() >= messagesOf(kSeconds); }));
  expectOnceInOrder(sequences(subscriber), messagesOf(kSeconds), kKills * 40);
}

// What a broker has handed out before it was started again may come again, with its number.
TEST_F(Shop, ABrokerThatIsAwayGetsEverythingWhenItComesBack) {
  constexpr int kSeconds = 600;
  RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port());
  const auto lines = aRun(kSeconds);
  append({lines.begin(), lines.begin() + 100});
  Child child(words(broker.port()));
  for (int part = 1; part <= 5; ++part) {
    // In the middle of what was there for it.
    ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= static_cast<std::size_t>(100 * part - 50); }));
    broker.stop();
    append({lines.begin() + 100 * part, lines.begin() + std::min(100 * (part + 1), static_cast<int>(lines.size()))});
    broker.start();
  }
  append({lines.begin() + 600, lines.end()});
  const auto all = [&] {
    const auto some = sequences(subscriber);
    return std::set<std::uint64_t>(some.begin(), some.end());
  };
  ASSERT_TRUE(within(kPatience, [&] { return all().size() >= messagesOf(kSeconds); }));
  std::uint64_t newest = 0;
  for (const std::uint64_t n : sequences(subscriber)) {
    if (n <= newest) continue;
    EXPECT_EQ(n, newest + 1);
    newest = n;
  }
  EXPECT_EQ(newest, messagesOf(kSeconds));
}

TEST_F(Shop, ADeadProgramIsOffline) {
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port(), "+/+/+/stillcut/online");
  append(aRun(3));
  {
    Child child(words(broker.port()));
    ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= 1; }));
  }
  ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= 2; }));
  EXPECT_EQ(json::parse(subscriber.heard().back().payload)["online"], false);
}

// Read-only: it asks the broker for nothing, and its file of lines is never written.
TEST_F(Shop, TakesNoCommand) {
  const RealBroker broker(folder_ / "", "allow_anonymous true\nlog_type all\n");
  const Subscriber subscriber(broker.port());
  append(aRun(3));
  const auto before = std::filesystem::file_size(folder_ / "run.jsonl");
  Child child(words(broker.port()));
  ASSERT_TRUE(within(kPatience, [&] { return sequences(subscriber).size() >= messagesOf(3); }));
  std::ifstream log(folder_ / "mosquitto.log");
  std::string text((std::istreambuf_iterator<char>(log)), {});
  EXPECT_NE(text.find("Received PUBLISH from stillcut-shop"), std::string::npos);
  EXPECT_EQ(text.find("Received SUBSCRIBE from stillcut-shop"), std::string::npos);
  EXPECT_EQ(std::filesystem::file_size(folder_ / "run.jsonl"), before);
}

// The list is that of packaging/shop, as a shop copies it.
TEST_F(Shop, AUserAndAListOfRightsHold) {
  const std::string rights = std::string(STILLCUT_SOURCE_DIR) + "/packaging/shop/mosquitto/acl";
  std::ofstream(folder_ / "passwords") << "";
  for (const char* user : {"mill3", "historian"}) {
    ASSERT_EQ(std::system(("mosquitto_passwd -b " + folder_ / "passwords" + " " + user + " secret").c_str()), 0);
  }
  std::ofstream(folder_ / "word") << "secret\n";
  const RealBroker broker(
      folder_ / "", "allow_anonymous false\npassword_file " + folder_ / "passwords" + "\nacl_file " + rights + "\n");
  const Subscriber subscriber(broker.port(), "works/#", "historian", "secret");
  // Who only looks can be neither this machine nor one of his own name.
  for (const char* topic : {"works/hall1/historian/stillcut/state", "works/hall1/mill3/stillcut/state"}) {
    const std::string publish = "mosquitto_pub -h 127.0.0.1 -u historian -P secret -q 1 -m forged -t ";
    std::system((publish + topic + " -p " + std::to_string(broker.port()) + " >/dev/null 2>&1").c_str());
  }
  append(aRun(3));
  EXPECT_EQ(runToEnd(words(broker.port(), {"--until-end", "--user", "mill3", "--password-file", folder_ / "word"})), 0);
  const auto heard = [&] { return subscriber.heard(); };
  ASSERT_TRUE(within(kPatience, [&] { return heard().size() >= messagesOf(3) + 2; }));  // online, twice
  for (const Subscriber::Heard& m : heard()) {
    EXPECT_NE(m.payload, "forged") << m.topic;
    EXPECT_THAT(m.topic, ::testing::StartsWith(kRoot));
  }
}

// A certificate for 127.0.0.1 that vouches for itself: NAME.crt and NAME.key.
bool makeCertificate(const std::string& path) {
  return std::system(("openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=shop -addext "
                      "subjectAltName=IP:127.0.0.1 -keyout " +
                      path + ".key -out " + path + ".crt 2>/dev/null")
                         .c_str()) == 0;
}
void replaceAll(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

// mosquitto with the configuration of packaging/shop, as a shop copies it; only its places are others.
class TlsShop : public Shop {
 protected:
  void SetUp() override {
    Shop::SetUp();
    if (IsSkipped()) return;
    for (const char* name : {"broker", "ca", "foreign"}) ASSERT_TRUE(makeCertificate(folder_ / name));
    std::filesystem::copy_file(folder_ / "broker.crt", folder_ / "ca.crt",
                               std::filesystem::copy_options::overwrite_existing);
    const std::string from = std::string(STILLCUT_SOURCE_DIR) + "/packaging/shop/mosquitto/";
    std::filesystem::copy_file(from + "acl", folder_ / "stillcut.acl");
    std::ofstream(folder_ / "stillcut.passwords") << "";
    for (const char* user : {"mill3", "historian"}) {
      const std::string add = "mosquitto_passwd -b " + folder_ / "stillcut.passwords" + " " + user + " secret";
      ASSERT_EQ(std::system(add.c_str()), 0);
    }
    std::ofstream(folder_ / "word") << "secret\n";
    std::ifstream file(from + "stillcut.conf");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    const int port = testing::freePort();
    replaceAll(text, "listener 8883", "listener " + std::to_string(port) + " 127.0.0.1");
    for (const char* place : {"/etc/mosquitto/certs/", "/etc/mosquitto/", "/var/lib/mosquitto/"}) {
      replaceAll(text, place, folder_ / "");
    }
    broker_ = std::make_unique<RealBroker>(folder_ / "", testing::WholeConfiguration{text, port});
    subscriber_ = std::make_unique<Subscriber>(port, "works/#", "historian", "secret", folder_ / "ca.crt");
    append(aRun(3));
  }
  std::vector<std::string> asMill3(const std::vector<std::string>& more) const {
    auto all = words(broker_->port(), {"--user", "mill3", "--password-file", folder_ / "word"});
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::unique_ptr<RealBroker> broker_;
  std::unique_ptr<Subscriber> subscriber_;
};

TEST_F(TlsShop, TellsABrokerThatItsAuthorityVouchesFor) {
  EXPECT_EQ(runToEnd(asMill3({"--ca", folder_ / "ca.crt", "--until-end"})), 0);
  ASSERT_TRUE(within(kPatience, [&] { return sequences(*subscriber_).size() >= messagesOf(3); }));
  EXPECT_EQ(sequences(*subscriber_), upTo(messagesOf(3)));
}

// Somebody else's broker, and one that is spoken to in the clear: nothing is told, the reason is said, the run is kept.
TEST_F(TlsShop, TellsNothingToABrokerThatNobodyVouchesFor) {
  for (const std::vector<std::string>& how : {std::vector<std::string>{"--ca", folder_ / "foreign.crt"}, {}}) {
    auto line = asMill3(how);
    std::string shell = "exec";
    for (const std::string& word : line) shell += " '" + word + "'";
    std::filesystem::remove(folder_ / "said");
    Child child({"/bin/sh", "-c", shell + " 2>" + folder_ / "said"});
    ASSERT_TRUE(within(kPatience, [&] {
      std::ifstream said(folder_ / "said");
      const std::string text((std::istreambuf_iterator<char>(said)), {});
      return text.find(how.empty() ? "--ca" : "its certificate is vouched for by none of") != std::string::npos;
    })) << (how.empty() ? "in the clear" : "foreign");
  }
  EXPECT_TRUE(subscriber_->heard().empty());
  EXPECT_EQ(runToEnd(asMill3({"--ca", folder_ / "ca.crt", "--until-end"})), 0);
  EXPECT_TRUE(within(kPatience, [&] { return sequences(*subscriber_).size() >= messagesOf(3); }));
}

}  // namespace
}  // namespace stillcut::shop
