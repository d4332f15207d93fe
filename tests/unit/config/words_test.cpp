// Numbers as people write them, and the nearest word.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "core/config/nearest_word.h"
#include "core/config/param.h"
#include "core/units/number_text.h"

namespace stillcut::config {
namespace {

TEST(NumberText, ReadsBackAsTheSameBits) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 50000; ++trial) {
    const double value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) continue;
    const std::string text = numberText(value);
    EXPECT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
  }
}

TEST(NumberText, HasNoExponentWhereAPersonWouldWriteNone) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> decades(-3.9, 14.9);
  for (int trial = 0; trial < 5000; ++trial) {
    const double value = std::pow(10.0, decades(random));
    EXPECT_EQ(numberText(value).find('e'), std::string::npos) << value;
    EXPECT_EQ(numberText(-value), "-" + numberText(value));
  }
  EXPECT_NE(numberText(1e-7).find('e'), std::string::npos);
  EXPECT_NE(numberText(1e17).find('e'), std::string::npos);
}

TEST(NumberText, HasTheFewestDigits) {
  const std::pair<double, const char*> cases[] = {{0.0, "0"},
                                                  {8500.0, "8500"},
                                                  {0.1, "0.1"},
                                                  {1e-4, "0.0001"},
                                                  {2.5, "2.5"},
                                                  {-12.0, "-12"},
                                                  {1.0 / 3.0, "0.3333333333333333"}};
  for (const auto& [value, text] : cases) EXPECT_EQ(numberText(value), text);
}

constexpr std::array<std::string_view, 5> kWords{"energy-ratio", "parametric", "spectral", "coherence", "gate"};

TEST(NearestWord, OneSlipOfTheFingerIsForgivenWhereverItIs) {
  for (std::string_view word : kWords) {
    EXPECT_EQ(nearestWord(word, kWords), word);
    for (std::size_t i = 0; i < word.size(); ++i) {
      std::string missing(word), wrong(word), doubled(word);
      missing.erase(i, 1);
      wrong[i] = '_';
      doubled.insert(i, 1, 'q');
      EXPECT_EQ(nearestWord(missing, kWords), word) << missing;
      EXPECT_EQ(nearestWord(wrong, kWords), word) << wrong;
      EXPECT_EQ(nearestWord(doubled, kWords), word) << doubled;
    }
  }
}

TEST(NearestWord, AStrangerIsNobody) {
  for (const char* stranger : {"xxxxxxxxxxxx", "zq", "0123456789"}) {
    EXPECT_EQ(nearestWord(stranger, kWords), "") << stranger;
    EXPECT_TRUE(didYouMean(stranger, kWords).empty());
  }
  EXPECT_EQ(nearestWord("ga__", kWords), "gate");  // two slips of four are not one too many, three are
  EXPECT_EQ(nearestWord("g___", kWords), "");
  EXPECT_EQ(nearestWord("spectral", {}), "");
  EXPECT_EQ(text(didYouMean("spektral", kWords)), "did you mean 'spectral'?");
}

constexpr std::array<std::string_view, 3> kChoices{"low", "middle", "high"};

TEST(ParamDecl, OnlyWhatSetWouldTakeIsLegal) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const ParamDecl real = realParam("a.real", "Real", "Hz", 5.0, 1.0, 10.0, "");
  const ParamDecl whole = integerParam("a.whole", "Whole", 5, 1, 10, "");
  const ParamDecl truth = booleanParam("a.truth", "Truth", true, "");
  const ParamDecl choice = choiceParam("a.choice", "Choice", 1, kChoices, "");
  const ParamDecl automatic = autoParam("a.auto", "Auto", "rpm", 1.0, 10.0, "");
  for (const ParamDecl* decl : {&real, &whole, &truth, &choice, &automatic}) {
    EXPECT_TRUE(isLegal(*decl, decl->fallback)) << decl->key;
    EXPECT_TRUE(isLegal(*decl, decl->lowest)) << decl->key;
    EXPECT_TRUE(isLegal(*decl, decl->highest)) << decl->key;
    EXPECT_FALSE(isLegal(*decl, decl->lowest - 1.0)) << decl->key;
    EXPECT_FALSE(isLegal(*decl, decl->highest + 1.0)) << decl->key;
    EXPECT_FALSE(isLegal(*decl, infinite)) << decl->key;
    EXPECT_EQ(isLegal(*decl, nan), decl == &automatic) << decl->key;
  }
  EXPECT_TRUE(isLegal(real, 1.5));
  EXPECT_TRUE(isLegal(automatic, 1.5));
  for (const ParamDecl* decl : {&whole, &truth, &choice}) EXPECT_FALSE(isLegal(*decl, 0.5)) << decl->key;
}

TEST(ParamDecl, IdsArePublishedFnv1a) {
  EXPECT_EQ(parameterId(""), 0x811c9dc5U);
  EXPECT_EQ(parameterId("a"), 0xe40c292cU);
  EXPECT_EQ(parameterId("foobar"), 0xbf9cf968U);  // of the algorithm's own test vectors
}

}  // namespace
}  // namespace stillcut::config
