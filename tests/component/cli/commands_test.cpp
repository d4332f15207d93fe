// The commands around recordings and cases: convert, lobes, devices, info, help.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/component/cli/in_folder.h"
#include "tests/component/cli/made_files.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;

class Commands : public InFolder {};

// Lines of the shared cases' own form: a cut, and a case for the lobes.
constexpr const char* kMode =
    R"("modes": [{"f": 922, "zeta": 0.011, "m": 0.03993, "d": [1, 0]}], "Kt": 6e8, "Kn": 2e8)";

TEST_F(Commands, ConvertKeepsSamplesAndAppliesTheScale) {
  writeSound(folder_ / "cut.wav", {cutSignal(true)});
  run({"convert", "cut.wav", "cut.csv", "--quantity", "acceleration", "--scale", "50"});
  run({"convert", "cut.csv", "back.wav"});
  const json info = json::parse(run({"info", "back.wav", "--json"}), nullptr, false);
  EXPECT_EQ(info["rate_hz"], kRate);
  EXPECT_EQ(info["frames"], static_cast<int>(kLength * kRate));
  std::istringstream table(content("cut.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_THAT(line, testing::AllOf(testing::StartsWith("Time (s),"), testing::HasSubstr("(m/s")));
  std::getline(table, line);
  const double first = std::stod(line.substr(line.find(',') + 1));
  EXPECT_NEAR(first, 50.0 * cutSignal(true).front(), 1e-6);
}

TEST_F(Commands, ConvertMakesAScenarioOfACut) {
  folder_.file("case.json", std::string("{\"name\": \"mine\", ") + kMode +
                                R"(, "teeth": 2, "aD": 0.5, "up": true, "spindle_rpm": 6000, "feed_per_tooth_m": 1e-4,
                     "duration_s": 0.6, "fs": 25600, "process": {"depth_segments":
                     [{"from_s": 0, "to_s": 0.6, "from_mm": 0.1, "to_mm": 0.1}]}})");
  run({"convert", "case.json", "case.toml"});
  const json answer = json::parse(run({"simulate", "case.toml", "--strategy", "monitor", "--json"}), nullptr, false);
  EXPECT_EQ(answer["scenario"], "mine");
}

TEST_F(Commands, ConvertMakesALobeCaseWithTheSameLimits) {
  folder_.file("case.json",
               std::string("{\"name\": \"slot\", \"N\": 2, \"aD\": 1.0, \"up\": true, \"wmax_mm\": 4, ") + kMode + "}");
  run({"convert", "case.json", "case.toml"});
  run({"lobes", "case.toml", "--speeds", "5000:6000:500", "--out", "toml.csv"});
  run({"lobes", "case.json", "--speeds", "5000:6000:500", "--out", "json.csv"});
  EXPECT_EQ(content("toml.csv"), content("json.csv"));
  std::istringstream table(content("toml.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line, "speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz");
  std::getline(table, line);
  EXPECT_THAT(line, testing::StartsWith("5000,0,0.40862780"));  // of the shared reference
  EXPECT_THAT(content("toml.csv"), testing::HasSubstr("\n6000,0,"));
}

TEST_F(Commands, LobesOfEveryMethodHaveTheSameColumns) {
  folder_.file("case.json",
               std::string("{\"name\": \"slot\", \"N\": 2, \"aD\": 1.0, \"up\": true, \"wmax_mm\": 4, ") + kMode + "}");
  for (const char* method : {"zoa", "sdm", "exact"}) {
    SCOPED_TRACE(method);
    const std::string table =
        run({"lobes", "case.json", "--method", method, "--k", "20", "--max-depth", "3", "--speeds", "5000:5100:100"});
    EXPECT_THAT(table, testing::StartsWith("speed_rpm,crossing,depth_mm,before,after,kind,frequency_hz\n5000,0,0."));
  }
}

TEST_F(Commands, DevicesListsSourcesAndLinks) {
  const std::string list = run({"devices"});
  EXPECT_THAT(list, testing::ContainsRegex("sources\n  simulated +[A-Z]"));
  EXPECT_THAT(list, testing::ContainsRegex("links\n  simulated +[A-Z]"));
  for (const char* kind : {"audio-class", "Comedi", "industrial I/O", "serial ports", "a loss of less than 30 ms"}) {
    EXPECT_THAT(list, testing::HasSubstr(kind));
  }
}

TEST_F(Commands, DevicesSaysWhereNoIndustrialIoAnswers) {
  const Outcome absent = runCli(folder_ / "", {"devices", "--iio", "ip:127.0.0.2"});
  if (absent.exitCode == 0) GTEST_SKIP() << "this build has no libiio";
  EXPECT_EQ(absent.exitCode, 3);
  EXPECT_THAT(absent.err, testing::StartsWith("stillcut-cli: 'uri' = 'ip:127.0.0.2': does not answer"));
}

TEST_F(Commands, DevicesTriesALinkStepByStep) {
  const Outcome absent = runCli(folder_ / "", {"devices", "--try", "grbl", "--with", "device=no-such-port"});
  EXPECT_EQ(absent.exitCode, 3);
  EXPECT_THAT(absent.out, testing::StartsWith("no "));
  EXPECT_THAT(absent.out, testing::HasSubstr("no-such-port"));
  const Outcome unknown = runCli(folder_ / "", {"devices", "--try", "grlb"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_THAT(unknown.err, testing::HasSubstr("grbl, modbus"));
  EXPECT_EQ(runCli(folder_ / "", {"devices", "--save"}).exitCode, 2);
}

TEST_F(Commands, InfoSaysWhatARecordingHolds) {
  writeSound(folder_ / "cut.wav", {cutSignal(true), cutSignal(false)}, SF_FORMAT_WAV | SF_FORMAT_PCM_24);
  const std::string text = run({"info", "cut.wav"});
  EXPECT_THAT(text, testing::HasSubstr("12800 Hz"));
  EXPECT_THAT(text, testing::HasSubstr("channel 1"));
  EXPECT_THAT(text, testing::HasSubstr("assumed"));  // a sound file does not say what was measured
}

TEST_F(Commands, HelpIsNoError) {
  EXPECT_THAT(run({"--help"}), testing::HasSubstr("analyze"));
  EXPECT_THAT(run({"analyze", "--help"}), testing::HasSubstr("--speed-log"));
  EXPECT_THAT(run({"--version"}), testing::StartsWith("stillcut-cli "));
}

}  // namespace
}  // namespace stillcut::cli_test
