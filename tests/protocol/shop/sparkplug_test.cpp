// Sparkplug B: payloads against an independent decoder (Google's Protocol Buffers in Python), and the edge node at a
// real broker.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/shop/sparkplug_payload.h"
#include "tests/support/shop/real_broker.h"
#include "tests/support/shop/run_lines.h"
#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using record::TempFolder;
using sparkplug::DataType;
using sparkplug::Metric;
using sparkplug::Payload;
using testing::Child;
using testing::CutLine;
using testing::json;
using testing::RealBroker;
using testing::RunLines;
using testing::Subscriber;
using testing::within;

constexpr Seconds kPatience{40.0};
const std::string kDecoder =
    std::string("/usr/bin/python3 ") + STILLCUT_SOURCE_DIR + "/tests/protocol/shop/sparkplug_b.py ";

bool decoderIsThere() {
  return std::system((kDecoder + "rebirth >/dev/null 2>&1").c_str()) == 0;
}
std::string hex(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    std::array<char, 3> two;
    std::snprintf(two.data(), two.size(), "%02x", static_cast<unsigned char>(c));
    text += two.data();
  }
  return text;
}
std::string fromHex(const std::string& text) {
  std::string bytes;
  for (std::size_t k = 0; k + 1 < text.size(); k += 2)
    bytes.push_back(static_cast<char>(std::stoi(text.substr(k, 2), nullptr, 16)));
  return bytes;
}
std::string outputOf(const std::string& command) {
  std::string text;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> bytes;
  for (std::size_t n = 0; (n = std::fread(bytes.data(), 1, bytes.size(), pipe)) > 0;) text.append(bytes.data(), n);
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return text;
}
std::vector<json> decoded(const TempFolder& folder, const std::vector<std::string>& payloads) {
  std::string lines;
  for (const std::string& payload : payloads) lines += hex(payload) + "\n";
  std::istringstream told(outputOf(kDecoder + "decode < " + folder.file("payloads", lines)));
  std::vector<json> all;
  for (std::string line; std::getline(told, line);) all.push_back(json::parse(line));
  return all;
}

class Sparkplug : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!decoderIsThere()) GTEST_SKIP() << "python3-protobuf is not installed: no independent decoder";
  }
  TempFolder folder_;
};

