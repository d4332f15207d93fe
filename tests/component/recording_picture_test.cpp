// A recording looked at as a whole: its samples from anywhere, its spectra, and what the signal says of speed and
// teeth.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/evaluate/picture/file_spectra.h"
#include "core/evaluate/picture/sample_store.h"
#include "core/evaluate/picture/signal_guess.h"
#include "tests/support/signals.h"

namespace stillcut::evaluate {
namespace {

constexpr double kRate = 10'000.0;

std::shared_ptr<SampleStore> storeOf(const std::vector<std::vector<float>>& channels) {
  auto store = SampleStore::make(static_cast<int>(channels.size()));
  EXPECT_TRUE(store) << store.error().line();
  std::vector<std::span<const float>> spans(channels.begin(), channels.end());
  EXPECT_TRUE((*store)->append(spans).ok());
  return *store;
}

std::vector<float> tone(double hertz, double amplitude, double seconds) {
  std::vector<float> samples(static_cast<std::size_t>(seconds * kRate));
  for (std::size_t k = 0; k < samples.size(); ++k)
    samples[k] = static_cast<float>(amplitude * std::sin(kTwoPi * hertz * static_cast<double>(k) / kRate));
  return samples;
}

// Frequency and level [dB] of the strongest line of a column.
std::pair<double, double> strongest(const Spectra& spectra, int column) {
  const float* levels = spectra.column(column);
  const float* most = std::max_element(levels, levels + spectra.bins);
  return {static_cast<double>(most - levels) * spectra.binWidth, *most};
}

TEST(SampleStore, GivesBackEachChannelFromAnywhereAndNothingOutside) {
  std::vector<float> one(50'000), two(50'000);
  for (std::size_t k = 0; k < one.size(); ++k) {
    one[k] = static_cast<float>(k);
    two[k] = -static_cast<float>(k);
  }
  const auto store = storeOf({one, two});
  EXPECT_EQ(store->frames(), 50'000);
  std::vector<float> out(40'000);
  ASSERT_TRUE(store->read(1, 5'000, out));
  EXPECT_EQ(out[0], -5'000.0F);
  EXPECT_EQ(out[39'999], -44'999.0F);
  ASSERT_TRUE(store->read(0, 49'999, out));
  EXPECT_EQ(out[0], 49'999.0F);
  EXPECT_TRUE(std::isnan(out[1]));
  ASSERT_TRUE(store->read(0, -2, out));
  EXPECT_TRUE(std::isnan(out[1]));
  EXPECT_EQ(out[2], 0.0F);
  EXPECT_FALSE(store->read(2, 0, out));
}

TEST(FileSpectra, ALineHasItsRmsInEveryWindowLengthAndOverlap) {
  const auto store = storeOf({tone(1250.0, 2.0, 4.0)});
  for (const SpectraWindow window : {SpectraWindow::Hann, SpectraWindow::FlatTop, SpectraWindow::Rectangular}) {
    for (const int length : {512, 4096}) {
      for (const double overlap : {0.0, 0.75}) {
        SpectraRequest request{0, length, window, overlap, Seconds(0.0), Seconds(4.0), 100};
        const auto spectra = spectraOf(*store, Hertz(kRate), request);
        ASSERT_TRUE(spectra);
        ASSERT_GT(spectra->columns, 8);
        const auto [hertz, level] = strongest(*spectra, spectra->columns / 2);
        EXPECT_NEAR(hertz, 1250.0, 0.6 * spectra->binWidth);
        // A line between two bins of a window without a flat top is lower, by 3.9 dB at most.
        EXPECT_NEAR(level, 20.0 * std::log10(std::sqrt(2.0)), window == SpectraWindow::FlatTop ? 0.1 : 4.0);
      }
    }
  }
}

TEST(FileSpectra, AColumnStandsWhereItsSamplesAreAndIsTheStrongestOfThem) {
  std::vector<float> samples(static_cast<std::size_t>(30.0 * kRate), 0.0F);
  const std::vector<float> burst = tone(2000.0, 1.0, 0.05);
  std::copy(burst.begin(), burst.end(), samples.begin() + static_cast<std::ptrdiff_t>(12.0 * kRate));
  const auto store = storeOf({samples});
  SpectraRequest request{0, 256, SpectraWindow::Hann, 0.5, Seconds(0.0), Seconds(30.0), 100};
  const auto whole = spectraOf(*store, Hertz(kRate), request);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->columns, 100);
  int loudest = 0;
  for (int k = 0; k < whole->columns; ++k) {
    if (strongest(*whole, k).second > strongest(*whole, loudest).second) loudest = k;
  }
  EXPECT_NEAR(whole->first.value + loudest * whole->step.value, 12.025, 0.2);
  EXPECT_NEAR(strongest(*whole, loudest).second, -3.0, 0.5) << "merged columns lose nothing";
  EXPECT_EQ(whole->columnAt(Seconds(12.03)), loudest);
  EXPECT_TRUE(whole->samples.empty()) << "too many to give along";

  request.from = Seconds(11.9);
  request.to = Seconds(12.3);
  const auto close = spectraOf(*store, Hertz(kRate), request);
  ASSERT_TRUE(close);
  EXPECT_EQ(close->samples.size(), 4000U);
  EXPECT_EQ(close->firstSample, 119'000);
}

TEST(FileSpectra, WhatIsMissingIsNoLevelAndAStopIsAnError) {
  std::vector<float> samples = tone(1000.0, 1.0, 2.0);
  std::fill(samples.begin() + 8'000, samples.begin() + 12'000, std::nanf(""));
  const auto store = storeOf({samples});
  const SpectraRequest request{0, 512, SpectraWindow::Hann, 0.5, Seconds(0.0), Seconds(2.0), 1000};
  const auto spectra = spectraOf(*store, Hertz(kRate), request);
  ASSERT_TRUE(spectra);
  EXPECT_TRUE(std::isnan(spectra->column(spectra->columnAt(Seconds(1.0)))[51]));
  EXPECT_TRUE(std::isfinite(spectra->column(spectra->columnAt(Seconds(0.3)))[51]));
  EXPECT_FALSE(spectraOf(*store, Hertz(kRate), request, [](double) { return false; }));
}

class Guess : public testing::Test {
 protected:
  SignalGuess guess(const detect::testing::CutSignal& cut, Rpm told, Rpm heard = {}) {
    const auto made = detect::testing::makeCut(cut);
    std::vector<float> samples(made.channels.front().begin(), made.channels.front().end());
    return guessFromSignal(*storeOf({samples}), {Hertz(cut.rate), {0}, told, heard});
  }
};

TEST_F(Guess, ATrueSpeedNearTheToldOneIsFoundWithItsTeeth) {
  detect::testing::CutSignal cut;
  cut.spindle = 101.3;
  cut.seconds = 6.0;
  const SignalGuess found = guess(cut, Rpm(6000.0));
  EXPECT_NEAR(found.speed.value, 60.0 * 101.3, 10.0);
  EXPECT_GT(found.doubt.value, 0.5);
  EXPECT_EQ(found.teeth, 4);
}

TEST_F(Guess, AnUntoldSpeedIsWhatTheDetectorFoundWithItsRivals) {
  detect::testing::CutSignal cut;
  cut.spindle = 101.3;
  cut.seconds = 6.0;
  const SignalGuess found = guess(cut, Rpm(), Rpm(6060.0));
  EXPECT_NEAR(found.speed.value, 60.0 * 101.3, 10.0);
  EXPECT_FALSE(found.speedRivals.empty()) << "half of it fits as well";
  EXPECT_EQ(found.teeth, 0) << "without a speed nobody can count teeth";
  EXPECT_EQ(guess(cut, Rpm()).speed.value, 0.0) << "nothing was told and nothing was found";
}

TEST_F(Guess, ASpeedToldInRevolutionsASecondIsKnownAsThat) {
  detect::testing::CutSignal cut;
  cut.spindle = 101.3;
  cut.seconds = 6.0;
  EXPECT_NEAR(guess(cut, Rpm(101.3)).speed.value, 60.0 * 101.3, 10.0);
  EXPECT_LT(guess(cut, Rpm(87.0)).speed.value, 100.0) << "another number is no speed of it";
  // A slow cutter of four teeth, told as it is.
  cut.spindle = 5.0;
  EXPECT_LT(guess(cut, Rpm(300.0)).speed.value, 320.0);
}

TEST_F(Guess, NoiseSaysNothing) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<float> samples(60'000);
  for (float& v : samples) v = normal(random);
  EXPECT_EQ(guessFromSignal(*storeOf({samples}), {Hertz(kRate), {0}, Rpm(), Rpm(6000.0)}).speed.value, 0.0);
}

}  // namespace
}  // namespace stillcut::evaluate
