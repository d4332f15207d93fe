// Scenarios as files: every shipped one loads, saving loses nothing, bad input gives one clear line.
#include "core/milling/simulation/scenario.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/milling/model_toml.h"
#include "core/milling/simulation/case_json.h"

namespace stillcut::milling {
namespace {

namespace fs = std::filesystem;

fs::path scenarios() {
  return fs::path(STILLCUT_SOURCE_DIR) / "resources" / "scenarios";
}

// A file of its own per test, gone afterwards.
class TempFile {
 public:
  explicit TempFile(const std::string& content = {}) {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    path_ = fs::temp_directory_path() / (std::string("stillcut_scenario_") + info->name() + ".toml");
    std::ofstream(path_) << content;
  }
  ~TempFile() { fs::remove(path_); }
  TempFile(const TempFile&) = delete;
  TempFile& operator=(const TempFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  fs::path path_;
};

std::string contentOf(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The demo's text with one piece replaced, loaded.
std::string errorWith(const std::string& piece, const std::string& instead) {
  std::string text = contentOf(scenarios() / "demo.toml");
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) return "the demo holds no '" + piece + "'";
  text.replace(at, piece.size(), instead);
  const TempFile file(text);
  const Result<Scenario> s = loadScenario(file.path());
  return s.ok() ? "" : s.error().line();
}

TEST(ScenarioFiles, EveryShippedOneLoadsUnderItsOwnName) {
  int count = 0;
  for (const fs::directory_entry& e : fs::directory_iterator(scenarios())) {
    const Result<Scenario> s = loadScenario(e.path().string());
    ASSERT_TRUE(s.ok()) << s.error().line();
    EXPECT_EQ(s->name, e.path().stem().string());
    // Auto is granted by the demonstrations alone.
    EXPECT_EQ(s->grantsAuto, s->name.starts_with("demo")) << s->name;
    ++count;
  }
  EXPECT_GE(count, 1);
}

TEST(ScenarioFiles, SavedAndLoadedIsTheSame) {
  for (const fs::directory_entry& e : fs::directory_iterator(scenarios())) {
    const Result<Scenario> s = loadScenario(e.path().string());
    ASSERT_TRUE(s.ok()) << s.error().line();
    const TempFile file;
    ASSERT_TRUE(saveScenario(*s, file.path()).ok());
    const Result<Scenario> again = loadScenario(file.path());
    ASSERT_TRUE(again.ok()) << again.error().line();
    EXPECT_EQ(scenarioText(*again), scenarioText(*s)) << e.path();
    EXPECT_EQ(again->programme.depth, s->programme.depth) << e.path();
    EXPECT_EQ(again->drive, s->drive) << e.path();
    EXPECT_EQ(again->overrides, s->overrides) << e.path();
  }
}

TEST(ScenarioFiles, SharedCasesConvertWithoutLoss) {
  const fs::path cases = fs::path(STILLCUT_SHARED_DIR) / "cases";
  if (!fs::exists(cases)) GTEST_SKIP() << "no shared cases at " << cases;
  for (const fs::directory_entry& e : fs::directory_iterator(cases)) {
    if (e.path().extension() != ".json") continue;
    const Result<Scenario> s = loadCaseJson(e.path().string());
    ASSERT_TRUE(s.ok()) << s.error().line();
    const TempFile file(scenarioText(*s));
    const Result<Scenario> again = loadScenario(file.path());
    ASSERT_TRUE(again.ok()) << again.error().line();
    const Scenario &a = *s, &b = *again;
    ASSERT_EQ(a.model.modes.size(), b.model.modes.size());
    for (std::size_t i = 0; i < a.model.modes.size(); ++i) {
      EXPECT_EQ(a.model.modes[i].frequency, b.model.modes[i].frequency);
      EXPECT_EQ(a.model.modes[i].damping, b.model.modes[i].damping);
      EXPECT_EQ(a.model.modes[i].stiffness, b.model.modes[i].stiffness);
      EXPECT_EQ(a.model.modes[i].direction, b.model.modes[i].direction);
    }
    EXPECT_EQ(a.model.tool.runout, b.model.tool.runout);
    EXPECT_EQ(a.model.tool.diameter, b.model.tool.diameter);
    EXPECT_EQ(a.programme.depth, b.programme.depth);
    EXPECT_EQ(a.programme.feedPerTooth, b.programme.feedPerTooth);
    EXPECT_EQ(a.programme.entry, b.programme.entry);
    EXPECT_EQ(a.programme.exit, b.programme.exit);
    EXPECT_EQ(a.programme.randomForce, b.programme.randomForce);
    EXPECT_EQ(a.sensors[1].noise, b.sensors[1].noise);
  }
}

TEST(ScenarioFiles, NumbersReadBack) {
  for (double v : {1e-4, 1.3e-4, 0.6286756815608172e-3, 4e-6, 3.7e-6, 1e-7}) {
    EXPECT_EQ(inSi(std::stod(numberText(v, 1e3)), 1e3), v);
    EXPECT_EQ(std::stod(numberText(v)), v);
  }
}

TEST(ScenarioFiles, BadInputGivesOneLineWithFilePlaceAndCause) {
  const auto expectLine = [](const std::string& line, const std::string& part) {
    EXPECT_NE(line.find(part), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  };
  expectLine(errorWith("teeth = 4", "teeth = 0"), "teeth");
  expectLine(errorWith("damping = 0.02", "damping = -0.02"), "damping");
  expectLine(errorWith("speed_rpm = 8500.0", "speed_rpm = 0.0"), "speed_rpm");
  expectLine(errorWith("speed_rpm = 8500.0", "sped_rpm = 8500.0"), "speed_rpm");
  expectLine(errorWith("radial_immersion = 0.7", "radial_immersion = 1.7"), "radial_immersion");
  expectLine(errorWith("duration_s = 30.0", "duration_s = nan"), "duration_s");
  expectLine(errorWith("to = 4.5", "to = 2.5"), "segment 2");
  expectLine(errorWith("quantity = \"acceleration\"", "quantity = \"smell\""), "smell");
  expectLine(errorWith("expect = \"stable\"", "expect = \"hopeful\""), "expect");
  const Result<Scenario> missing = loadScenario("/nowhere/at-all.toml");
  ASSERT_FALSE(missing.ok());
  expectLine(missing.error().line(), "/nowhere/at-all.toml");
}

TEST(CaseJson, BadInputGivesOneLine) {
  const TempFile empty("{}");
  EXPECT_NE(loadCaseJson(empty.path()).error().line().find("modes"), std::string::npos);
  const TempFile broken("{ \"modes\": [");
  EXPECT_FALSE(loadCaseJson(broken.path()).ok());
}

}  // namespace
}  // namespace stillcut::milling
