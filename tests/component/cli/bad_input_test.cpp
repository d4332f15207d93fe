// What is wrong is one line that names file, place and cause; exit code 2; no file is left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include "tests/component/cli/made_files.h"
#include "tests/component/cli/program.h"
#include "tests/support/temp_folder.h"

namespace stillcut::cli_test {
namespace {

struct Mistake {
  std::vector<std::string> arguments;
  const char* says;  // part of the line
};

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    writeSound(folder_ / "cut.wav", {cutSignal(true)});
    writeScenario(folder_ / "cut.toml");
    std::filesystem::create_directory(folder_ / "folder");
  }

  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / "")) {
      names.insert(entry.path().string());
    }
    return names;
  }

  void expectRefusal(const Mistake& mistake) {
    SCOPED_TRACE(spelled(mistake.arguments));
    const std::set<std::string> before = files();
    const Outcome outcome = runCli(folder_ / "", mistake.arguments);
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("stillcut-cli: "));
    EXPECT_THAT(outcome.err, testing::HasSubstr(mistake.says));
    EXPECT_EQ(files(), before);
  }
  void expectRefusals(const std::vector<Mistake>& mistakes) {
    for (const Mistake& mistake : mistakes) expectRefusal(mistake);
  }
  // The scenario with one line changed.
  void changedScenario(const std::string& name, const std::string& from, const std::string& to) {
    std::filesystem::copy_file(folder_ / "cut.toml", folder_ / name);
    replaceIn(folder_ / name, from, to);
  }

  record::TempFolder folder_;
};

TEST_F(BadInput, Usage) {
  folder_.file("slot.json",
               R"({"name": "slot", "N": 2, "aD": 1.0, "up": true, "wmax_mm": 4, "Kt": 6e8, "Kn": 2e8,
                   "modes": [{"f": 922, "zeta": 0.011, "m": 0.03993, "d": [1, 0]}]})");
  expectRefusals({
      {{}, "a command is needed"},
      {{"--verbose"}, "a command is needed"},
      {{"analyse", "cut.wav"}, "'analyse' is no command (did you mean 'analyze'?)"},
      {{"analyze"}, "RECORDING is required"},
      {{"analyze", "cut.wav", "more.wav", "--series", "s.csv"}, "--series of several recordings needs a folder"},
      {{"analyze", "cut.wav", "--lines"}, "--lines: needs --json"},
      {{"analyze", "cut.wav", "--teeht", "4"}, "'--teeht' is no option (did you mean '--teeth'?)"},
      {{"analyze", "cut.wav", "--evnts=x.json"}, "did you mean '--events'?"},
      {{"analyze", "cut.wav", "--teeth", "0"}, "--teeth: 0 is out of range"},
      {{"analyze", "cut.wav", "--teeth", "2.5"}, "--teeth"},
      {{"analyze", "cut.wav", "--teeth", "four"}, "--teeth"},
      {{"analyze", "cut.wav", "--speed", "0"}, "--speed: the speed must be above zero"},
      {{"analyze", "cut.wav", "--speed", "-8500"}, "--speed"},
      {{"analyze", "cut.wav", "--speed", "nan"}, "--speed"},
      {{"analyze", "cut.wav", "--speed", "inf"}, "--speed"},
      {{"analyze", "cut.wav", "--rate", "0"}, "--rate"},
      {{"analyze", "cut.wav", "--scale", "0"}, "--scale"},
      {{"analyze", "cut.wav", "--scale", "inf"}, "--scale"},
      {{"analyze", "cut.wav", "--quantity", "accelertion"}, "did you mean 'acceleration'?"},
      {{"analyze", "cut.wav", "--channel", "1"}, "cut.wav: there is no channel 1"},
      {{"analyze", "cut.wav", "--channel", "-1"}, "channel -1"},
      {{"analyze", "cut.wav", "--channel", "0,0"}, "named twice"},
      {{"analyze", "cut.wav", "--detector", "energy-rato"}, "did you mean 'energy-ratio'?"},
      {{"simulate", "cut.toml", "--strategy", "lobe-centre"}, "did you mean 'lobe-center'?"},
      {{"simulate", "cut.toml", "--seed", "x"}, "--seed"},
      {{"run"}, "--profile is required"},
      {{"run", "--profile", "cut.toml", "--seconds", "-1"}, "--seconds"},
      {{"convert", "cut.wav"}, "OUT is required"},
      {{"lobes", "slot.json", "--method", "zoo"}, "--method"},
      {{"lobes", "slot.json", "--speeds", "5000:6000"}, "--speeds"},
      {{"lobes", "slot.json", "--speeds", "5000:6000:0"}, "--speeds"},
      {{"lobes", "slot.json", "--max-depth", "0"}, "--max-depth"},
  });
}

