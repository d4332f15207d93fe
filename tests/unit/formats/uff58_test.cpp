#include "core/formats/universal/uff58.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "core/milling/identify/import/file_bytes.h"
#include "tests/support/uff_dataset.h"

namespace stillcut::uff {
namespace {

Uff58Dataset sample(bool complex, bool wide, bool even) {
  Uff58Dataset set;
  set.id[0] = "tool tip";
  set.function = Uff58Function::FrequencyResponse;
  set.responseName = "Tip";
  set.responseNode = 7;
  set.responseDirection = -2;
  set.referenceNode = 8;
  set.referenceDirection = 2;
  set.complex = complex;
  set.doublePrecision = wide;
  set.even = even;
  set.abscissa = {Uff58Quantity::Frequency, "Frequency", "Hz"};
  set.ordinate = {Uff58Quantity::Displacement, "Displacement", "m"};
  set.denominator = {Uff58Quantity::ExcitationForce, "Force", "N"};
  for (int i = 0; i < 37; ++i) {
    set.x.push_back(even ? 10.0 + 0.5 * i : 10.0 + 0.5 * i + 0.01 * i * i);
    set.y.emplace_back(1e-6 * std::cos(i), complex ? -2e-7 * std::sin(i) : 0.0);
  }
  return set;
}

void expectSame(const Uff58Dataset& a, const Uff58Dataset& b, double relative) {
  ASSERT_EQ(a.y.size(), b.y.size());
  ASSERT_EQ(a.x.size(), b.x.size());
  EXPECT_EQ(a.function, b.function);
  EXPECT_EQ(a.complex, b.complex);
  EXPECT_EQ(a.even, b.even);
  EXPECT_EQ(a.responseNode, b.responseNode);
  EXPECT_EQ(a.responseDirection, b.responseDirection);
  EXPECT_EQ(a.referenceNode, b.referenceNode);
  EXPECT_EQ(a.referenceDirection, b.referenceDirection);
  EXPECT_EQ(a.responseName, b.responseName);
  EXPECT_EQ(a.ordinate.quantity, b.ordinate.quantity);
  EXPECT_EQ(a.denominator.unit, b.denominator.unit);
  for (std::size_t i = 0; i < a.y.size(); ++i) {
    EXPECT_NEAR(a.x[i], b.x[i], 1e-5 * std::abs(a.x[i]));
    EXPECT_NEAR(std::abs(a.y[i] - b.y[i]), 0.0, relative * std::abs(a.y[i]));
  }
}

TEST(Uff58, RoundTripKeepsEveryForm) {
  for (const Uff58Form form : {Uff58Form::Ascii, Uff58Form::LittleEndian, Uff58Form::BigEndian}) {
    for (int bits = 0; bits < 8; ++bits) {
      const Uff58Dataset set = sample(bits & 1, bits & 2, bits & 4);
      const auto back = parseUff58(test::uffDataset(set, form), "t");
      ASSERT_TRUE(back.ok()) << back.error().line() << " form " << static_cast<int>(form) << " bits " << bits;
      ASSERT_EQ(back->size(), 1u);
      // 6 digits of E13.5, 24 bits of a float, 13 digits of E20.12.
      expectSame(set, back->front(), set.doublePrecision ? 1e-11 : 1e-5);
    }
  }
}

TEST(Uff58, FindsSeveralAmongOtherDatasets) {
  const std::string other = "    -1\n   151\nmodel\n  58\n    -1\n";
  const std::string one = test::uffDataset(sample(true, false, true), Uff58Form::LittleEndian);
  const std::string two = test::uffDataset(sample(false, true, false), Uff58Form::Ascii);
  const auto sets = parseUff58(other + one + other + two, "t");
  ASSERT_TRUE(sets.ok()) << sets.error().line();
  EXPECT_EQ(sets->size(), 2u);
}

TEST(Uff58, FieldsThatTouchAreSeparated) {
  std::string text = test::uffDataset(sample(true, false, true), Uff58Form::Ascii);
  Uff58Dataset set = sample(false, false, true);
  set.y = {{-1.5e-3, 0}, {-2.5e-4, 0}};
  set.x.resize(2);
  text = test::uffDataset(set, Uff58Form::Ascii);
  const std::size_t at = text.find(" -1.5");
  text.replace(at, 26, "-1.50000E-003-2.50000E-004");
  const auto back = parseUff58(text, "t");
  ASSERT_TRUE(back.ok()) << back.error().line();
  EXPECT_DOUBLE_EQ(back->front().y[1].real(), -2.5e-4);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expectRefused(const std::string& bytes, const std::string& part) {
  const auto sets = parseUff58(bytes, "t.uff");
  ASSERT_FALSE(sets.ok()) << part;
  EXPECT_NE(sets.error().line().find(part), std::string::npos) << sets.error().line();
  EXPECT_EQ(sets.error().line().find('\n'), std::string::npos);
}

TEST(Uff58, LyingSizesAreRefusedBeforeMemoryIsTaken) {
  const std::string ascii = test::uffDataset(sample(true, false, true), Uff58Form::Ascii);
  expectRefused(replaced(ascii, "        37", " 999999999"), "more than the file holds");
  expectRefused(replaced(ascii, "        37", "        38"), "ends after 37 of 38 points");
  expectRefused(replaced(ascii, "        37", "        36"), "does not end after its 36 points");
  expectRefused(replaced(ascii, "        37", "        35"), "more numbers than its 35 points");
  expectRefused(replaced(ascii, "        37", "        -3"), "not a size");
  const std::string binary = test::uffDataset(sample(true, false, true), Uff58Form::LittleEndian);
  expectRefused(replaced(binary, "        37", "        38"), "announces 296 bytes, but its points take 304");
  expectRefused(replaced(binary, "         296", "  9999999999"), "header inconsistent");
}

TEST(Uff58, TruncationAtEveryByteIsRefused) {
  for (const Uff58Form form : {Uff58Form::Ascii, Uff58Form::BigEndian}) {
    const std::string whole = test::uffDataset(sample(true, false, true), form);
    for (std::size_t n = 0; n + 3 < whole.size(); ++n) {
      EXPECT_FALSE(parseUff58(whole.substr(0, n), "t").ok()) << n << " of " << whole.size();
    }
  }
}

TEST(Uff58, SwappedBytesAreNoticed) {
  for (const bool wide : {false, true}) {
    const std::string little = test::uffDataset(sample(true, wide, true), Uff58Form::LittleEndian);
    expectRefused(replaced(little, "   58b     1", "   58b     2"), "");
  }
}

TEST(Uff58, ForeignFormatsAndNonsenseAreRefused) {
  const std::string binary = test::uffDataset(sample(true, false, true), Uff58Form::LittleEndian);
  expectRefused(replaced(binary, "     1     2          11", "     1     3          11"), "not IEEE 754");
  expectRefused(replaced(binary, "     1     2          11", "     7     2          11"), "byte order");
  const std::string ascii = test::uffDataset(sample(true, false, true), Uff58Form::Ascii);
  expectRefused(replaced(ascii, "  1.00000E-06", "          nan"), "point 1 is not a finite number");
  expectRefused(replaced(ascii, "  1.00000E-06", "         oops"), "'oops");
  expectRefused(replaced(ascii, "  5.00000E-01", " -5.00000E-01"), "step is not positive");
  expectRefused("", "holds no dataset 58");
  expectRefused("    -1\n    58\n", "ends early");
  expectRefused("    -1\n   151\nno end", "has no end");
}

TEST(Uff58, RandomDamageNeverBreaksTheReader) {
  std::mt19937 random(20240611);
  for (const Uff58Form form : {Uff58Form::Ascii, Uff58Form::LittleEndian, Uff58Form::BigEndian}) {
    const std::string whole = test::uffDataset(sample(true, true, false), form);
    for (int trial = 0; trial < 3000; ++trial) {
      std::string bytes = whole;
      const std::size_t hits = 1 + random() % 6;
      for (std::size_t k = 0; k < hits; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
      if (trial % 3 == 0) bytes.resize(random() % bytes.size());
      const auto sets = parseUff58(bytes, "t");
      if (!sets) {
        EXPECT_EQ(sets.error().line().find('\n'), std::string::npos);
        continue;
      }
      for (const Uff58Dataset& set : *sets) {
        ASSERT_EQ(set.x.size(), set.y.size());
        for (const auto& v : set.y) ASSERT_TRUE(std::isfinite(v.real()) && std::isfinite(v.imag()));
      }
    }
  }
}

class Uff58Files : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_)) GTEST_SKIP() << "reference recordings absent: " << folder_;
  }
  Result<std::vector<Uff58Dataset>> load(const std::string& name) const {
    auto bytes = identify::readFileBytes(folder_ + name);
    if (!bytes) return bytes.error();
    return parseUff58(*bytes, name);
  }
  std::string folder_ = STILLCUT_SHARED_DIR "/recordings/uff_format_samples/";
};

