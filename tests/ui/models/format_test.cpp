#include "ui/base/format.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/reason_codes.h"
#include "tests/ui/support/ui_fixture.h"
#include "ui/base/reason_text.h"

namespace stillcut::ui {
namespace {

const QString kThin(kThousandsSpace), kFixed(QChar(0x00a0)), kMinus(QChar(0x2212));

TEST(Format, ThousandsAreApartByAThinSpace) {
  EXPECT_EQ(number(999), "999");
  EXPECT_EQ(number(1713), "1" + kThin + "713");
  EXPECT_EQ(number(1234567.891, 1), "1" + kThin + "234" + kThin + "567.9");
}

TEST(Format, MinusIsAMinusAndZeroHasNone) {
  EXPECT_EQ(number(-235), kMinus + "235");
  EXPECT_EQ(number(-0.2), "0");
  EXPECT_EQ(withSign(235), "+235");
  EXPECT_EQ(withSign(-235), kMinus + "235");
}

TEST(Format, WhatIsNoNumberIsADash) {
  const QString dash(QChar(0x2013));
  EXPECT_EQ(number(std::nan("")), dash);
  EXPECT_EQ(significant(INFINITY), dash);
  EXPECT_EQ(duration(Seconds(std::nan(""))), dash);
}

TEST(Format, SignificantDigitsAreNotMoreThanTrue) {
  EXPECT_EQ(significant(0.0623), "0.062");
  EXPECT_EQ(significant(3.14159), "3.1");
  EXPECT_EQ(significant(31.4159), "31");
  EXPECT_EQ(significant(0.0), "0");
}

TEST(Format, FrequencyIsRoundedToItsDoubt) {
  EXPECT_EQ(frequency(Hertz(1712.8), Hertz(1.6)), "1" + kThin + "713" + kFixed + "\u00b12" + kFixed + "Hz");
  EXPECT_EQ(frequency(Hertz(1712.8), Hertz(23)), "1" + kThin + "710" + kFixed + "\u00b130" + kFixed + "Hz");
  EXPECT_EQ(frequency(Hertz(1712.8), Hertz(140)), "1" + kThin + "700" + kFixed + "\u00b1200" + kFixed + "Hz");
  EXPECT_TRUE(frequency(Hertz(1712.8), Hertz()).startsWith("about"));
  EXPECT_TRUE(frequency(Hertz(), Hertz(1)).isEmpty());
}

TEST(Format, DurationsChangeTheirUnit) {
  EXPECT_EQ(duration(Seconds(0.038)), "38" + kFixed + "ms");
  EXPECT_EQ(duration(Seconds(0.9997)), "1.0" + kFixed + "s");
  EXPECT_EQ(duration(Seconds(12.4)), "12" + kFixed + "s");
  EXPECT_EQ(duration(Seconds(125)), "2" + kFixed + "min" + kFixed + "05" + kFixed + "s");
  EXPECT_EQ(duration(Seconds(33'640)), "9" + kFixed + "h" + kFixed + "20" + kFixed + "min");
  EXPECT_EQ(stopwatch(Seconds(760)), "00:12:40");
}

TEST(Format, LongNamesMayBeBrokenAndReadTheSame) {
  const QString name = QStringLiteral("Housing-7-second_operation_of_something.h5");
  const QString broken = breakable(name);
  EXPECT_EQ(QString(broken).remove(QChar(0x200b)), name);
  for (const QString& part : broken.split(QChar(0x200b))) EXPECT_LE(part.size(), 16) << part.toStdString();
  EXPECT_EQ(breakable({}), QString());
}

TEST(ReasonText, FillsNumbersAsTheScreensWriteThem) {
  const QString text = reasonText({ReasonCode::CentreOfNextPocket, {8565, 3, 1713, 8800}});
  EXPECT_TRUE(text.contains("8" + kThin + "565 rpm")) << text.toStdString();
  EXPECT_FALSE(text.contains('{'));
  EXPECT_TRUE(reasonText({}).isEmpty());
}

TEST(ReasonText, EveryReasonFillsAllItsPlaces) {
  for (int code = 1; test::isReason(code); ++code) {
    const QString text = reasonText({static_cast<ReasonCode>(code), {1, 2, 3, 4}});
    EXPECT_FALSE(text.isEmpty()) << code;
    EXPECT_FALSE(text.contains('{')) << text.toStdString();
    EXPECT_TRUE(text.front().isUpper() || !text.front().isLetter()) << text.toStdString();
  }
}

class ThemeTest : public UiTest, public testing::WithParamInterface<ThemeKind> {};

double luminance(const QColor& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

// WCAG 2.1, 1.4.3: 4.5 for text.
TEST_P(ThemeTest, TextIsReadableOnEverySurface) {
  const ThemeColors c = themeColors(GetParam());
  const Theme theme = makeTheme(GetParam(), 1.0);
  for (const QColor& surface : {c.window, c.panel, c.raised}) {
    EXPECT_GE(contrast(c.text, surface), 7.0);
    EXPECT_GE(contrast(c.secondary, surface), 4.5);
  }
  for (const Tone tone : {Tone::Normal, Tone::Faint, Tone::Onset, Tone::Chatter, Tone::Advice}) {
    EXPECT_GE(contrast(theme.front(tone), theme.back(tone)), 4.5) << static_cast<int>(tone);
    EXPECT_GE(contrast(theme.onPanel(tone), c.panel), 4.5) << static_cast<int>(tone);
  }
}

TEST_P(ThemeTest, DigitsAreAllOfOneWidth) {
  for (const bool bold : {false, true}) {
    const QFontMetricsF metrics(makeTheme(GetParam(), 1.0).font(96, bold));
    for (QChar digit = u'0'; digit <= u'9'; digit = QChar(digit.unicode() + 1)) {
      EXPECT_NEAR(metrics.horizontalAdvance(digit), metrics.horizontalAdvance(u'0'), 0.01) << digit.toLatin1();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ThemeTest, testing::Values(ThemeKind::Light, ThemeKind::Dark, ThemeKind::HighContrast));

// Three metres: capitals of 15 mm, 54 px on a 24-inch screen of 1920 x 1080.
TEST_F(UiTest, VerdictIsReadableAtThreeMetres) {
  const Theme theme = makeTheme(ThemeKind::Light, scaleForSize(1280, 800));
  EXPECT_GE(QFontMetricsF(theme.font(type_size::kVerdict, true)).capHeight(), 54.0);
}

TEST(Theme, GrowsWithTheWindowInSteps) {
  EXPECT_EQ(scaleForSize(1280, 800), 1.0);
  EXPECT_EQ(scaleForSize(1024, 768), 0.8) << "narrow: smaller, as pages do not scroll sideways";
  EXPECT_EQ(scaleForSize(800, 480), 0.8);
  EXPECT_EQ(scaleForSize(1280, 720), 1.0) << "low: pages scroll";
  EXPECT_EQ(scaleForSize(1920, 1080), 1.25);
  EXPECT_EQ(scaleForSize(3840, 2160), 2.5);
}

}  // namespace
}  // namespace stillcut::ui