TEST_F(BadInput, Recordings) {
  folder_.file("empty.wav", "");
  std::filesystem::copy_file(folder_ / "cut.wav", folder_ / "head.wav");
  std::filesystem::resize_file(folder_ / "head.wav", 30);
  std::vector<float> broken = cutSignal(true);
  broken[5000] = std::numeric_limits<float>::quiet_NaN();
  writeSound(folder_ / "nan.wav", {broken});
  const std::string rows = "t,x\n0,1\n0.1,2\n0.2,1\n0.3,3\n0.4,2\n";
  folder_.file("nan.csv", rows + "0.5,nan\n0.6,1\n");
  folder_.file("inf.csv", rows + "0.5,inf\n0.6,1\n");
  folder_.file("wide.csv", rows + "0.5,1,7\n0.6,1\n");
  folder_.file("narrow.csv", rows + "0.5\n0.6,1\n");
  folder_.file("word.csv", rows + "0.5,much\n0.6,1\n");
  folder_.file("back.csv", rows + "0.1,1\n0.6,1\n");
  folder_.file("words.csv", "nothing but\nwords in here\n");
  folder_.file("column", "1\n2\n3\n4\n5\n");
  folder_.file("noise.csv", std::string("\x01\x02\xff\x00\x7f\x03\x04\x05\x06", 9));
  folder_.file("fake.h5", std::string("\x89HDF\r\n\x1a\n", 8) + "no more than a signature");
  expectRefusals({
      {{"analyze", "missing.wav"}, "missing.wav: there is no such file"},
      {{"analyze", "folder"}, "folder: is a folder"},
      {{"analyze", "/dev/null"}, "/dev/null: is not a regular file"},
      {{"analyze", "empty.wav"}, "empty.wav: the file is empty"},
      {{"analyze", "head.wav"}, "a truncated file"},
      {{"analyze", "nan.wav"}, "nan.wav: frame 5000 of channel 0 is not a finite number"},
      {{"analyze", "nan.wav", "--events", "e.json", "--series", "s.csv"}, "frame 5000"},
      {{"analyze", "nan.csv"}, "nan.csv:7"},
      {{"analyze", "inf.csv"}, "inf.csv:7"},
      {{"analyze", "wide.csv"}, "wide.csv:7"},
      {{"analyze", "narrow.csv"}, "narrow.csv:7"},
      {{"analyze", "word.csv"}, "word.csv:7"},
      {{"analyze", "back.csv"}, "back.csv:7"},
      {{"analyze", "words.csv"}, "words.csv: no rows of numbers"},
      {{"analyze", "column"}, "give it with --rate"},
      {{"analyze", "noise.csv"}, "noise.csv"},
      {{"analyze", "fake.h5"}, "fake.h5"},
      {{"info", "missing.wav"}, "there is no such file"},
      {{"info", "missing.h5", "--repair"}, "missing.h5"},
      {{"info", "cut.wav", "--repair"}, "cut.wav: is no session file"},
      {{"convert", "missing.wav", "out.csv"}, "there is no such file"},
      {{"convert", "nan.csv", "out.wav"}, "nan.csv:7"},
      {{"convert", "nan.wav", "out.csv"}, "frame 5000"},
  });
}

TEST_F(BadInput, SpeedLogs) {
  folder_.file("header.csv", "time,rpm\n0,8500\n");
  folder_.file("zero.csv", "t,rpm\n0,8500\n1,0\n");
  folder_.file("back.csv", "t,rpm\n0,8500\n0,8500\n");
  folder_.file("word.csv", "t,rpm\n0,fast\n");
  folder_.file("empty.csv", "t,rpm\n");
  folder_.file("good.csv", "t,rpm\n0,8500\n");
  expectRefusals({
      {{"analyze", "cut.wav", "--speed-log", "missing.csv"}, "missing.csv"},
      {{"analyze", "cut.wav", "--speed-log", "header.csv"}, "header.csv:1: the header is not 't,rpm'"},
      {{"analyze", "cut.wav", "--speed-log", "zero.csv"}, "zero.csv:3: the speed must be above zero"},
      {{"analyze", "cut.wav", "--speed-log", "back.csv"}, "back.csv:3: the time does not rise"},
      {{"analyze", "cut.wav", "--speed-log", "word.csv"}, "word.csv:2"},
      {{"analyze", "cut.wav", "--speed-log", "empty.csv"}, "holds no speeds"},
      {{"analyze", "cut.wav", "--speed-log", "folder"}, "folder"},
      {{"analyze", "cut.wav", "--speed-log", "good.csv", "--speed", "8500"}, "excludes"},
  });
}