TEST_F(Uff58Files, BinarySingleMicrophone) {
  const auto sets = load("Sample_UFF58b_bin.uff");
  ASSERT_TRUE(sets.ok()) << sets.error().line();
  const Uff58Dataset& set = sets->front();
  EXPECT_EQ(set.y.size(), 79292u);
  EXPECT_EQ(set.function, Uff58Function::TimeResponse);
  EXPECT_EQ(set.ordinate.quantity, static_cast<Uff58Quantity>(21));
  EXPECT_EQ(set.ordinate.unit, "Pa");
  EXPECT_EQ(set.responseName, "Mic 01");
  EXPECT_NEAR(1.0 / (set.x[1] - set.x[0]), 65536.0, 0.7);  // 6 digits of the step
}

TEST_F(Uff58Files, BinaryDoubleSines) {
  const auto sets = load("binary8byte.uff");
  ASSERT_TRUE(sets.ok()) << sets.error().line();
  const Uff58Dataset& set = sets->front();
  ASSERT_EQ(set.y.size(), 250u);
  for (std::size_t i = 0; i < 250; ++i) EXPECT_NEAR(set.y[i].real(), std::sin(2 * M_PI * 5.0 * set.x[i]), 1e-5) << i;
}

TEST_F(Uff58Files, AsciiSpectrumAndOddHeaders) {
  const auto psd = load("sample_dataset58_psd.uff");
  ASSERT_TRUE(psd.ok()) << psd.error().line();
  EXPECT_EQ(psd->front().y.size(), 3201u);
  EXPECT_EQ(psd->front().function, Uff58Function::PowerSpectralDensity);
  EXPECT_EQ(psd->front().x[3], 3.0);
  EXPECT_DOUBLE_EQ(psd->front().y[3].real(), 3.803099e-6);
  const auto bytes = load("non_ascii_header.uff");
  ASSERT_TRUE(bytes.ok()) << bytes.error().line();
  ASSERT_EQ(bytes->front().y.size(), 6u);
  EXPECT_TRUE(bytes->front().complex);
  EXPECT_DOUBLE_EQ(bytes->front().y[5].imag(), 2.93363);
  const auto partial = load("time-history-not-all-columns-filled.uff");
  ASSERT_TRUE(partial.ok()) << partial.error().line();
  EXPECT_EQ(partial->front().y.size(), 13u);
  EXPECT_DOUBLE_EQ(partial->front().y[12].real(), -5.84096);
}

TEST_F(Uff58Files, CutOffMilestoneFileIsRefusedByName) {
  const auto sets = load("dataset_milestone_in_header.uff");
  ASSERT_FALSE(sets.ok());
  EXPECT_NE(sets.error().line().find("2508876 points"), std::string::npos) << sets.error().line();
}

}  // namespace
}  // namespace stillcut::uff
