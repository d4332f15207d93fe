// From hammer and sensor to modes and to the tips of other tools, as a person runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdio>

#include "core/base/units.h"
#include "tests/component/cli/in_folder.h"

namespace stillcut::cli_test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr const char* kCut =
    "[[mode]]\nfrequency_hz = 800.0\ndamping = 0.03\nstiffness_n_per_m = 2e7\ndirection = [1.0, 0.0]\n"
    "[tool]\nteeth = 2\ndiameter_mm = 10.0\n[engagement]\nradial_immersion = 0.5\nside = \"up\"\n"
    "[chart]\nmax_depth_mm = 10.0\n[material]\ntangential_n_per_m2 = 6e8\nradial_n_per_m2 = 2e8\n";

class TapTest : public InFolder {
 protected:
  // A mode of 800 Hz, 0.03 and `stiffness` in m/N, by its columns.
  void writeFrf(const std::string& name, const std::string& header, double stiffness) {
    std::string text = header;
    for (double f = 100.0; f <= 2000.0; f += 2.0) {
      const double r = f / 800.0;
      const std::complex<double> h = 1.0 / (stiffness * std::complex<double>(1.0 - r * r, 0.06 * r));
      char line[100];
      std::snprintf(line, sizeof line, "%.1f,%.9e,%.9e\n", f, h.real(), h.imag());
      text += line;
    }
    folder_.file(name, text);
  }
  Outcome outcome(const std::vector<std::string>& arguments) { return runCli(folder_ / "", arguments); }
};

TEST_F(TapTest, TwoFilesForTwoAxesBecomeOneFileOfModes) {
  writeFrf("x.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", 1e7);
  writeFrf("y.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", 2e7);
  const std::string said = run({"modal", "x.csv", "y.csv", "--axis", "x,y", "--out", "modes.toml"});
  EXPECT_THAT(said, HasSubstr("axis x"));
  EXPECT_THAT(said, HasSubstr("axis y"));
  const std::string file = content("modes.toml");
  EXPECT_THAT(file, HasSubstr("direction = [1.0, 0.0]"));
  EXPECT_THAT(file, HasSubstr("direction = [0.0, 1.0]"));
  EXPECT_THAT(file, HasSubstr("written_misfit"));
}

TEST_F(TapTest, WhatTheFileDoesNotSayIsAskedForInOneLine) {
  writeFrf("bare.csv", "", 1e6);
  const Outcome asked = outcome({"modal", "bare.csv"});
  EXPECT_EQ(asked.exitCode, 2);
  EXPECT_THAT(asked.err, HasSubstr("give --unit"));
  EXPECT_THAT(run({"modal", "bare.csv", "--unit", "m/N"}), HasSubstr("1.000e+06"));
  EXPECT_THAT(run({"modal", "bare.csv", "--unit", "um/N"}), HasSubstr("1.000e+12"));
}

TEST_F(TapTest, AFreeEndOfTheBandNamesWhatItLeavesOut) {
  writeFrf("x.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", 1e7);
  EXPECT_THAT(run({"modal", "x.csv", "--band", "500:"}), HasSubstr("band 500 to"));
  EXPECT_THAT(run({"modal", "x.csv", "--band", ":1000"}), HasSubstr("to 1000 Hz"));
  EXPECT_EQ(outcome({"modal", "x.csv", "--band", "1000"}).exitCode, 2);
}

TEST_F(TapTest, AResponseAlongZIsNeitherWrittenNorUsed) {
  writeFrf("z.csv", "Frequency [Hz],Re Gzz [m/N],Im Gzz [m/N]\n", 1e7);
  EXPECT_THAT(run({"modal", "z.csv"}), HasSubstr("axis z")) << "to be looked at";
  folder_.file("cut.toml", kCut);
  for (const std::vector<std::string>& use :
       {std::vector<std::string>{"modal", "z.csv", "--out", "modes.toml"},
        std::vector<std::string>{"lobes", "cut.toml", "--frf", "z.csv", "--speeds", "8000:8000:1"},
        std::vector<std::string>{"couple", "z.csv", "--diameter", "10", "--stickout", "60"}}) {
    const Outcome refused = outcome(use);
    EXPECT_EQ(refused.exitCode, 2) << use[0];
    EXPECT_THAT(refused.err, HasSubstr("its response is along z, and lobes are computed from x and y")) << use[0];
  }
  EXPECT_THAT(run({"modal", "z.csv", "--response", "gzz", "--axis", "y", "--out", "modes.toml"}), HasSubstr("axis y"));
}

