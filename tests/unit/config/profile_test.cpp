#include "core/config/profile.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"
#include "tests/unit/config/example_params.h"

namespace stillcut::config {
namespace {

using namespace example;

constexpr std::string_view kMill3 = R"(version = 1
machine = "Mill 3"
[tool]
label = "T12 D12 Z4"
teeth = 4
diameter_mm = 12
[cut]
speed_rpm = 8800
feed_mm_min = 1408
[[channels]]
name = "x"
quantity = "acceleration"
scale = 98.0665
axis = "x"
[[channels]]
name = "mic"
quantity = "sound"
[source]
id = "audio"
[source.settings]
device = "hw:1"
rate_hz = 48000
[link]
id = "linuxcnc"
[control]
detector = "energy-ratio"
fallback = "spectral"
strategy = "lobe-center"
allow_auto = true
[recording]
folder = "kept"
job = "Housing 7"
[parameters.energy-ratio]
threshold = 0.35
band = "auto"
[parameters.gate]
highest-speed-override = 115
)";

const KnownIds kKnown{
    {"audio", "simulated"}, {"linuxcnc", "simulated"}, {"energy-ratio", "spectral"}, {"monitor", "lobe-center"}, {}};

std::string lineOf(std::string_view content) {
  const Result<Profile> profile = parseProfile(content, "p.toml", catalog(), kKnown);
  return profile ? "" : profile.error().line();
}
// kMill3 with one piece of text exchanged.
std::string lineWith(std::string_view from, std::string_view to) {
  std::string content(kMill3);
  const std::size_t at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return lineOf(content.replace(at, from.size(), to));
}

TEST(Profile, ReadsInSiUnits) {
  const Result<Profile> read = parseProfile(kMill3, "p.toml", catalog(), kKnown);
  ASSERT_TRUE(read.ok()) << read.error().line();
  const Profile& p = *read;
  EXPECT_EQ(p.cut.machine, "Mill 3");
  EXPECT_EQ(p.cut.teeth, 4);
  EXPECT_DOUBLE_EQ(p.cut.toolDiameter.value, 0.012);
  EXPECT_DOUBLE_EQ(p.cut.nominalSpeed.value, 8800.0);
  EXPECT_NEAR(p.cut.nominalFeed.value, 1.408 / 60.0, 1e-12);
  ASSERT_EQ(p.cut.channels.size(), 2u);
  EXPECT_EQ(p.cut.channels[0].quantity, SensorQuantity::Acceleration);
  EXPECT_DOUBLE_EQ(p.cut.channels[0].scale, 98.0665);
  EXPECT_EQ(p.cut.channels[1].quantity, SensorQuantity::Sound);
  EXPECT_DOUBLE_EQ(p.cut.channels[1].scale, 1.0);
  EXPECT_EQ(p.source.id, "audio");
  EXPECT_EQ(p.source.settings.at("device"), "hw:1");
  EXPECT_EQ(p.source.settings.at("rate_hz"), "48000");
  EXPECT_EQ(p.recording.folder, "kept");
  EXPECT_EQ(p.recording.job, "Housing 7");
  EXPECT_EQ(p.fallback, "spectral");
  EXPECT_TRUE(p.allowAuto);
  EXPECT_DOUBLE_EQ(p.params.real(kThreshold), 0.35);
  EXPECT_TRUE(p.params.isSet(kBand));
  EXPECT_DOUBLE_EQ(p.params.real(kLimit), 115.0);
}

TEST(Profile, WhatIsSavedIsWhatIsLoadedAndSavesTheSameAgain) {
  const Result<Profile> first = parseProfile(kMill3, "p.toml", catalog());
  ASSERT_TRUE(first.ok());
  const record::TempFolder folder;
  const std::string path = folder / "profile-test.toml";
  ASSERT_TRUE(saveProfile(*first, catalog(), path).ok());
  const Result<Profile> second = loadProfile(path, catalog(), kKnown);
  ASSERT_TRUE(second.ok()) << second.error().line();
  EXPECT_EQ(profileText(*second, catalog()), profileText(*first, catalog()));
  EXPECT_EQ(second->params.values().size(), 3u);
  EXPECT_DOUBLE_EQ(second->cut.toolDiameter.value, 0.012);
  EXPECT_EQ(second->source.settings, first->source.settings);
  EXPECT_TRUE(second->allowAuto);
}

TEST(Profile, NamesTheModelOfItsCut) {
  std::string content(kMill3);
  content.insert(content.find("feed_mm_min"), "model = \"cut.toml\"\ndepth_mm = 1.5\n");
  const Result<Profile> p = parseProfile(content, "p.toml", catalog(), kKnown);
  ASSERT_TRUE(p.ok()) << p.error().line();
  EXPECT_EQ(p->model, "cut.toml");
  EXPECT_DOUBLE_EQ(p->depth.value, 1.5e-3);
  EXPECT_NE(profileText(*p, catalog()).find("model = \"cut.toml\"\ndepth_mm = 1.5\n"), std::string::npos);
}

TEST(Profile, KeepsHowItsToolIsClamped) {
  std::string content(kMill3);
  content.insert(content.find("teeth = 4"), "holder = \"HSK63 ER32\"\nstick_out_mm = 48\n");
  const Result<Profile> p = parseProfile(content, "p.toml", catalog(), kKnown);
  ASSERT_TRUE(p.ok()) << p.error().line();
  EXPECT_EQ(p->holder, "HSK63 ER32");
  EXPECT_DOUBLE_EQ(p->stickOut.value, 48e-3);
  EXPECT_NE(profileText(*p, catalog()).find("holder = \"HSK63 ER32\"\nstick_out_mm = 48"), std::string::npos);
  EXPECT_NE(lineWith("teeth = 4", "stick_out_mm = -1").find("stick_out_mm"), std::string::npos);
}

TEST(Profile, KeepsThePitchOfItsToolWhereItIsUneven) {
  std::string content(kMill3);
  content.insert(content.find("teeth = 4"), "pitch_deg = [85.5, 94.5, 85.5, 94.5]\n");
  const Result<Profile> p = parseProfile(content, "p.toml", catalog(), kKnown);
  ASSERT_TRUE(p.ok()) << p.error().line();
  EXPECT_EQ(p->pitch, (std::vector<double>{85.5, 94.5, 85.5, 94.5}));
  const Result<Profile> again = parseProfile(profileText(*p, catalog()), "p.toml", catalog(), kKnown);
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_EQ(again->pitch, p->pitch);
  content.replace(content.find("85.5, 94.5, 85.5, 94.5"), 22, "90, 90, 90, 90");
  EXPECT_TRUE(parseProfile(content, "p.toml", catalog(), kKnown)->pitch.empty()) << "as if nothing had been said";
}

TEST(Profile, TheLeastProfileIsCautious) {
  const Result<Profile> p = parseProfile("version = 1\nmachine = \"M\"\n", "p.toml", catalog(), kKnown);
  ASSERT_TRUE(p.ok()) << p.error().line();
  EXPECT_FALSE(p->allowAuto);
  EXPECT_EQ(p->strategy, "monitor");
  EXPECT_EQ(p->detector, "energy-ratio");
  EXPECT_EQ(p->cut.teeth, 0);
  EXPECT_EQ(p->link.id, "");
}

TEST(ProfileErrors, AreOneLineWithFileLineAndCause) {
  EXPECT_EQ(lineWith("teeth", "teeht"), "p.toml:5: unknown key 'tool.teeht' (did you mean 'teeth'?)");
  EXPECT_EQ(lineWith("teeth = 4", "teeth = 0"), "p.toml:5: 'tool.teeth' is out of range: 0 (allowed: 1 to 64)");
  EXPECT_EQ(lineWith("8800", "0"), "p.toml:8: 'cut.speed_rpm' is out of range: 0 (allowed: 1 to 200000)");
  EXPECT_EQ(lineWith("8800", "nan"), "p.toml:8: 'cut.speed_rpm' is not a finite number");
  EXPECT_EQ(lineWith("teeth = 4", "teeth = 4\npitch_deg = [100, 80, 180]"),
            "p.toml:6: 'tool.pitch_deg' needs one angle per tooth");
  EXPECT_EQ(lineWith("teeth = 4", "teeth = 4\npitch_deg = [100, 80, 100, 90]"),
            "p.toml:6: 'tool.pitch_deg' does not go once around (angles above zero, 360 degrees together)");
  EXPECT_EQ(lineWith("98.0665", "0"), "p.toml:13: 'channels.scale' is zero (SI units per device unit)");
  EXPECT_EQ(lineWith("\"sound\"", "\"loud\"").substr(0, 45), "p.toml:17: 'channels.quantity' is unknown: 'l");
  EXPECT_EQ(lineWith("fallback = \"spectral\"", "fallback = \"spektral\""),
            "p.toml:27: 'control.fallback' is unknown: 'spektral' (did you mean 'spectral'?)");
  EXPECT_EQ(lineWith("\"linuxcnc\"", "\"x\""), "p.toml:24: 'link.id' is unknown: 'x' (choices: linuxcnc, simulated)");
  EXPECT_EQ(lineWith("allow_auto = true", "allow_auto = 1"),
            "p.toml:29: 'control.allow_auto' is neither true nor false");
  EXPECT_EQ(lineWith("threshold", "treshold"),
            "p.toml:34: unknown key 'energy-ratio.treshold' (did you mean 'energy-ratio.threshold'?)");
  EXPECT_EQ(lineWith("0.35", "3.5"), "p.toml:34: energy-ratio.threshold: 3.5 is out of range (allowed: 0 to 1)");
  EXPECT_EQ(lineWith("0.35", "nan"),
            "p.toml:34: energy-ratio.threshold: the value is not a finite number (allowed: 0 to 1)");
  EXPECT_EQ(lineWith("0.35", "[1]"), "p.toml:34: 'parameters.energy-ratio.threshold' is not a single value");
}

TEST(ProfileVersion, NewerIsRefusedAndMissingIsAsked) {
  EXPECT_EQ(lineWith("version = 1", "version = 2"),
            "p.toml:1: profile version 2 is newer than this program (it reads up to version 1)");
  EXPECT_EQ(lineWith("version = 1\n", ""), "p.toml:1: 'version' is missing");
}

TEST(ProfileVersion, OldParameterNamesAreReadInOldProfilesOnly) {
  constexpr std::string_view kOld = "version = 1\nmachine = \"M\"\n[parameters.er]\nlimit = 0.4\n";
  const ParamRename inOld[] = {{1, "er.limit", "energy-ratio.threshold"}};
  const Result<Profile> read = parseProfile(kOld, "p.toml", catalog(), kKnown, inOld);
  ASSERT_TRUE(read.ok()) << read.error().line();
  EXPECT_DOUBLE_EQ(read->params.real(kThreshold), 0.4);
  const ParamRename inOlder[] = {{0, "er.limit", "energy-ratio.threshold"}};
  EXPECT_FALSE(parseProfile(kOld, "p.toml", catalog(), kKnown, inOlder).ok());
}

// 100 mV/g into a converter whose full scale is 5 V: 50 g are full scale.
TEST(Profile, AChannelIsToldByItsDataSheets) {
  const std::string sheet =
      "version = 1\nmachine = 'm'\n[[channels]]\nname = 'x'\nquantity = 'acceleration'\nsensitivity_mv = 100\nvolts = "
      "5\n"
      "coupling = 'iepe'\nplace = 'spindle nose'\n[[channels]]\nname = 'mic'\nquantity = 'sound'\nsensitivity_mv = "
      "50\n";
  auto read = parseProfile(sheet, "p.toml", catalog());
  ASSERT_TRUE(read) << read.error().line();
  EXPECT_NEAR(read->cut.channels[0].scale, 50.0 * 9.80665, 1e-9);
  EXPECT_NEAR(read->cut.channels[1].scale, 20.0, 1e-12);
  const auto again = parseProfile(profileText(*read, catalog()), "q.toml", catalog());
  ASSERT_TRUE(again) << again.error().line();
  EXPECT_EQ(again->cut.channels[0].scale, read->cut.channels[0].scale);
  EXPECT_EQ(again->cut.channels[0].place, "spindle nose");
  EXPECT_EQ(again->cut.channels[0].coupling, "iepe");

  const std::pair<const char*, const char*> wrong[] = {
      {"sensitivity_mv = 0", "'channels.sensitivity_mv' is zero"},
      {"sensitivity_mv = 1\nscale = 2", "'channels.scale' is given beside"},
      {"sensitivity_mv = 1\nvolts = 0", "'channels.volts' is zero"},
      {"coupling = 'usb'", "'channels.coupling' is unknown: 'usb'"}};
  for (const auto& [keys, what] : wrong) {
    const std::string line =
        lineOf(std::string("version = 1\nmachine = 'm'\n[[channels]]\nname = 'x'\nquantity = 'force'\n") + keys);
    EXPECT_NE(line.find(what), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace stillcut::config
