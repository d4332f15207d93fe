// From measurement to lobes: tap test -> modal -> lobes, forces -> coefficients -> lobes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/units.h"
#include "tests/component/cli/in_folder.h"

namespace stillcut::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kToolAndCut =
    "[tool]\nteeth = 2\ndiameter_mm = 10.0\n[engagement]\nradial_immersion = 0.5\nside = \"up\"\n"
    "[chart]\nmax_depth_mm = 10.0\n";
constexpr const char* kAluminium = "[material]\ntangential_n_per_m2 = 6e8\nradial_n_per_m2 = 2e8\n";
constexpr const char* kTrueMode =
    "[[mode]]\nfrequency_hz = 950.0\ndamping = 0.02\nstiffness_n_per_m = 3e6\ndirection = [1.0, 0.0]\n"
    "[[mode]]\nfrequency_hz = 1800.0\ndamping = 0.03\nstiffness_n_per_m = 8e6\ndirection = [1.0, 0.0]\n";

class IdentifiedLobes : public InFolder {
 protected:
  // The compliance of kTrueMode as a table.
  void writeTap(const std::string& name) {
    std::string text;
    for (double f = 300.0; f <= 3000.0; f += 1.0) {
      std::complex<double> h = 0.0;
      for (const auto& [own, damping, stiffness] : {std::tuple{950.0, 0.02, 3e6}, std::tuple{1800.0, 0.03, 8e6}}) {
        const double r = f / own;
        h += 1.0 / (stiffness * std::complex<double>(1.0 - r * r, 2.0 * damping * r));
      }
      char line[100];
      std::snprintf(line, sizeof line, "%.1f\t%.9e\t%.9e\n", f, h.real(), h.imag());
      text += line;
    }
    folder_.file(name, text);
  }
  // First limit by speed.
  static std::vector<double> limits(const std::string& csv) {
    std::vector<double> depths;
    std::istringstream in(csv);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
      const std::size_t first = line.find(",0,");
      if (first != std::string::npos && line[first + 3] != ',') depths.push_back(std::stod(line.substr(first + 3)));
    }
    return depths;
  }
};

