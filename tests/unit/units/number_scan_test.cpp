#include "core/units/number_scan.h"

#include <gtest/gtest.h>

namespace stillcut::uff {
namespace {

TEST(NumberScan, ReadsTheWaysInstrumentsWriteNumbers) {
  EXPECT_EQ(wholeNumber("7.735887e-001"), 0.7735887);
  EXPECT_EQ(wholeNumber(" -1.5D+02 "), -150.0);
  EXPECT_EQ(wholeNumber("+4"), 4.0);
  EXPECT_EQ(wholeNumber("1.5-103"), 1.5e-103);
  EXPECT_EQ(wholeNumber(".5E1"), 5.0);
  EXPECT_EQ(wholeNumber("1e-400"), 0.0);
}

TEST(NumberScan, RefusesWhatIsNoNumber) {
  for (const char* text : {"", " ", "abc", "1.0x", "1,5", "--1", "e5", "1.5-1234", "0x10"}) {
    EXPECT_FALSE(wholeNumber(text)) << text;
  }
}

TEST(NumberScan, SeparatesFieldsThatTouch) {
  std::string_view text = "-1.0E-003-2.5E+01-3";
  EXPECT_EQ(takeNumber(text), -0.001);
  EXPECT_EQ(takeNumber(text), -25.0);
  EXPECT_EQ(takeNumber(text), -3.0);
  EXPECT_TRUE(text.empty());
}

}  // namespace
}  // namespace stillcut::uff