TEST_F(Sparkplug, EveryTypeOfValueIsReadAsItWasMeant) {
  Payload payload{1'795'000'000'123, 255, {}};
  const auto add = [&](const char* name, std::uint64_t alias, DataType type, auto value) {
    Metric m;
    m.name = name;
    m.alias = alias;
    m.hasAlias = alias > 0;
    m.type = type;
    m.utcMs = 1'795'000'000'000 + static_cast<std::int64_t>(alias);
    m.historical = alias == 2;
    m.value = value;
    payload.metrics.push_back(m);
  };
  add("a double", 1, DataType::Double, -1.5e-300);
  add("", 2, DataType::String, std::string("Fräser ∅12"));
  add("yes", 3, DataType::Boolean, true);
  add("much", 400, DataType::UInt64, std::uint64_t{0xFFFF'FFFF'FFFF'FFFFU});
  add("nothing", 5, DataType::Double, std::monostate{});
  add("bdSeq", 0, DataType::UInt64, std::uint64_t{0});
  const json told = decoded(folder_, {encode(payload)}).at(0);
  EXPECT_EQ(told["timestamp"], 1'795'000'000'123);
  EXPECT_EQ(told["seq"], 255);
  const json& m = told["metrics"];
  EXPECT_EQ(m[0]["name"], "a double");
  EXPECT_EQ(m[0]["double_value"], -1.5e-300);
  EXPECT_EQ(m[0]["datatype"], 10);
  EXPECT_FALSE(m[1].contains("name"));
  EXPECT_EQ(m[1]["string_value"], "Fräser ∅12");
  EXPECT_EQ(m[1]["is_historical"], true);
  EXPECT_EQ(m[2]["boolean_value"], true);
  EXPECT_EQ(m[3]["long_value"], 0xFFFF'FFFF'FFFF'FFFFU);
  EXPECT_EQ(m[3]["alias"], 400);
  EXPECT_EQ(m[4]["is_null"], true);
  EXPECT_FALSE(m[5].contains("alias"));
  EXPECT_EQ(m[5]["long_value"], 0);
}

TEST_F(Sparkplug, ARequestOfAnotherProgramIsUnderstoodAndNothingElseIs) {
  const std::string request = fromHex(outputOf(kDecoder + "rebirth"));
  EXPECT_TRUE(sparkplug::asksForRebirth(request));
  for (std::size_t k = 0; k < request.size(); ++k) EXPECT_FALSE(sparkplug::asksForRebirth(request.substr(0, k))) << k;
  Metric no;
  no.name = sparkplug::kRebirth;
  no.type = DataType::Boolean;
  no.value = false;
  EXPECT_FALSE(sparkplug::asksForRebirth(encode(Payload{1, 0, {no}})));
  no.name = "Node Control/Reboot";
  no.value = true;
  EXPECT_FALSE(sparkplug::asksForRebirth(encode(Payload{1, 0, {no}})));
  std::mt19937 random(3);
  for (int k = 0; k < 20'000; ++k) {
    std::string noise(random() % 60, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    EXPECT_FALSE(sparkplug::asksForRebirth(noise));
  }
}

// The edge node, as a host application that only knows the specification follows it.
class SparkplugNode : public Sparkplug {
 protected:
  void SetUp() override {
    Sparkplug::SetUp();
    if (!IsSkipped() && testing::brokerProgram().empty()) GTEST_SKIP() << testing::kNoBroker;
  }
  void write(int seconds) {
    std::ofstream file(folder_ / "run.jsonl");
    RunLines run;
    file << run.start().dump() << '\n';
    for (int k = 0; k < seconds; ++k)
      file << (k % 10 < 8 ? run.state("status", k, "stable") : run.state("status", k, "chatter", 912.0)).dump() << '\n';
  }
  std::vector<std::string> words(int port) const {
    return {STILLCUT_SHOP,   "--from",   folder_ / "run.jsonl", "--root", "w/h/mill3/stillcut", "--outbox",
            folder_ / "box", "--broker", "127.0.0.1",           "--port", std::to_string(port), "--sparkplug",
            "Works/mill3"};
  }
  struct Told {
    std::string type;
    json payload;
  };
  std::vector<Told> told(const Subscriber& subscriber) {
    std::vector<std::string> payloads;
    const auto heard = subscriber.heard();
    payloads.reserve(heard.size());
    for (const auto& m : heard) payloads.push_back(m.payload);
    const auto all = decoded(folder_, payloads);
    std::vector<Told> some;
    for (std::size_t k = 0; k < heard.size(); ++k)
      some.push_back({heard[k].topic.substr(14, 6) == "NBIRTH" ? "NBIRTH" : heard[k].topic.substr(14, 5), all[k]});
    return some;
  }
};

TEST_F(SparkplugNode, BirthDataRebirthAndDeath) {
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port(), "spBv1.0/#");
  write(20);
  {
    Child child(words(broker.port()));
    ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= 20; }));
    mosquitto* host = mosquitto_new("host", true, nullptr);
    ASSERT_EQ(mosquitto_connect(host, "127.0.0.1", broker.port(), 20), MOSQ_ERR_SUCCESS);
    const std::string request = fromHex(outputOf(kDecoder + "rebirth"));
    mosquitto_publish(host, nullptr, "spBv1.0/Works/NCMD/mill3", static_cast<int>(request.size()), request.data(), 1,
                      false);
    const auto births = [&] {
      int n = 0;
      for (const auto& m : subscriber.heard()) n += m.topic.find("/NBIRTH/") != std::string::npos ? 1 : 0;
      return n;
    };
    ASSERT_TRUE(within(kPatience, [&] {
      mosquitto_loop(host, 2, 1);
      return births() >= 2;
    }));
    mosquitto_destroy(host);
  }
  ASSERT_TRUE(within(kPatience, [&] { return subscriber.heard().back().topic.find("/NDEATH/") != std::string::npos; }));
  std::map<std::uint64_t, std::string> names;
  int expected = -1;
  json bdSeq;
  std::uint64_t sequence = 0;
  for (const Told& m : told(subscriber)) {
    const json& metrics = m.payload["metrics"];
    if (m.type == "NBIRTH") {
      EXPECT_EQ(m.payload["seq"], 0);
      expected = 1;
      for (const json& metric : metrics) {
        ASSERT_TRUE(metric.contains("name") && metric.contains("datatype"));
        if (metric.contains("alias")) names[metric["alias"]] = metric["name"];
        if (metric["name"] == "bdSeq") bdSeq = metric["long_value"];
      }
      EXPECT_GT(names.size(), 30U);
    } else if (m.type == "NDATA") {
      EXPECT_EQ(m.payload["seq"], expected);
      expected = (expected + 1) % 256;
      for (const json& metric : metrics) {
        ASSERT_TRUE(names.contains(metric["alias"]));
        if (names[metric["alias"]] != "Stillcut/sequence") continue;
        EXPECT_EQ(metric["long_value"], sequence + 1);
        sequence = metric["long_value"];
      }
    } else if (m.type == "NDEAT") {
      EXPECT_TRUE(m.payload["seq"].is_null());
      EXPECT_EQ(metrics[0]["name"], "bdSeq");
      EXPECT_EQ(metrics[0]["long_value"], bdSeq);
    }
  }
  EXPECT_GE(sequence, 24U);
}