TEST_F(IdentifiedLobes, ATapTestGivesTheLimitsOfTheStructureThatWasTapped) {
  writeTap("tap.txt");
  folder_.file("true.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  folder_.file("cut.toml", std::string(kToolAndCut) + kAluminium);
  run({"modal", "tap.txt", "--unit", "m/N", "--axis", "x", "--out", "modes.toml"});
  const std::vector<std::string> range{"--speeds", "6000:24000:2000"};
  const auto with = [&](std::vector<std::string> a) {
    a.insert(a.end(), range.begin(), range.end());
    return run(a);
  };
  const auto found = limits(with({"lobes", "cut.toml", "--modes", "modes.toml"}));
  const auto truth = limits(with({"lobes", "true.toml"}));
  ASSERT_EQ(found.size(), truth.size());
  ASSERT_GE(truth.size(), 5u);
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_NEAR(found[i] / truth[i], 1.0, 0.01) << i;
  // The file as `modal` wrote it, its notes included, may also stand inside the case.
  folder_.file("pasted.toml", content("modes.toml") + kToolAndCut + kAluminium);
  EXPECT_EQ(with({"lobes", "pasted.toml"}), with({"lobes", "cut.toml", "--modes", "modes.toml"}));
}

TEST_F(IdentifiedLobes, PartsTakeThePlaceOfTheCasesOwn) {
  folder_.file("whole.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  folder_.file("bare.toml", kToolAndCut);
  folder_.file("modes.toml", kTrueMode);
  folder_.file("material.toml",
               "[material]\ntangential_n_per_m2 = 1.2e9\nradial_n_per_m2 = 4e8\n[force_fit]\nfeeds = 3\n");
  const auto once = limits(run({"lobes", "whole.toml", "--speeds", "8000:9000:1000"}));
  const auto twice = limits(run({"lobes", "whole.toml", "--material", "material.toml", "--speeds", "8000:9000:1000"}));
  ASSERT_EQ(once.size(), 2u);
  ASSERT_EQ(twice.size(), 2u);
  EXPECT_NEAR(once[0] / twice[0], 2.0, 1e-6);  // depth and coefficients enter as a product
  EXPECT_EQ(limits(run({"lobes", "bare.toml", "--modes", "modes.toml", "--material", "material.toml", "--speeds",
                        "8000:9000:1000"})),
            twice);
  const Outcome missing = runCli(folder_ / "", {"lobes", "bare.toml", "--modes", "modes.toml"});
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_THAT(missing.err, HasSubstr("material"));
  const Outcome wrong = runCli(folder_ / "", {"lobes", "whole.toml", "--modes", "material.toml"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_THAT(wrong.err, HasSubstr("material.toml"));
}

TEST_F(IdentifiedLobes, TheSharedTapTestAndSlotForcesGoAllTheWay) {
  const std::filesystem::path shared = std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings";
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << "not here: " << shared;
  run({"modal", shared / "tap_test/Point_1_Channel_1_CH1.txt", "--axis", "x", "--out", "x.toml"});
  run({"modal", shared / "tap_test/impact_time_Point1_Channel1_CH1.txt", "--axis", "y", "--out", "y.toml",
       "--force-unit", "N", "--response-unit", "m/s^2"});
  run({"coefficients", shared / "slot_force/6-n6000f300ap3ae25.csv", shared / "slot_force/6-n6000f900ap3ae25.csv",
       "--speed", "6000", "--teeth", "2", "--depth", "3", "--feed", "300,900", "--out", "material.toml"});
  folder_.file("cut.toml", kToolAndCut);
  const json all = json::parse(run({"lobes", "cut.toml", "--modes", "x.toml", "--modes", "y.toml", "--material",
                                    "material.toml", "--speeds", "4000:24000:1000", "--json"}),
                               nullptr, false);
  ASSERT_EQ(all["speeds"].size(), 21u);
  std::size_t limited = 0;
  for (const json& one : all["speeds"]) {
    EXPECT_TRUE(one["verified"].get<bool>()) << one["speed_rpm"];
    EXPECT_EQ(one["searched_to_mm"], 10.0);
    limited += one["crossings"].empty() ? 0 : 1;
    for (const json& c : one["crossings"]) EXPECT_GT(c["frequency_hz"].get<double>(), 900.0);
  }
  EXPECT_GE(limited, 10u);
}

// "No limit" and "not searched" are different answers.
TEST_F(IdentifiedLobes, HowDeepWasSearchedIsSaid) {
  folder_.file("cut.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  const Outcome shallow =
      runCli(folder_ / "", {"lobes", "cut.toml", "--max-depth", "0.01", "--speeds", "9000:9000:1", "--out", "s.csv"});
  EXPECT_THAT(shallow.out, HasSubstr("1 speeds: 0 with a limit, 1 without one down to 0.01 mm"));
  EXPECT_THAT(content("s.csv"), HasSubstr("9000,0,,0,0,none,"));
  const Outcome deep = runCli(folder_ / "", {"lobes", "cut.toml", "--max-depth", "1000", "--speeds", "60:60:1"});
  EXPECT_EQ(deep.exitCode, 0);
  EXPECT_THAT(deep.out, HasSubstr("60,0,,0,0,unknown,"));
  EXPECT_THAT(deep.err, HasSubstr("double precision ends there"));
}

TEST_F(IdentifiedLobes, ZerothOrderWarnsWhereverItsResultGoes) {
  folder_.file("cut.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  const std::vector<std::string> base{"lobes", "cut.toml", "--method", "zoa", "--speeds", "9000:9100:100"};
  for (const std::vector<std::string>& way : {std::vector<std::string>{}, {"--out", "z.csv"}, {"--json"}}) {
    std::vector<std::string> arguments = base;
    arguments.insert(arguments.end(), way.begin(), way.end());
    const Outcome outcome = runCli(folder_ / "", arguments);
    EXPECT_THAT(outcome.err, HasSubstr("warning: zeroth order averages the force"));
    if (way == std::vector<std::string>{"--json"}) {
      EXPECT_THAT(json::parse(outcome.out)["warnings"][0].get<std::string>(), HasSubstr("zeroth order"));
    }
  }
}

constexpr const char* kScenarioRest = "name = \"cut\"\nexpect = \"hold\"\n";
constexpr const char* kProgramme =
    "[programme]\nspeed_rpm = 10000.0\nfeed_per_tooth_mm = 0.1\nduration_s = 1.0\n[programme.depth_mm]\n"
    "[[programme.depth_mm.segment]]\nfrom = 0.0\nto = 1.0\nvalue = 1.5\n"
    "[overrides]\nspeed_percent = [80.0, 120.0]\n[sampling]\nrate_hz = 25600.0\n"
    "[[sensor]]\nname = \"y\"\nquantity = \"displacement\"\naxis = \"y\"\n";
constexpr const char* kToolAlone =
    "[tool]\nteeth = 2\ndiameter_mm = 10.0\n[engagement]\nradial_immersion = 0.5\nside = \"up\"\n";

TEST_F(IdentifiedLobes, AdviceIsTheSameForCaseScenarioAndProfile) {
  folder_.file("case.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  folder_.file("scenario.toml", std::string(kScenarioRest) + kTrueMode + kToolAlone + kAluminium + kProgramme);
  folder_.file("profile.toml",
               "version = 1\nmachine = \"Mill\"\n[tool]\nteeth = 2\n[cut]\nspeed_rpm = 10000\nfeed_mm_min = "
               "2000\nmodel = \"case.toml\"\n"
               "depth_mm = 1.5\n");
  const auto pockets = [&](const std::vector<std::string>& arguments) {
    return json::parse(run(arguments)).at("pockets");
  };
  const std::vector<std::string> asked{"--speeds", "8000:12000", "--json"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), asked.begin(), asked.end());
    return pockets(arguments);
  };
  const json ofCase = with({"advise", "case.toml", "--depth", "1.5", "--feed", "0.1"});
  ASSERT_FALSE(ofCase.empty());
  EXPECT_EQ(ofCase, with({"advise", "scenario.toml"}));
  EXPECT_EQ(ofCase.size(), with({"advise", "profile.toml"}).size());
  EXPECT_EQ(ofCase[0].at("from_rpm"), with({"advise", "profile.toml"})[0].at("from_rpm"));
  EXPECT_EQ(ofCase, pockets({"advise", "scenario.toml", "--json"})) << "80 to 120 % of 10000 is the same range";
  // What is stable at the edges and beyond is what `lobes` says of all three.
  for (const char* file : {"case.toml", "scenario.toml", "profile.toml"}) {
    const std::string table = run({"lobes", file, "--speeds", "9000:11000:500", "--max-depth", "10"});
    EXPECT_EQ(table, run({"lobes", "case.toml", "--speeds", "9000:11000:500", "--max-depth", "10"}));
  }
}

TEST_F(IdentifiedLobes, AForceLawThatIsNotStraightIsTakenAtTheFeedAndEngagementGiven) {
  folder_.file("power.toml", std::string(kTrueMode) + kToolAndCut +
                                 "[material]\ntangential_n_per_m2 = 6e7\nradial_n_per_m2 = 2e7\nexponent = 0.75\n");
  const auto limit = [&](const std::string& feed, const std::string& engagement) {
    const auto found = limits(run({"lobes", "power.toml", "--speeds", "8500:8500:1", "--max-depth", "30", "--feed",
                                   feed, "--engagement", engagement}));
    return found.empty() ? 0.0 : found[0];
  };
  const double slow = limit("0.05", "0:90"), fast = limit("0.2", "0:90");
  ASSERT_GT(slow, 0.0);
  // The slope of K h^0.75 goes with h^-0.25: four times the feed is 1.41 times the depth.
  EXPECT_NEAR(fast / slow, std::pow(4.0, 0.25), 1e-6);
  const json advice =
      json::parse(run({"advise", "power.toml", "--depth", "0.3", "--speeds", "8000:9000", "--feed", "0.2", "--json"}));
  const json slower =
      json::parse(run({"advise", "power.toml", "--depth", "0.3", "--speeds", "8000:9000", "--feed", "0.05", "--json"}));
  EXPECT_NE(advice.at("pockets").dump(), slower.at("pockets").dump());
  const Outcome said =
      runCli(folder_ / "", {"lobes", "power.toml", "--speeds", "8500:8500:1", "--feed", "0.1", "--engagement", "0:90"});
  EXPECT_THAT(said.err, HasSubstr("at a chip of 63.7 um")) << "0.1 mm times 2 / pi";
}

TEST_F(IdentifiedLobes, WhereOnlySoMuchWasSearchedItIsSaidToBeAtLeastThat) {
  folder_.file("stiff.toml",
               "[[mode]]\nfrequency_hz = 950.0\ndamping = 0.05\nstiffness_n_per_m = 5e8\ndirection = [1.0, 0.0]\n" +
                   std::string(kToolAndCut) + kAluminium);
  const std::vector<std::string> asked{"advise", "stiff.toml", "--depth", "1", "--speeds", "8000:9000"};
  EXPECT_THAT(run(asked), HasSubstr(": at least 4 mm"));
}

TEST_F(IdentifiedLobes, AdviceWithASpreadIsNarrowerAndNoDeeper) {
  folder_.file("case.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  const auto best = [&](const std::vector<std::string>& spread) {
    std::vector<std::string> asked{"advise", "case.toml", "--depth", "1.5", "--speeds", "8000:10500", "--json"};
    asked.insert(asked.end(), spread.begin(), spread.end());
    return json::parse(run(asked)).at("pockets").at(0);
  };
  const json sure = best({});
  const json doubted = best({"--spread", "1,10,10,10"});
  EXPECT_GT(doubted.at("from_rpm").get<double>(), sure.at("from_rpm").get<double>());
  EXPECT_LT(doubted.at("limit_mm").get<double>(), sure.at("limit_mm").get<double>());
  EXPECT_GT(doubted.at("expected_limit_mm").get<double>(), doubted.at("limit_mm").get<double>());
}

// A tool square to the work, of one mode: b_lim = 2 zeta (1 + zeta) k / K, of tangential by radial in the ratio asked.
TEST_F(IdentifiedLobes, ATurningToolsLeastLimitIsTheClosedForm) {
  constexpr double kZeta = 0.05, kStiffness = 2e7, kRadial = 1e9;
  folder_.file("bar.toml",
               "[turning]\ndiameter_mm = 80\n[[mode]]\nfrequency_hz = 240\ndamping = 0.05\nstiffness_n_per_m = 2e7\n"
               "direction = [1.0, 0.0, 0.0]\n"
               "[material]\ntangential_n_per_m2 = 2e9\nradial_n_per_m2 = 1e9\n");
  const auto found = limits(run({"lobes", "bar.toml", "--speeds", "630:700:1", "--max-depth", "20"}));
  ASSERT_FALSE(found.empty());
  const double least = 1e3 * 2.0 * kZeta * (1.0 + kZeta) * kStiffness / kRadial;
  EXPECT_NEAR(*std::min_element(found.begin(), found.end()), least, 2e-3 * least);
}

TEST_F(IdentifiedLobes, AdviceThatIsNotPossibleIsOneLine) {
  folder_.file("case.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  for (const std::vector<std::string>& bad : std::vector<std::vector<std::string>>{
           {"advise", "case.toml"},
           {"advise", "case.toml", "--depth", "1"},
           {"advise", "case.toml", "--depth", "1", "--speeds", "9000"},
           {"advise", "case.toml", "--depth", "1", "--speeds", "9000:8000"},
           {"advise", "case.toml", "--depth", "1", "--speeds", "1:8000"},
           {"advise", "case.toml", "--depth", "1", "--speeds", "8000:9000", "--engagement", "90:20"},
           {"advise", "case.toml", "--depth", "1", "--speeds", "8000:9000", "--offset", "4"},
           {"advise", "nowhere.toml", "--depth", "1", "--speeds", "8000:9000"},
           {"lobes", "case.toml", "--spread", "1,2"}}) {
    const Outcome outcome = runCli(folder_ / "", bad);
    EXPECT_EQ(outcome.exitCode, 2) << spelled(bad);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST_F(IdentifiedLobes, WhereNoSpeedIsStableTheDeepestCutIsSaid) {
  folder_.file("case.toml", std::string(kTrueMode) + kToolAndCut + kAluminium);
  const std::string said = run({"advise", "case.toml", "--depth", "8", "--speeds", "8000:9000"});
  EXPECT_THAT(said, HasSubstr("no speed from 8000 to 9000 rpm is stable at 8 mm"));
  EXPECT_THAT(said, HasSubstr("the deepest stable cut is"));
}

}  // namespace
}  // namespace stillcut::cli_test