TEST_F(TapTest, LobesOfResponsesWithoutAUnitAskOrSayWhatTheyTook) {
  folder_.file("cut.toml", kCut);
  const std::vector<std::string> speeds{"--method", "zoa", "--speeds", "9000:9000:1"};
  const auto lobes = [&](std::vector<std::string> a) {
    a.insert(a.begin(), {"lobes", "cut.toml"});
    a.insert(a.end(), speeds.begin(), speeds.end());
    return outcome(a);
  };
  writeFrf("si.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", 2e7);
  writeFrf("bare.csv", "", 2e7);
  writeFrf("um.csv", "Frequency [Hz],Re,Im\n", 20.0);
  writeFrf("either.csv", "Frequency [Hz],Re,Im\n", 1e6);
  const Outcome truth = lobes({"--frf", "si.csv"});
  ASSERT_EQ(truth.exitCode, 0) << truth.err;
  EXPECT_EQ(lobes({"--frf", "bare.csv"}).out, truth.out);
  const Outcome micro = lobes({"--frf", "um.csv"});
  EXPECT_EQ(micro.out, truth.out);
  EXPECT_THAT(micro.err, HasSubstr("read as um/N"));
  EXPECT_THAT(lobes({"--frf", "either.csv"}).err, HasSubstr("give --unit m/N"));
  EXPECT_EQ(lobes({"--frf", "either.csv", "--unit", "m/N"}).exitCode, 0);
  EXPECT_THAT(lobes({"--frf", "si.csv", "--frf-cross", "bare.csv"}).err, HasSubstr("give --frf-cross-unit m/N"));
  EXPECT_EQ(lobes({"--frf", "si.csv", "--frf-cross", "bare.csv", "--frf-cross-unit", "m/N"}).exitCode, 0);
}

TEST_F(TapTest, TheCrossResponseOfLobesIsACrossOne) {
  folder_.file("cut.toml", kCut);
  writeFrf("si.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", 2e7);
  writeFrf("xy.csv", "Frequency [Hz],Re Gxy [m/N],Im Gxy [m/N]\n", 9e7);
  writeFrf("xx.csv", "Frequency [Hz],Re Gxx [m/N],Im Gxx [m/N]\n", 9e7);
  writeFrf("turned.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", -2e7);
  const auto lobes = [&](std::vector<std::string> a) {
    a.insert(a.begin(), {"lobes", "cut.toml", "--method", "zoa", "--speeds", "9000:9000:1"});
    return outcome(a);
  };
  const Outcome crossed = lobes({"--frf", "si.csv", "--frf-cross", "xy.csv"});
  EXPECT_EQ(crossed.exitCode, 0) << crossed.err;
  EXPECT_NE(crossed.out, lobes({"--frf", "si.csv"}).out);
  EXPECT_THAT(lobes({"--frf", "si.csv", "--frf-cross", "xx.csv"}).err,
              HasSubstr("holds no response along one axis to a force along the other"));
  EXPECT_THAT(lobes({"--frf", "turned.csv"}).err, HasSubstr("turn the response with --flip"));
  EXPECT_EQ(lobes({"--frf", "turned.csv", "--flip"}).out, lobes({"--frf", "si.csv"}).out);
}

TEST_F(TapTest, AHolderMeasuredOnceGivesTheTipOfATool) {
  writeFrf("face.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", 5e7);
  writeFrf("above.csv", "Frequency [Hz],Re [m/N],Im [m/N]\n", 6e7);
  const std::vector<std::string> tool{"--diameter", "10", "--stickout", "60", "--flutes", "25"};
  const auto with = [&](std::vector<std::string> a) {
    a.insert(a.end(), tool.begin(), tool.end());
    return a;
  };
  const std::string said = run(with({"couple", "face.csv", "--cross", "above.csv", "--spacing", "40", "--out",
                                     "tip.csv", "--modes-out", "modes.toml"}));
  EXPECT_THAT(said, HasSubstr("with a holder that cannot rotate"));
  EXPECT_THAT(said, Not(HasSubstr("--cross measures it")));
  EXPECT_THAT(run({"modal", "tip.csv"}), HasSubstr("axis x"));
  EXPECT_THAT(content("modes.toml"), HasSubstr("[[mode]]"));
  EXPECT_THAT(run(with({"couple", "face.csv"})), HasSubstr("--cross measures it"));
  EXPECT_THAT(outcome(with({"couple", "face.csv", "--spacing", "40"})).err, HasSubstr("belong together"));
  EXPECT_THAT(outcome({"couple", "face.csv", "--diameter", "10", "--stickout", "20", "--flutes", "25"}).err,
              HasSubstr("longer than the stick-out"));
}

}  // namespace
}  // namespace stillcut::cli_test
