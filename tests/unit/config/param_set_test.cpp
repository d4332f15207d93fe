#include "core/config/param_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/config/nearest_word.h"
#include "core/config/profile.h"
#include "tests/unit/config/example_params.h"

namespace stillcut::config {
namespace {

using namespace example;

std::string errorOf(std::string_view setting) {
  ParamSet params;
  const Status status = applySetting(params, catalog(), setting);
  EXPECT_TRUE(params.values().empty()) << "an error must change nothing";
  return status ? "no error" : status.error().line();
}

TEST(ParamSet, GivesTheDeclaredDefaultUntilSet) {
  ParamSet params;
  EXPECT_DOUBLE_EQ(params.real(kThreshold), 0.2);
  EXPECT_EQ(params.integer(kHarmonics), 32);
  EXPECT_FALSE(params.boolean(kRelearn));
  EXPECT_EQ(params.choice(kWindow), 0);
  EXPECT_TRUE(params.isAutomatic(kBand));
  EXPECT_FALSE(params.isSet(kThreshold));
}

TEST(ParamSet, TakesEveryKindFromText) {
  ParamSet params;
  for (std::string_view setting : {"energy-ratio.threshold=0.35", "energy-ratio.band=1500", "energy-ratio.harmonics=64",
                                   "spectral.relearn=true", "spectral.window=flat-top"}) {
    const Status status = applySetting(params, catalog(), setting);
    EXPECT_TRUE(status.ok()) << setting;
  }
  EXPECT_DOUBLE_EQ(params.real(kThreshold), 0.35);
  EXPECT_DOUBLE_EQ(params.real(kBand), 1500.0);
  EXPECT_EQ(params.integer(kHarmonics), 64);
  EXPECT_TRUE(params.boolean(kRelearn));
  EXPECT_EQ(params.choice(kWindow), 1);
}

TEST(ParamSet, TextReadsBackAsTheSameValue) {
  ParamSet params;
  ASSERT_TRUE(params.set(kThreshold, 0.1 + 0.2, "test").ok());
  ASSERT_TRUE(params.set(kWindow, 2.0, "test").ok());
  ASSERT_TRUE(params.set(kBand, kAutomatic, "test").ok());
  ParamSet again;
  for (const ParamDecl* decl : kAll) {
    ASSERT_TRUE(again.set(catalog(), decl->key, params.text(*decl), "test").ok()) << decl->key;
  }
  EXPECT_EQ(again.real(kThreshold), params.real(kThreshold));
  EXPECT_EQ(again.choice(kWindow), 2);
  EXPECT_TRUE(again.isAutomatic(kBand));
}

TEST(ParamSet, UnsetBringsTheDefaultBack) {
  ParamSet params;
  ASSERT_TRUE(params.set(kHarmonics, 5.0, "test").ok());
  params.unset(kHarmonics);
  EXPECT_EQ(params.integer(kHarmonics), 32);
  EXPECT_FALSE(params.isSet(kHarmonics));
}

TEST(ParamSetErrors, NameKeyCauseAndRemedyInOneLine) {
  EXPECT_EQ(errorOf("energy-ratio.treshold=0.3"),
            "--set: unknown key 'energy-ratio.treshold' (did you mean 'energy-ratio.threshold'?)");
  EXPECT_EQ(errorOf("qqq=1"), "--set: unknown key 'qqq'");
  EXPECT_EQ(errorOf("energy-ratio.threshold=1.5"),
            "--set: energy-ratio.threshold: 1.5 is out of range (allowed: 0 to 1)");
  EXPECT_EQ(errorOf("energy-ratio.band=0"),
            "--set: energy-ratio.band: 0 is out of range (allowed: 1 to 5000 Hz, or auto)");
  EXPECT_EQ(errorOf("energy-ratio.threshold=high"),
            "--set: energy-ratio.threshold: 'high' is not a number (allowed: 0 to 1)");
  EXPECT_EQ(errorOf("energy-ratio.threshold=0,3"),
            "--set: energy-ratio.threshold: '0,3' is not a number (allowed: 0 to 1)");
  EXPECT_EQ(errorOf("energy-ratio.threshold="), "--set: energy-ratio.threshold: '' is not a number (allowed: 0 to 1)");
  EXPECT_EQ(errorOf("energy-ratio.harmonics=2.5"),
            "--set: energy-ratio.harmonics: 2.5 is not a whole number (allowed: 1 to 256)");
  EXPECT_EQ(errorOf("spectral.relearn=yes"), "--set: spectral.relearn: 'yes' is neither true nor false");
  EXPECT_EQ(errorOf("spectral.window=hamming"),
            "--set: spectral.window: 'hamming' is not a choice (choices: hann, flat-top, none)");
  EXPECT_EQ(errorOf("threshold"), "--set: 'threshold' is not KEY=VALUE (for example energy-ratio.chatter=0.2)");
  EXPECT_EQ(errorOf("=1"), "--set: '=1' is not KEY=VALUE (for example energy-ratio.chatter=0.2)");
}

TEST(ParamSetErrors, RefuseWhatIsNotFinite) {
  for (std::string_view value : {"nan", "inf", "-inf"}) {
    const std::string line = errorOf("energy-ratio.threshold=" + std::string(value));
    EXPECT_EQ(line, "--set: energy-ratio.threshold: the value is not a finite number (allowed: 0 to 1)");
  }
  EXPECT_NE(errorOf("energy-ratio.threshold=auto"), "no error") << "only declared parameters may be automatic";
}

TEST(ParamCatalog, KeepsTheOrderAndDropsRepeats) {
  ParamCatalog all = catalog();
  all.add(kAll);
  ASSERT_EQ(all.all().size(), std::size(kAll));
  EXPECT_EQ(all.all().front(), &kThreshold);
  EXPECT_EQ(all.find("spectral.window"), &kWindow);
  EXPECT_EQ(all.find("spectral"), nullptr);
}

TEST(NearestWord, FindsSlipsButNotStrangers) {
  const std::vector<std::string_view> words{"teeth", "diameter_mm", "pitch"};
  EXPECT_EQ(nearestWord("teeht", words), "teeth");
  EXPECT_EQ(nearestWord("diameter", words), "diameter_mm");
  EXPECT_EQ(nearestWord("zzzz", words), "");
  EXPECT_EQ(nearestWord("teeth", {}), "");
  EXPECT_EQ(text(didYouMean("pich", words)), "did you mean 'pitch'?");
}

}  // namespace
}  // namespace stillcut::config
