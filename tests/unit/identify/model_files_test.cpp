#include "core/milling/identify/model_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace stillcut::identify {
namespace {

ModesFile twoModes() {
  ModesFile file;
  file.source = "tap \"tip\" 1.txt";
  file.from = 581.0;
  file.to = 3165.25;
  file.misfit = 0.0629;
  file.realMisfit = 0.148;
  for (const double f : {1073.618123, 1980.5}) {
    IdentifiedMode m;
    m.mode.frequency = Hertz(f);
    m.mode.damping = 0.0319123;
    m.mode.stiffness = 2.418e7;
    m.mode.direction = {0.0, 1.0};
    m.frequencySd = 0.11;
    m.dampingSd = 1e-4;
    m.stiffnessSd = 7.5e4;
    m.share = 0.626;
    m.stability = 0.97;
    m.phase = -0.2;
    file.modes.push_back(m);
  }
  file.modes[1].caveat = "lies at the edge of the band";
  return file;
}

TEST(ModesFile, ReadsBackWhatItWrote) {
  const ModesFile file = twoModes();
  const auto back = parseModes(modesFileText(file), "m.toml");
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(back->source, file.source);
  EXPECT_EQ(back->misfit, file.misfit);
  EXPECT_EQ(back->realMisfit, file.realMisfit);
  EXPECT_EQ(back->to, file.to);
  ASSERT_EQ(back->modes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back->modes[i].mode.frequency, file.modes[i].mode.frequency);
    EXPECT_EQ(back->modes[i].mode.damping, file.modes[i].mode.damping);
    EXPECT_EQ(back->modes[i].mode.stiffness, file.modes[i].mode.stiffness);
    EXPECT_EQ(back->modes[i].mode.direction, file.modes[i].mode.direction);
    EXPECT_EQ(back->modes[i].stiffnessSd, file.modes[i].stiffnessSd);
    EXPECT_EQ(back->modes[i].phase, file.modes[i].phase);
    EXPECT_EQ(back->modes[i].caveat, file.modes[i].caveat);
  }
}

TEST(ModesFile, ResidualsComeBackOneAnAxis) {
  ModesFile file = twoModes();
  file.residuals = {{{1.25e-9, -2e-10}, {3e-9, 0.0}, 1870.0, {0.0, 1.0}}};
  ModesFile along = file;
  along.residuals[0].direction = {1.0, 0.0};
  const auto back = parseModes(modesFileText(joined(file, along)), "m.toml");
  ASSERT_TRUE(back.ok()) << back.error().line();
  ASSERT_EQ(back->residuals.size(), 2u);
  EXPECT_EQ(back->residuals[0].upper, file.residuals[0].upper);
  EXPECT_EQ(back->residuals[0].lower, file.residuals[0].lower);
  EXPECT_EQ(back->residuals[0].at, 1870.0);
  EXPECT_EQ(back->residuals[0].direction, file.residuals[0].direction);
  EXPECT_EQ(back->residuals[1].direction, along.residuals[0].direction);
  EXPECT_NEAR(file.residuals[0].value(935.0).real(), 1.25e-9 - 4.0 * 3e-9, 1e-15);
}

TEST(ModesFile, AHandWrittenListIsEnough) {
  const auto got = parseModes(
      "[[mode]]\nfrequency_hz = 900\ndamping = 0.02\nstiffness_n_per_m = 1e7\ndirection = [1, 0]\n", "m.toml");
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_EQ(got->modes[0].mode.direction, (std::array<double, 2>{1.0, 0.0}));
}

TEST(ModesFile, MistakesAreNamed) {
  const auto negative =
      parseModes("[[mode]]\nfrequency_hz = 900\ndamping = -0.02\nstiffness_n_per_m = 1e7\n", "m.toml");
  ASSERT_FALSE(negative.ok());
  EXPECT_NE(negative.error().line().find("damping"), std::string::npos) << negative.error().line();
  const auto typo = parseModes("[[mode]]\nfrequency_hz = 900\ndampin = 0.02\nstiffness_n_per_m = 1e7\n", "m.toml");
  ASSERT_FALSE(typo.ok());
  std::string text = modesFileText(twoModes());
  text.replace(text.find("damping_sd = [0.0001, 0.0001]"), 29, "damping_sd = [0.0001]");
  const auto fewer = parseModes(text, "m.toml");
  ASSERT_FALSE(fewer.ok());
  EXPECT_NE(fewer.error().line().find("one number per mode"), std::string::npos) << fewer.error().line();
  EXPECT_FALSE(parseModes("", "m.toml").ok());
  EXPECT_FALSE(parseModes("[[mode", "m.toml").ok());
  EXPECT_FALSE(loadModes("/nowhere/modes.toml").ok());
}

MaterialFile steel() {
  CuttingCoefficients k;
  k.tangential = {4.24e8, 1.1e7};
  k.radial = {9.96e8, 2.2e7};
  k.axial = {2.817e8, 5e6};
  k.tangentialEdge = {12513.0, 300.0};
  k.radialEdge = {13430.0, 310.0};
  k.axialEdge = {14083.0, 320.0};
  k.signs = {-1, -1, 1};
  k.feeds = 2;
  k.misfit = 0.01;
  k.remarks = {"two feeds only"};
  return materialFile(k, "a.csv b.csv");
}

TEST(MaterialFile, ReadsBackWhatItWrote) {
  const MaterialFile file = steel();
  const auto back = parseMaterial(materialFileText(file), "k.toml");
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_EQ(back->source, file.source);
  EXPECT_EQ(back->material.tangential, 4.24e8);
  EXPECT_EQ(back->material.radialEdge, 13430.0);
  EXPECT_EQ(back->material.exponent, 1.0);
  EXPECT_EQ(back->coefficients.axial.value, 2.817e8);
  EXPECT_EQ(back->coefficients.axialEdge.deviation, 320.0);
  EXPECT_EQ(back->coefficients.signs, file.coefficients.signs);
  EXPECT_EQ(back->coefficients.feeds, 2);
}

TEST(MaterialFile, MistakesAreNamed) {
  std::string text = materialFileText(steel());
  text.replace(text.find("signs = [-1"), 11, "signs = [-2");
  EXPECT_FALSE(parseMaterial(text, "k.toml").ok());
  EXPECT_FALSE(parseMaterial("", "k.toml").ok());
  EXPECT_FALSE(parseMaterial("[material]\ntangential_n_per_m2 = -1.0\nradial_n_per_m2 = 0.0\n", "k.toml").ok());
}

TEST(ModelFiles, AreWrittenWholeOrNotAtAll) {
  const auto folder = std::filesystem::temp_directory_path() / "stillcut_model_files_test";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "modes.toml").string();
  ASSERT_TRUE(saveModes(twoModes(), path).ok());
  EXPECT_TRUE(loadModes(path).ok());
  ASSERT_TRUE(saveMaterial(steel(), (folder / "k.toml").string()).ok());
  EXPECT_TRUE(loadMaterial((folder / "k.toml").string()).ok());
  EXPECT_FALSE(saveModes(twoModes(), (folder / "missing" / "modes.toml").string()).ok());
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++files;
  EXPECT_EQ(files, 2u);  // nothing half-written lies about
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace stillcut::identify