TEST_F(BadInput, Settings) {
  folder_.file("key.toml", "[energy-ratio]\nchater = 0.2\n");
  folder_.file("part.toml", "[energy-rato]\nchatter = 0.2\n");
  folder_.file("word.toml", "[energy-ratio]\nchatter = \"much\"\n");
  folder_.file("range.toml", "[energy-ratio]\nchatter = 7\n");
  folder_.file("syntax.toml", "[energy-ratio\n");
  const auto set = [](const char* setting) { return std::vector<std::string>{"analyze", "cut.wav", "--set", setting}; };
  const auto config = [](const char* file) { return std::vector<std::string>{"analyze", "cut.wav", "--config", file}; };
  expectRefusals({
      {set("energy-ratio.chater=1"), "did you mean 'energy-ratio.chatter'?"},
      {set("energy-ratio.chatter"), "is not KEY=VALUE"},
      {set("energy-ratio.chatter="), "energy-ratio.chatter"},
      {set("energy-ratio.chatter=nan"), "finite"},
      {set("energy-ratio.chatter=7"), "allowed: 0.01 to 1"},
      {config("missing.toml"), "missing.toml"},
      {config("folder"), "folder"},
      {config("key.toml"), "key.toml:2: unknown key 'energy-ratio.chater' (did you mean 'energy-ratio.chatter'?)"},
      {config("part.toml"), "did you mean 'energy-ratio"},
      {config("word.toml"), "word.toml:2"},
      {config("range.toml"), "range.toml:2"},
      {config("syntax.toml"), "syntax.toml:1"},
      {{"simulate", "cut.toml", "--set", "lobe-centre.x=1"}, "--set: unknown key"},
      {{"simulate", "cut.toml", "--config", "key.toml"}, "key.toml:2"},
  });
}

TEST_F(BadInput, Scenarios) {
  changedScenario("key.toml", "teeth = 4", "tooth = 4");
  changedScenario("teeth.toml", "teeth = 4", "teeth = 0");
  changedScenario("speed.toml", "speed_rpm = 8500", "speed_rpm = 0");
  changedScenario("damping.toml", "damping = 0.02", "damping = -0.02");
  changedScenario("infinite.toml", "stiffness_n_per_m = ", "stiffness_n_per_m = inf #");
  changedScenario("word.toml", "side = \"down\"", "side = \"sideways\"");
  changedScenario("extra.toml", "[tool]", "[tool]\nflutes = 4");
  changedScenario("strategy.toml", "strategy = \"lobe-center\"", "strategy = \"lobe-centre\"");
  folder_.file("empty.toml", "");
  folder_.file("bad.json", "{\"process\": 1");
  folder_.file("list.json", "[]");
  folder_.file("part.json", "{\"process\": {}, \"modes\": []}");
  folder_.file("lobes.json", "{\"N\": 2}");
  expectRefusals({
      {{"simulate", "missing.toml"}, "missing.toml"},
      {{"simulate", "folder"}, "folder"},
      {{"simulate", "cut.wav"}, "cut.wav"},
      {{"simulate", "empty.toml"}, "empty.toml"},
      {{"simulate", "key.toml"}, "key.toml"},
      {{"simulate", "teeth.toml"}, "teeth.toml:"},
      {{"simulate", "speed.toml"}, "speed.toml:"},
      {{"simulate", "damping.toml"}, "damping.toml:"},
      {{"simulate", "infinite.toml"}, "infinite.toml:"},
      {{"simulate", "word.toml"}, "word.toml:"},
      {{"simulate", "extra.toml"}, "flutes"},
      {{"simulate", "strategy.toml"}, "did you mean 'lobe-center'?"},
      {{"lobes", "missing.toml"}, "missing.toml"},
      {{"lobes", "empty.toml"}, "empty.toml"},
      {{"lobes", "bad.json"}, "bad.json"},
      {{"convert", "bad.json", "out.toml"}, "bad.json: is no case"},
      {{"convert", "list.json", "out.toml"}, "list.json: is no case"},
      {{"convert", "part.json", "out.toml"}, "part.json"},
      {{"convert", "lobes.json", "out.toml"}, "lobes.json"},
      {{"convert", "missing.json", "out.toml"}, "missing.json"},
      {{"modal", "missing.uff"}, "missing.uff"},
      {{"modal", "cut.toml", "--out", "modes.toml"}, "cut.toml"},
      {{"coefficients", "cut.wav", "--speed", "6000", "--teeth", "2", "--depth", "3", "--feed", "300"}, "cut.wav"},
  });
}

