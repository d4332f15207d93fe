// Every shared recording is read and judged to its end. Skipped, saying so, where the folder is absent. What is found
// is printed; how right it is has its own tests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;

struct Recording {
  const char* file;
  std::vector<std::string> told;
};

const std::vector<Recording>& recordings() {
  static const std::vector<Recording> kAll{
      {"hurco_end_mill/EBI_F20IN_T100_D0p125IN_4000RPM.csv", {"--teeth", "4", "--speed", "4000"}},
      {"hurco_end_mill/EBI_F20IN_T75_D0p125IN_4000RPM.csv", {"--teeth", "4", "--speed", "4000"}},
      {"hurco_end_mill/EBI_T50_0p25IN_6900RPM.csv", {"--teeth", "4", "--speed", "6900"}},
      {"hurco_end_mill/EBI_T25_0p25IN_6900RPM.csv", {"--teeth", "4", "--speed", "6900"}},
      {"hurco_end_mill/EBI_T100_0p375IN_7000RPMto6000RPM.csv", {"--teeth", "3"}},
      {"face_mill_audio/Chatter.wav", {"--teeth", "6", "--speed", "1655"}},
      {"face_mill_audio/Stable.wav", {"--teeth", "6", "--speed", "4489"}},
      {"face_mill_audio/Idle Sound.wav", {"--teeth", "6"}},
      {"slot_force/6-n6000f300ap3ae25.csv", {"--teeth", "2", "--speed", "6000"}},
      {"slot_force/6-n6000f900ap3ae25.csv", {"--teeth", "2", "--speed", "6000"}},
      {"lmas_milling_audio/audio_T2503", {"--rate", "8000", "--quantity", "sound"}},
      {"lmas_milling_audio/accel_T2503", {"--rate", "1000", "--quantity", "acceleration"}},
      {"turning_force_lvm/f416_a100.lvm", {"--speed", "1060", "--quantity", "force"}},
  };
  return kAll;
}

// "1.4 onset 645 Hz, 1.6 chatter 640 Hz": where the state changes.
std::string course(const json& events) {
  std::string text;
  std::string last = "air";
  for (const json& event : events) {
    const std::string state = event["state"];
    if (state == last) continue;
    last = state;
    char part[64];
    const double frequency = event["frequency_hz"];
    std::snprintf(part, sizeof part, "%s%.2f %s", text.empty() ? "" : ", ", event["t"].get<double>(), state.c_str());
    text += part;
    if (frequency > 0.0) text += " " + std::to_string(static_cast<int>(frequency)) + " Hz";
  }
  return text;
}

TEST(SharedRecordings, AreAllJudgedToTheirEnd) {
  const std::filesystem::path shared = std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings";
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << "not here: " << shared;
  const record::TempFolder folder;
  for (const Recording& recording : recordings()) {
    SCOPED_TRACE(recording.file);
    std::vector<std::string> arguments{"analyze", (shared / recording.file).string(), "--json", "--events", "e.json"};
    arguments.insert(arguments.end(), recording.told.begin(), recording.told.end());
    const Outcome outcome = runCli(folder / "", arguments);
    EXPECT_EQ(outcome.err, "");
    const json answer = json::parse(outcome.out, nullptr, false);
    ASSERT_TRUE(answer.is_object());
    ASSERT_EQ(outcome.exitCode, answer["answer"]["finding"] == "chatter" ? 1 : 0) << outcome.err;
    std::ifstream file(folder / "e.json");
    const json events = json::parse(file, nullptr, false);
    ASSERT_TRUE(events.is_array());
    ASSERT_FALSE(events.empty());
    EXPECT_LE(events.back()["t"], answer["length_s"].get<double>() + 1e-6);
    const json& found = answer["detectors"][0];
    std::printf("%-40s alarms %d, in alarm %.2f of %.2f s, %.0f Hz: %s\n",
                std::filesystem::path(recording.file).filename().c_str(),
                found["alarms"].is_null() ? -1 : found["alarms"].get<int>(), found["alarm_time_s"].get<double>(),
                answer["length_s"].get<double>(), found["frequency_hz"].get<double>(), course(events).c_str());
  }
}

}  // namespace
}  // namespace stillcut::cli_test
