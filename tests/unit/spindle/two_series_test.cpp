// The spindle told from the chatter by two line series of one spacing, and full chatter by what stands off the orders.
#include "core/spindle/two_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/dsp/spectrum.h"
#include "core/milling/simulation/noise.h"
#include "core/spindle/series_watch.h"
#include "core/spindle/speed_belief.h"

namespace stillcut::detect {
namespace {

constexpr double kSpindle = 168.35;  // Hz

SpectralLine line(double hertz, double power) {
  return {Hertz(hertz), power, static_cast<std::size_t>(hertz), false};
}

// Orders 1 to 29, chatter f_c with side lines a turn away, 20 dB louder.
std::vector<SpectralLine> slot(double spindle, double order) {
  std::vector<SpectralLine> all;
  for (int n = 1; n < 30; ++n) all.push_back(line(n * spindle, 0.01));
  for (int k = -3; k <= 3; ++k) all.push_back(line((order + k) * spindle, k == 0 ? 1.0 : 0.05));
  return all;
}

TEST(LineList, FindsLinesAndTheirPlaceAndLittleElseInNoise) {
  constexpr int kWindow = 8192;
  constexpr double kRate = 10000.0;
  dsp::Spectrum spectrum;
  spectrum.prepare(kWindow, Hertz(kRate), dsp::WindowKind::Hann);
  milling::NoiseSource noise(3);
  std::vector<double> x(kWindow);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = static_cast<double>(i) / kRate;
    x[i] = std::sin(kTwoPi * 733.4 * t) + 0.1 * std::sin(kTwoPi * 1500.7 * t) + 0.1 * noise.normal();
  }
  spectrum.transform(x);
  std::vector<double> powers(static_cast<std::size_t>(spectrum.bins()));
  spectrum.powers(powers);
  LineList list;
  list.prepare(spectrum.bins(), Hertz(spectrum.binWidth()));
  list.find(powers, Hertz(50.0), Hertz(4000.0));
  ASSERT_GE(list.lines().size(), 2U);
  EXPECT_LE(list.lines().size(), 4U);
  EXPECT_NEAR(list.lines()[0].frequency.value, 733.4, 0.1);
  EXPECT_NEAR(list.lines()[1].frequency.value, 1500.7, 0.2);
}

TEST(TwoSeries, FitTheSpindleAndNotTheSpeedWhoseOrderIsTheChatter) {
  TwoSeries series;
  series.begin(Hertz(1.2));
  series.add(slot(kSpindle, 7.816));
  const double right = series.fit(Hertz(kSpindle)).score;
  EXPECT_GT(right, series.fit(Hertz(7.816 * kSpindle / 8.0)).score + 10.0);
  EXPECT_GT(right, series.fit(Hertz(1.01 * kSpindle)).score + 10.0);
  EXPECT_NEAR(series.fit(Hertz(kSpindle)).offset, -0.184, 0.02);
}

TEST(TwoSeries, ShareOfChatterAndOfAStableCut) {
  TwoSeries series;
  series.begin(Hertz(1.2));
  std::vector<SpectralLine> lines = slot(kSpindle, 7.816);
  series.add(lines);
  const FreeFamily chatter = series.freeOf(lines, Hertz(kSpindle), 1e-4);
  EXPECT_NEAR(chatter.share, 1.3 / 1.59, 0.01);
  EXPECT_NEAR(chatter.line.value, 7.816 * kSpindle, 1e-9);
  EXPECT_EQ(chatter.members, 7);
  lines.resize(29);
  EXPECT_NEAR(series.freeOf(lines, Hertz(kSpindle), 1e-4).share, 0.0, 1e-6);
}

TEST(TwoSeries, AMachinesLineCountsForNothing) {
  TwoSeries series;
  series.begin(Hertz(1.2));
  std::vector<SpectralLine> lines = slot(kSpindle, 7.816);
  lines.resize(29);
  lines.push_back(line(538.0, 100.0));
  lines.back().machines = true;
  series.add(lines);
  EXPECT_EQ(series.lines(), 29);
  EXPECT_NEAR(series.freeOf(lines, Hertz(kSpindle), 1e-4).share, 0.0, 1e-6);
}

TEST(SpeedBelief, FindsTheSpindleToldTwoPerCentWrong) {
  for (const double error : {-0.02, 0.0, 0.02}) {
    TwoSeries series;
    series.begin(Hertz(1.2));
    series.add(slot(kSpindle, 7.816));
    SpeedBelief belief;
    belief.prepare(0.036);
    belief.begin(0.01);
    EXPECT_FALSE(belief.certain());
    const double told = kSpindle * (1.0 + error);
    for (int look = 0; look < 5; ++look) belief.look(series, Hertz(told), Seconds(0.1));
    EXPECT_TRUE(belief.certain()) << error;
    EXPECT_NEAR(told * belief.ratio(), kSpindle, 5e-4 * kSpindle) << error;
  }
}

TEST(SpeedBelief, GivesUpWhatItKnewWhereThreeLooksFitAnotherSpeedByFar) {
  SpeedBelief belief;
  belief.prepare(0.036);
  belief.begin(0.01);
  const auto look = [&](double spindle) {
    TwoSeries series;
    series.begin(Hertz(1.2));
    series.add(slot(spindle, 7.816));
    belief.look(series, Hertz(kSpindle), Seconds(0.1));
  };
  for (int i = 0; i < 40; ++i) look(kSpindle);
  EXPECT_NEAR(belief.ratio(), 1.0, 5e-4);
  for (int i = 0; i < 3; ++i) look(0.98 * kSpindle);
  EXPECT_NEAR(belief.ratio(), 0.98, 5e-4);
}

TEST(SpeedBelief, KnowsASpeedThatItThoughtLikelyFromOneThatIsNew) {
  SpeedBelief belief;
  belief.prepare(0.036);
  belief.begin(0.01);
  const auto look = [&](double spindle) {
    TwoSeries series;
    series.begin(Hertz(1.2));
    series.add(slot(spindle, 7.816));
    belief.look(series, Hertz(kSpindle), Seconds(0.1));
  };
  look(0.99 * kSpindle);  // within what is thought of any told speed
  EXPECT_TRUE(belief.newestWasLikely());
  for (int i = 0; i < 10; ++i) look(0.99 * kSpindle);
  EXPECT_TRUE(belief.newestWasLikely());
  look(1.01 * kSpindle);
  EXPECT_NEAR(belief.ofNewest(), 1.01, 5e-4);
  EXPECT_FALSE(belief.newestWasLikely());
}

// Of a whole signal, as the conditioner hands it over: air with a tone of the machine's, then a cut.
struct Heard {
  SeriesLook look;
  SeriesLook first;  // of those that are of the cut alone
  void listen(double chatter, double tone) {
    constexpr double kRate = 12000.0;
    CutSetup setup;
    setup.rate = Hertz(kRate);
    setup.teeth = 2;
    setup.nominalSpeed = Rpm(60.0 * kSpindle);
    setup.channels.resize(1);
    setup.blockFrames = 12;
    SeriesWatch watch;
    watch.prepare(setup, 0.03);
    milling::NoiseSource noise(1);
    std::vector<double> x(12);
    for (int block = 0; block < 2500; ++block) {
      const bool cut = block >= 1000;
      if (block == 1000) watch.beginCut();
      for (std::size_t i = 0; i < x.size(); ++i) {
        const double t = (12.0 * block + static_cast<double>(i)) / kRate;
        x[i] = 0.01 * noise.normal() + tone * std::sin(kTwoPi * 538.0 * t);
        if (!cut) continue;
        for (int n = 1; n < 20; ++n) x[i] += (n % 2 == 0 ? 0.1 : 0.05) / n * std::sin(kTwoPi * n * kSpindle * t + n);
        for (int k = -1; k <= 1; ++k) {
          x[i] += chatter * (k == 0 ? 1.0 : 0.2) * std::sin(kTwoPi * (7.816 + k) * kSpindle * t);
        }
      }
      const double* row = x.data();
      watch.push(&row, 12, !cut);
      if (!watch.due()) continue;
      watch.look(Hertz(kSpindle), 0.01);
      if (cut && !first.whole) first = watch.newest();
    }
    look = watch.newest();
  }
};

TEST(SeriesWatch, HearsChatterFromTheEntryAndItsSpeed) {
  Heard heard;
  heard.listen(0.3, 0.0);
  EXPECT_TRUE(heard.look.certain && heard.look.teethHeard && heard.look.whole);
  EXPECT_GT(heard.look.joint, 0.8);
  EXPECT_NEAR(heard.look.free.line.value, 7.816 * kSpindle, 0.5);
  EXPECT_NEAR(heard.look.spindle.value, kSpindle, 5e-4 * kSpindle);
}

// What was thought in the air is no speed that the spindle has left.
TEST(SeriesWatch, ASteadySpindleIsSteadyFromTheFirstLookAtACut) {
  Heard heard;
  heard.listen(0.3, 0.0);
  EXPECT_TRUE(heard.first.whole && heard.first.steady);
}

TEST(SeriesWatch, ALoudToneThatWasThereInTheAirIsTheMachines) {
  Heard heard;
  heard.listen(0.0, 0.3);
  EXPECT_TRUE(heard.look.teethHeard);
  EXPECT_LT(heard.look.free.share, 0.1);
}

}  // namespace
}  // namespace stillcut::detect