// The will of the first, late, must not be taken for the death of the second.
TEST_F(SparkplugNode, ANewProcessIsBornWithANumberOfItsOwn) {
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port(), "spBv1.0/+/NBIRTH/#");
  write(1);
  for (const std::size_t births : {1U, 2U}) {
    Child child(words(broker.port()));
    ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= births; }));
  }
  std::vector<json> numbers;
  for (const Told& birth : told(subscriber)) numbers.push_back(birth.payload["metrics"][0]["long_value"]);
  EXPECT_THAT(numbers, ::testing::ElementsAre(1, 2));
}

// All was delivered and has left the outbox: the birth of the next process tells it all the same.
TEST_F(SparkplugNode, ANewProcessIsBornWithWhatWasToldBefore) {
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port(), "spBv1.0/+/NBIRTH/#");
  write(10);
  for (const std::size_t births : {1U, 2U}) {
    std::vector<std::string> arguments = words(broker.port());
    arguments.push_back("--until-end");
    if (births == 2U) arguments.pop_back();  // nothing is left to be told: it would end at once
    Child child(arguments);
    ASSERT_TRUE(within(kPatience, [&] { return subscriber.count() >= births; }));
    if (births == 2U) break;
    ASSERT_TRUE(within(kPatience, [&] { return child.ended().has_value(); }));
  }
  std::map<std::string, json> metrics;
  const std::vector<Told> births = told(subscriber);
  for (const json& metric : births.back().payload["metrics"]) metrics[metric["name"]] = metric;
  EXPECT_EQ(metrics["Meta/tool"]["string_value"], "T12");
  EXPECT_TRUE(metrics["State/state"].contains("string_value"));
  EXPECT_TRUE(metrics["Features/in_cut_s"].contains("double_value"));
}

TEST_F(SparkplugNode, ALineThatIsCutAtRandomLosesNothing) {
  constexpr int kSeconds = 1000;
  const RealBroker broker(folder_ / "");
  const Subscriber subscriber(broker.port(), "spBv1.0/#");
  write(kSeconds);
  CutLine line(broker.port(), 5, 8'000, 60'000);
  std::vector<std::string> arguments = words(line.port());
  arguments.push_back("--until-end");
  Child child(arguments);
  std::optional<int> status;
  ASSERT_TRUE(within(kPatience, [&] { return (status = child.ended()).has_value(); }));
  EXPECT_EQ(*status, 0);
  EXPECT_GT(line.cuts(), 5);
  ASSERT_TRUE(within(kPatience, [&] { return subscriber.heard().back().topic.find("/NDEATH/") != std::string::npos; }));
  std::map<std::uint64_t, std::string> names;
  std::set<std::uint64_t> sequences;
  std::uint64_t newest = 0;
  for (const Told& m : told(subscriber)) {
    for (const json& metric : m.payload["metrics"]) {
      if (metric.contains("name") && metric.contains("alias")) names[metric["alias"]] = metric["name"];
      if (m.type != "NDATA" || names[metric["alias"]] != "Stillcut/sequence") continue;
      sequences.insert(metric["long_value"].get<std::uint64_t>());
      newest = std::max(newest, metric["long_value"].get<std::uint64_t>());
    }
  }
  EXPECT_EQ(sequences.size(), newest);
  EXPECT_GT(newest, 1000U + 200U);
}

}  // namespace
}  // namespace stillcut::shop