TEST_F(BadInput, Profiles) {
  const std::string head = "version = 1\nmachine = \"M\"\n[tool]\nteeth = 4\n";
  const std::string simulated = "[source]\nid = \"simulated\"\n[source.settings]\nscenario = \"cut.toml\"\n";
  folder_.file("source.toml", head);
  folder_.file("device.toml", head + "[source]\nid = \"simulatd\"\n");
  folder_.file("scenario.toml", head + "[source]\nid = \"simulated\"\n[source.settings]\nscenario = \"lost.toml\"\n");
  folder_.file("bare.toml", head + "[source]\nid = \"simulated\"\n");
  folder_.file("link.toml", head + simulated + "[link]\nid = \"simulate\"\n");
  folder_.file("detector.toml", head + simulated + "[control]\ndetector = \"energy\"\n");
  folder_.file("strategy.toml", head + simulated + "[control]\nstrategy = \"moniter\"\n");
  folder_.file("key.toml", head + simulated + "[parameters.energy-ratio]\nchater = 0.2\n");
  folder_.file("teeth.toml", "version = 1\nmachine = \"M\"\n[tool]\nteeth = 0\n" + simulated);
  folder_.file("speed.toml", head + simulated + "[cut]\nspeed_rpm = 0.0\n");
  folder_.file("version.toml", "version = 99\nmachine = \"M\"\n" + simulated);
  const auto profile = [](const char* file) { return std::vector<std::string>{"run", "--profile", file}; };
  expectRefusals({
      {profile("missing.toml"), "missing.toml"},
      {profile("folder"), "folder"},
      {profile("source.toml"), "source.toml: 'source.id' is missing"},
      {profile("device.toml"), "did you mean 'simulated'?"},
      {profile("scenario.toml"), "lost.toml"},
      {profile("bare.toml"), "a scenario is needed"},
      {profile("link.toml"), "did you mean 'simulated'?"},
      {profile("detector.toml"), "detector.toml:"},
      {profile("strategy.toml"), "did you mean 'monitor'?"},
      {profile("key.toml"), "did you mean 'energy-ratio.chatter'?"},
      {profile("teeth.toml"), "teeth.toml:"},
      {profile("speed.toml"), "speed.toml:"},
      {profile("version.toml"), "version.toml"},
  });
}

TEST_F(BadInput, Outputs) {
  folder_.file("case.toml", "");
  const std::string profile = STILLCUT_SOURCE_DIR "/resources/profiles/simulated.toml";
  expectRefusals({
      {{"analyze", "cut.wav", "--events", "folder"}, "it is a folder"},
      {{"analyze", "cut.wav", "--events", "lost/e.json"}, "there is no folder 'lost'"},
      {{"analyze", "cut.wav", "--events", "cut.wav"}, "it is the file that is read"},
      {{"analyze", "cut.wav", "--series", "/dev/full"}, "it is no regular file"},
      {{"analyze", "cut.wav", "--series", "lost/s.csv", "--events", "e.json"}, "there is no folder 'lost'"},
      {{"analyze", "cut.wav", "--series", "x", "--events", "x"}, "the same file"},
      {{"simulate", "cut.toml", "--out", "cut.flac"}, "the suffix must be .h5 or .wav"},
      {{"simulate", "cut.toml", "--out", "lost/cut.h5"}, "there is no folder 'lost'"},
      {{"convert", "cut.wav", "cut.xyz"}, "cut.xyz: cannot be written (the suffix must be one of .wav .flac .csv"},
      {{"convert", "cut.wav", "cut.wav"}, "it is the file that is read"},
      {{"convert", "case.json", "case.csv"}, "becomes a .toml file"},
      {{"lobes", "cut.toml", "--out", "lost/l.csv"}, "there is no folder 'lost'"},
      {{"modal", "cut.wav", "--out", "folder"}, "it is a folder"},
      {{"run", "--profile", profile, "--record", "r.wav"}, "the suffix must be .h5"},
  });
}

TEST_F(BadInput, ALineStaysOneLineWhateverTheNameHolds) {
  expectRefusals({{{"analyze", "two\nlines.wav"}, "two lines.wav: there is no such file"}});
}

}  // namespace
}  // namespace stillcut::cli_test
