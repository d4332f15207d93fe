#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/support/ui_fixture.h"
#include "ui/plots/nice_ticks.h"
#include "ui/plots/spectrogram/colormap.h"
#include "ui/plots/spectrogram/level_range.h"
#include "ui/plots/spectrogram/spectrogram_image.h"
#include "ui/plots/spectrogram/spectrogram_widget.h"
#include "ui/plots/spectrogram/waterfall.h"

namespace stillcut::ui {
namespace {

constexpr std::int64_t kColumnNs = 20'000'000;

SpectrumColumn column(std::uint64_t number, std::int64_t place, float level = -60.0F) {
  SpectrumColumn c;
  c.number = number;
  c.time = instantFromNs(place * kColumnNs);
  c.level_dB.fill(level);
  return c;
}

SpectrogramImage filled(int columns) {
  SpectrogramImage image(Seconds(10));
  image.setAxis(200, Hertz(5000), Hertz(12800));
  for (int k = 0; k < columns; ++k) image.append(column(static_cast<std::uint64_t>(k), k), Tone::Normal);
  return image;
}

// CIE lightness of viridis rises all the way, in nearly even steps.
TEST(Colormap, LightnessRisesEvenly) {
  const auto lightness = [](QRgb c) {
    const auto linear = [](int v) { return std::pow(v / 255.0, 2.2); };
    const double y = 0.2126 * linear(qRed(c)) + 0.7152 * linear(qGreen(c)) + 0.0722 * linear(qBlue(c));
    return 116.0 * std::cbrt(std::max(y, 0.0089)) - 16.0;
  };
  const ColorTable& table = viridis();
  const double whole = lightness(table[255]) - lightness(table[0]);
  for (std::size_t k = 16; k < table.size(); k += 16) {
    const double step = lightness(table[k]) - lightness(table[k - 16]);
    EXPECT_GT(step, 0.4 * whole / 16) << k;
    EXPECT_LT(step, 1.9 * whole / 16) << k;
  }
}

TEST(NiceTicks, AreRoundAndInside) {
  EXPECT_EQ(niceTicks(0, 5000, 6), (std::vector<double>{0, 1000, 2000, 3000, 4000, 5000}));
  EXPECT_EQ(niceTicks(0, 5000, 5), (std::vector<double>{0, 1000, 2000, 3000, 4000}));
  EXPECT_TRUE(niceTicks(1, 1, 5).empty());
  EXPECT_TRUE(niceTicks(0, std::nan(""), 5).empty());
}

TEST(LevelRange, StaysCalmWhileNothingChanges) {
  LevelRange range;
  std::vector<float> levels(512);
  for (std::size_t k = 0; k < levels.size(); ++k) levels[k] = -60.0F + static_cast<float>(k % 7);
  EXPECT_TRUE(range.add(levels));
  int moves = 0;
  for (int k = 0; k < 1000; ++k) {
    levels[10] = -12.0F - static_cast<float>(k % 4);
    moves += range.add(levels) ? 1 : 0;
  }
  EXPECT_LE(moves, 2);
  EXPECT_GE(range.high() - range.low(), 40.0);
  EXPECT_GE(range.high(), -12.0);
}

TEST(LevelRange, ALoudLineIsInsideAtOnce) {
  LevelRange range;
  std::vector<float> levels(512, -60.0F);
  range.add(levels);
  levels[100] = 15.0F;
  EXPECT_TRUE(range.add(levels));
  EXPECT_GE(range.high(), 15.0);
  EXPECT_DOUBLE_EQ(range.place(100.0), 1.0);
  EXPECT_DOUBLE_EQ(range.place(-300.0), 0.0);
}

TEST(LevelRange, IgnoresWhatIsNoNumber) {
  LevelRange range;
  std::vector<float> levels(512, std::numeric_limits<float>::quiet_NaN());
  EXPECT_FALSE(range.add(levels));
  EXPECT_TRUE(std::isfinite(range.low()));
}

TEST(SpectrogramImage, HoldsTenSecondsOfColumns) {
  const SpectrogramImage image = filled(700);
  EXPECT_EQ(image.capacity(), 500);
  EXPECT_EQ(image.cells().size(), 500U);
  EXPECT_EQ(image.image().size(), QSize(500, 200));
}

TEST(SpectrogramImage, LostSamplesLeaveAGapAsLongAsTheyLasted) {
  SpectrogramImage image = filled(10);
  SpectrumColumn late = column(10, 9 + 26);
  late.afterGap = true;
  image.append(late, Tone::Normal);
  ASSERT_EQ(image.cells().size(), 10U + 26U);
  EXPECT_FALSE(image.cells()[10].present);
  EXPECT_FALSE(image.cells()[34].present);
  EXPECT_TRUE(image.cells()[35].present);
  EXPECT_TRUE(image.cells()[35].afterGap);
}

TEST(SpectrogramImage, ColumnsThatTheScreenMissedAreEmptyAndNoGap) {
  SpectrogramImage image = filled(10);
  image.append(column(13, 13), Tone::Normal);
  EXPECT_EQ(image.cells().size(), 14U);
  EXPECT_FALSE(image.cells()[12].present);
  EXPECT_FALSE(image.cells()[12].afterGap) << "hatched is what the device has lost";
}

TEST(SpectrogramImage, JitterOfTheStampsDoesNotAddUp) {
  SpectrogramImage image(Seconds(10));
  image.setAxis(100, Hertz(5000), Hertz(12800));
  for (int k = 0; k < 300; ++k) {
    SpectrumColumn c = column(static_cast<std::uint64_t>(k), k);
    c.time += Duration(k % 3 == 1 ? 400'000 : 0);
    image.append(c, Tone::Normal);
  }
  EXPECT_EQ(image.cells().size(), 300U);
}

TEST(SpectrogramImage, TimeThatGoesBackStartsAfresh) {
  SpectrogramImage image = filled(50);
  image.append(column(0, 0), Tone::Normal);
  image.append(column(1, 1), Tone::Normal);
  EXPECT_EQ(image.cells().size(), 2U);
}

// A line of one bin must show even where a pixel row spans many bins.
TEST(SpectrogramImage, ANarrowLineNeverFallsBetweenTwoRows) {
  for (int bin = 5; bin < kSpectrumBins; bin += 13) {
    SpectrogramImage image(Seconds(10));
    image.setAxis(60, Hertz(12800), Hertz(12800));
    SpectrumColumn a = column(0, 0), b = column(1, 1);
    b.level_dB[static_cast<std::size_t>(bin)] = 0.0F;
    image.append(a, Tone::Normal);
    image.append(b, Tone::Normal);
    int bright = 0;
    for (int y = 0; y < 60; ++y) bright += qGreen(image.image().pixel(image.capacity() - 1, y)) > 180 ? 1 : 0;
    EXPECT_GE(bright, 1) << bin;
  }
}

// Row of the brightest pixel against where its frequency belongs.
TEST(SpectrogramImage, FrequencyRunsUpwards) {
  SpectrogramImage image(Seconds(10));
  image.setAxis(200, Hertz(5000), Hertz(12800));
  SpectrumColumn a = column(0, 0), b = column(1, 1);
  const double f = 1713.0;
  b.level_dB[static_cast<std::size_t>(f / 12800 * kSpectrumBins)] = 0.0F;
  image.append(a, Tone::Normal);
  image.append(b, Tone::Normal);
  int best = 0;
  for (int y = 0; y < 200; ++y) {
    if (qGreen(image.image().pixel(499, y)) > qGreen(image.image().pixel(499, best))) best = y;
  }
  EXPECT_NEAR(best, 200.0 * (1.0 - f / 5000.0), 2.0);
}

class SpectrogramWidgetTest : public UiTest {};

TEST_F(SpectrogramWidgetTest, KeysChangeAxisAndReach) {
  SpectrogramWidget widget;
  widget.resize(640, 260);
  widget.setSpectrumTop(Hertz(12800));
  EXPECT_EQ(widget.visibleTop().value, 5000.0);
  QTest::keyClick(&widget, Qt::Key_PageUp);
  EXPECT_EQ(widget.visibleTop().value, 10000.0);
  QTest::keyClick(&widget, Qt::Key_PageUp);
  EXPECT_EQ(widget.visibleTop().value, 12800.0);
  for (int k = 0; k < 20; ++k) QTest::keyClick(&widget, Qt::Key_PageDown);
  EXPECT_GT(widget.visibleTop().value, 600.0);
  QTest::keyClick(&widget, Qt::Key_X);
  EXPECT_EQ(widget.axis(), SpectrogramWidget::Axis::Order);
  QTest::keyClick(&widget, Qt::Key_X);
  QTest::keyClick(&widget, Qt::Key_X);
  EXPECT_EQ(widget.axis(), SpectrogramWidget::Axis::Hertz);
}

TEST_F(SpectrogramWidgetTest, TheChatterMarkIsDrawnInItsColour) {
  SpectrogramWidget widget;
  const Theme theme = makeTheme(ThemeKind::Light, 1.0);
  widget.applyTheme(theme);
  widget.resize(640, 260);
  widget.setSpectrumTop(Hertz(12800));
  const auto hasRed = [&] {
    const QImage image = widget.grab().toImage();
    for (int y = 0; y < image.height(); ++y) {
      for (int x = image.width() - 60; x < image.width(); ++x) {
        if (image.pixelColor(x, y) == theme.colors.chatter) return true;
      }
    }
    return false;
  };
  EXPECT_FALSE(hasRed());
  widget.setChatter(Hertz(1713), "1713 Hz", Tone::Chatter);
  EXPECT_TRUE(hasRed());
  widget.setPlotState(PlotState::Stale);
  EXPECT_FALSE(hasRed());
}

// Two spectra at two speeds: in hertz their teeth lie apart, in orders under each other.
TEST(Waterfall, OrdersPutTheTeethOfEverySpeedUnderEachOther) {
  const Hertz slow(100.0), fast(150.0);
  const double binWidth = 25.0;
  const auto share = [&](bool orders, Hertz spindle) {
    const WaterfallScale scale{Hertz(0.0), Hertz(3000.0), binWidth, waterfallStretch(orders, spindle, fast)};
    return scale.shareOf(static_cast<int>(4.0 * spindle.value / binWidth));  // fourth order
  };
  EXPECT_NEAR(share(false, slow), 400.0 / 3000.0, 1e-12);
  EXPECT_NEAR(share(false, fast), 600.0 / 3000.0, 1e-12);
  EXPECT_NEAR(share(true, slow), share(true, fast), 1e-12);
  EXPECT_EQ(waterfallStretch(true, Hertz(), fast), 1.0) << "an unknown speed stretches nothing";
  const WaterfallScale stretched{Hertz(300.0), Hertz(3000.0), binWidth, 1.5};
  EXPECT_LE(stretched.shareOf(stretched.first()), 0.0) << "the line begins at the edge";
  EXPECT_GE(stretched.shareOf(stretched.last()), 1.0);
}

}  // namespace
}  // namespace stillcut::ui
