// A profile that somebody wrote by hand is saved without losing a word of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/config/profile.h"
#include "core/config/toml_edit.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/config/example_params.h"

namespace stillcut::config {
namespace {

using namespace example;

constexpr std::string_view kByHand = R"(# Mill 3, in the corner.   Ask Ada.
version = 1
machine = 'Mill 3'   # as on the plate

[tool]
label = "T12 # short"
  teeth = 0x4        # not 3
diameter_mm = 12.0

# what the program says
[cut]
speed_rpm = 8_800
[[channels]]   # nose
name = "x"
quantity = "acceleration"
scale = 98.0665
[[channels]]
# the microphone hangs loose
name = "mic"
quantity = "sound"
[source]
id = "audio"
settings = { device = "hw:1", rate_hz = 48000 }   # not 44100
[control]
detector = "energy-ratio"
[parameters.energy-ratio]
threshold = 0.35   # tried on 12 March
band = "auto"
)";

class SavedProfile : public testing::Test {
 protected:
  std::string content(const std::string& name) {
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // Saves `written` after `change`, and holds that the file means what was to be saved.
  template <typename Change>
  std::string saved(std::string_view written, const Change& change) {
    const std::string path = folder_.file("p.toml", written);
    auto profile = loadProfile(path, catalog());
    EXPECT_TRUE(profile) << profile.error().line();
    if (!profile) return {};
    change(*profile);
    EXPECT_TRUE(saveProfile(*profile, catalog(), path).ok());
    const auto again = loadProfile(path, catalog());
    EXPECT_TRUE(again) << again.error().line();
    if (again) {
      EXPECT_EQ(profileText(*again, catalog()), profileText(*profile, catalog()));
    }
    return content("p.toml");
  }
  static std::string with(std::string_view from, std::string_view to, std::string_view text = kByHand) {
    std::string changed(text);
    EXPECT_NE(changed.find(from), std::string::npos) << from;
    return changed.replace(changed.find(from), from.size(), to);
  }

  record::TempFolder folder_;
};

TEST_F(SavedProfile, NothingChangedIsNotWritten) {
  EXPECT_EQ(saved(kByHand, [](Profile&) {}), kByHand);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "p.toml.bak"));
}

TEST_F(SavedProfile, OnlyTheValueChangesAndTheOneBeforeIsKept) {
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.cut.nominalSpeed = Rpm(9000.0); }), with("8_800", "9000"));
  EXPECT_EQ(content("p.toml.bak"), kByHand);
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.cut.teeth = 5; }), with("0x4", "5"));
  EXPECT_EQ(
      saved(kByHand, [](Profile& p) { ASSERT_TRUE(p.params.set(catalog(), kThreshold.key, "0.4", "test").ok()); }),
      with("0.35", "0.4"));
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.cut.tool = "T13"; }), with("\"T12 # short\"", "\"T13\""));
}

TEST_F(SavedProfile, WhatIsNewComesBehindItsKin) {
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.cut.nominalFeed = fromMmPerMin(1408.0); }),
            with("8_800\n", "8_800\nfeed_mm_min = 1408\n"));
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.operatorName = "Ada"; }), with("plate\n", "plate\noperator = \"Ada\"\n"));
  EXPECT_EQ(saved(kByHand, [](Profile& p) { ASSERT_TRUE(p.params.set(catalog(), kLimit.key, "115", "test").ok()); }),
            std::string(kByHand) + "\n[parameters.gate]\nhighest-speed-override = 115\n");
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.source.settings["gain"] = "2"; }),
            with("hw:1\", rate_hz = 48000 }", "hw:1\", gain = 2, rate_hz = 48000 }"));
  const std::string noEnd(kByHand.substr(0, kByHand.size() - 1));
  EXPECT_EQ(saved(noEnd, [](Profile& p) { ASSERT_TRUE(p.params.set(catalog(), kLimit.key, "115", "test").ok()); }),
            std::string(kByHand) + "\n[parameters.gate]\nhighest-speed-override = 115\n");
}

TEST_F(SavedProfile, WhatGoesTakesItsLineButNotItsComment) {
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.params = ParamSet(); }),
            with("threshold = 0.35   # tried on 12 March\nband = \"auto\"\n", "# tried on 12 March\n"));
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.cut.toolDiameter = Metres(); }), with("diameter_mm = 12.0\n", ""));
}

TEST_F(SavedProfile, ChannelsAreKnownByTheirNames) {
  const std::string first = "[[channels]]   # nose\nname = \"x\"\nquantity = \"acceleration\"\nscale = 98.0665\n";
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.cut.channels.erase(p.cut.channels.begin()); }), with(first, "# nose\n"));
  EXPECT_EQ(saved(kByHand, [](Profile& p) { p.cut.channels[1].place = "door"; }),
            with("\"sound\"\n", "\"sound\"\nplace = \"door\"\n"));
  const auto added = [](Profile& p) {
    ChannelInfo y = p.cut.channels[0];
    y.name = "y";
    p.cut.channels.insert(p.cut.channels.begin() + 1, y);
  };
  EXPECT_EQ(saved(kByHand, added),
            with("98.0665\n",
                 "98.0665\n\n[[channels]]\nname = \"y\"\nquantity = \"acceleration\"\nscale = 98.0665\n"
                 "axis = \"\"\n"));
  // In another order, by their places.
  const std::string turned = saved(kByHand, [](Profile& p) { std::swap(p.cut.channels[0], p.cut.channels[1]); });
  EXPECT_NE(turned.find("# the microphone hangs loose"), std::string::npos);
}

TEST_F(SavedProfile, EverySpellingOfATableTakesTheChange) {
  constexpr std::string_view kDotted =
      "version = 1\nmachine = \"M\"\ntool.teeth = 4 # four\ncut.\"speed_rpm\" = 1e4\n"
      "channels = [\n  # the one\n  { name = 'x', quantity = 'force' }, ]\n[parameters]\nenergy-ratio.threshold = "
      "0.3\n";
  EXPECT_EQ(saved(kDotted, [](Profile& p) { p.cut.toolDiameter = Metres(0.012); }),
            with("# four\n", "# four\ntool.diameter_mm = 12\n", kDotted));
  EXPECT_EQ(saved(kDotted, [](Profile& p) { p.cut.nominalSpeed = Rpm(9000.0); }), with("1e4", "9000", kDotted));
  EXPECT_EQ(saved(kDotted, [](Profile& p) { ASSERT_TRUE(p.params.set(catalog(), kHarmonics.key, "8", "test").ok()); }),
            with("0.3\n", "0.3\nenergy-ratio.harmonics = 8\n", kDotted));
  saved(kDotted, [](Profile& p) { p.cut.channels[0].scale = 3.0; });
  EXPECT_NE(content("p.toml").find("# four"), std::string::npos);
}

TEST_F(SavedProfile, LinesEndAsTheyDid) {
  std::string dos;
  for (const char c : kByHand) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::string after = saved(dos, [](Profile& p) { p.operatorName = "Ada"; });
  EXPECT_NE(after.find("plate\r\noperator = \"Ada\"\r\n"), std::string::npos);
  EXPECT_EQ(std::count(after.begin(), after.end(), '\n'), std::count(after.begin(), after.end(), '\r'));
}

// A file that is no profile is still kept as it was.
TEST_F(SavedProfile, WhatCannotBeReadIsReplacedAndKept) {
  const std::string path = folder_.file("p.toml", "this is = = no TOML\n");
  Profile profile;
  profile.cut.machine = "M";
  ASSERT_TRUE(saveProfile(profile, catalog(), path).ok());
  EXPECT_EQ(content("p.toml"), profileText(profile, catalog()));
  EXPECT_EQ(content("p.toml.bak"), "this is = = no TOML\n");
}

TEST(TomlEdit, EndsOnAnyText) {
  for (const char* odd :
       {"", "=", "[", "[[", "a", "a=", "\"", "'''", "a = \"\\", "[a", "]", "a = [", "a = {", "\xef\xbb\xbf"}) {
    EXPECT_NE(editedToml(odd, "", "b = 1\n").find("b = 1"), std::string::npos) << odd;
  }
}

}  // namespace
}  // namespace stillcut::config
