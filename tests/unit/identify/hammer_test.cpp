#include "core/milling/identify/hammer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string_view>

#include "core/base/units.h"
#include "core/milling/identify/hits_by_axis.h"

namespace stillcut::identify {
namespace {

constexpr double kRate = 25600.0;
constexpr double kFrequency = 400.0;
constexpr double kDamping = 0.03;
constexpr double kStiffness = 1e7;

// Half-sine pulses on one mode, integrated with the exact discrete solution of x'' + 2 z w x' + w^2 x = w^2 F / k for
// a force that is linear between samples.
class Structure {
 public:
  explicit Structure(double seconds) : force_(static_cast<std::size_t>(seconds * kRate), 0.0) {}

  void hit(double time, double peak, double width = 1e-3) {
    const auto from = static_cast<std::size_t>(time * kRate);
    const auto length = static_cast<std::size_t>(width * kRate);
    for (std::size_t i = 0; i <= length && from + i < force_.size(); ++i) {
      force_[from + i] += peak * std::sin(kTwoPi / 2 * static_cast<double>(i) / static_cast<double>(length));
    }
  }

  HammerRecord record(double noise = 0.0, unsigned seed = 1) const {
    HammerRecord out;
    out.rate = kRate;
    out.source = "synthetic";
    out.force = force_;
    out.response = acceleration();
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss(0.0, 1.0);
    for (double& v : out.response) v += noise * gauss(random);
    return out;
  }

 private:
  std::vector<double> acceleration() const {
    constexpr int kFine = 16;  // steps per sample: Runge-Kutta error far below 1e-6
    const double w = kTwoPi * kFrequency;
    const double h = 1.0 / kRate / kFine;
    double x = 0.0;
    double v = 0.0;
    std::vector<double> out;
    const auto a = [&](double f, double px, double pv) {
      return w * w * (f / kStiffness - px) - 2 * kDamping * w * pv;
    };
    for (std::size_t i = 0; i < force_.size(); ++i) {
      out.push_back(a(force_[i], x, v));
      const double next = i + 1 < force_.size() ? force_[i + 1] : 0.0;
      for (int k = 0; k < kFine; ++k) {
        const double f0 = force_[i] + (next - force_[i]) * k / kFine;
        const double f1 = force_[i] + (next - force_[i]) * (k + 1) / kFine;
        const double mid = 0.5 * (f0 + f1);
        const double k1x = v, k1v = a(f0, x, v);
        const double k2x = v + h / 2 * k1v, k2v = a(mid, x + h / 2 * k1x, v + h / 2 * k1v);
        const double k3x = v + h / 2 * k2v, k3v = a(mid, x + h / 2 * k2x, v + h / 2 * k2v);
        const double k4x = v + h * k3v, k4v = a(f1, x + h * k3x, v + h * k3v);
        x += h / 6 * (k1x + 2 * k2x + 2 * k3x + k4x);
        v += h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
      }
    }
    return out;
  }
  std::vector<double> force_;
};

std::complex<double> exact(double f, double decay = 0.0) {
  const double w = kTwoPi * kFrequency;
  const std::complex<double> s(decay, kTwoPi * f);
  return w * w / kStiffness / (s * s + 2.0 * kDamping * w * s + w * w);
}

double worstError(const Frf& frf, double from, double to) {
  const Frf compliance = toCompliance(frf);
  double worst = 0.0;
  for (std::size_t i = 0; i < compliance.frequency.size(); ++i) {
    const double f = compliance.frequency[i];
    if (f < from || f > to) continue;
    const auto truth = exact(f, frf.addedDecay);
    worst = std::max(worst, std::abs(compliance.value[i] - truth) / std::abs(truth));
  }
  return worst;
}

TEST(Hammer, OneHitGivesTheExactResponse) {
  Structure s(1.0);
  s.hit(0.1, 200.0);
  const auto got = analyseHammer({s.record()}, {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  ASSERT_EQ(got->hits.size(), 1u);
  EXPECT_TRUE(got->hits[0].used);
  EXPECT_NEAR(got->hits[0].time, 0.1005, 1e-4);
  EXPECT_NEAR(got->hits[0].peakForce, 200.0, 1.0);
  EXPECT_NEAR(got->hits[0].width, 2.0 / 3.0 * 1e-3, 1e-4);  // half height of a half sine
  EXPECT_TRUE(got->frf.coherence.empty());
  // Sampling folds what lies above 12.8 kHz back: a pulse of 1 ms has some 1e-4 of its spectrum there.
  EXPECT_LT(worstError(got->frf, 100.0, 1000.0), 5e-3);
  EXPECT_GT(got->frf.usableTo, 1200.0);
}

TEST(Hammer, ExponentialWindowIsPartOfTheResult) {
  Structure s(0.15);  // still ringing at the end
  s.hit(0.01, 200.0);
  HammerOptions options;
  options.exponentialEnd = 1e-3;
  options.forceWindow = 2e-3;
  const auto got = analyseHammer({s.record()}, options);
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_NEAR(got->frf.addedDecay, 6.9 / 0.14, 3.0);
  EXPECT_LT(worstError(got->frf, 200.0, 800.0), 1e-2);
}

TEST(Hammer, AverageOfHitsLowersNoiseAndGivesCoherence) {
  Structure s(5.0);
  for (int i = 0; i < 10; ++i) s.hit(0.1 + 0.5 * i, 150.0 + 10 * i);
  const auto noisy = analyseHammer({s.record(3.0)}, {});
  ASSERT_TRUE(noisy.ok()) << noisy.error().line();
  EXPECT_EQ(noisy->averages, 10);
  ASSERT_EQ(noisy->frf.coherence.size(), noisy->frf.frequency.size());
  const auto at = [&](double f) {
    return noisy->frf.coherence[static_cast<std::size_t>(std::lround(f / noisy->frf.frequency[1]))];
  };
  EXPECT_GT(at(400.0), 0.99);  // resonance: far above the noise
  for (const double c : noisy->frf.coherence) EXPECT_TRUE(c >= 0.0 && c <= 1.0);
  Structure one(0.5);
  one.hit(0.1, 190.0);
  const auto single = analyseHammer({one.record(3.0)}, {});
  ASSERT_TRUE(single.ok());
  EXPECT_LT(worstError(noisy->frf, 300.0, 500.0), 0.6 * worstError(single->frf, 300.0, 500.0));
}

TEST(Hammer, DoubleHitIsLeftOutAndNamed) {
  Structure s(2.0);
  s.hit(0.1, 200.0);
  s.hit(1.0, 200.0);
  s.hit(1.02, 60.0);
  const auto got = analyseHammer({s.record()}, {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  ASSERT_EQ(got->hits.size(), 2u);
  EXPECT_FALSE(got->hits[0].doubleHit);
  EXPECT_TRUE(got->hits[1].doubleHit);
  EXPECT_FALSE(got->hits[1].used);
  EXPECT_EQ(got->averages, 1);
  EXPECT_EQ(text(got->remarks.front()), "hit 2 left out: double hit");
  HammerOptions keep;
  keep.useDoubleHits = true;
  EXPECT_EQ(analyseHammer({s.record()}, keep)->averages, 2);
}

TEST(Hammer, WeakReboundIsADoubleHitToo) {
  Structure s(1.0);
  s.hit(0.1, 200.0);
  s.hit(0.13, 14.0);  // below the trigger, above the 4 % that matter
  const auto got = analyseHammer({s.record()}, {});
  ASSERT_FALSE(got.ok());
  EXPECT_NE(got.error().line().find("double hit"), std::string::npos) << got.error().line();
}

// A hit of 0.25 ms has six samples, and a flat top of three.
TEST(Hammer, AShortHitThatIsClippedIsOverloadAndARoundOneIsNot) {
  for (const double width : {0.24e-3, 0.28e-3, 0.32e-3, 1e-3}) {  // samples even on both sides of the peak, and not
    Structure s(1.0);
    s.hit(0.1, 200.0, width);
    EXPECT_TRUE(analyseHammer({s.record()}, {}).ok()) << width;
    HammerRecord clipped = s.record();
    for (double& v : clipped.force) v = std::min(v, 100.0);
    EXPECT_FALSE(analyseHammer({clipped}, {}).ok()) << width;
    // The accelerometer is at its limit for one or two samples at a time, and again and again.
    HammerRecord response = s.record();
    double most = 0.0;
    for (const double v : response.response) most = std::max(most, std::abs(v));
    for (double& v : response.response) v = std::clamp(v, -0.5 * most, 0.5 * most);
    EXPECT_FALSE(analyseHammer({response}, {}).ok()) << width;
  }
}

TEST(Hammer, OverloadIsSeenByItsFlatTopOrByTheLimit) {
  Structure s(1.0);
  s.hit(0.1, 200.0, 2e-3);
  HammerRecord clipped = s.record();
  for (double& v : clipped.force) v = std::min(v, 150.0);
  const auto flat = analyseHammer({clipped}, {});
  ASSERT_FALSE(flat.ok());
  EXPECT_NE(flat.error().line().find("overload"), std::string::npos) << flat.error().line();
  HammerOptions limit;
  limit.overload = 180.0;
  EXPECT_FALSE(analyseHammer({s.record()}, limit).ok());
  limit.overload = 1e9;
  EXPECT_TRUE(analyseHammer({s.record()}, limit).ok());
  HammerRecord accelerometer = s.record();
  for (double& v : accelerometer.response) v = std::clamp(v, -40.0, 40.0);
  EXPECT_FALSE(analyseHammer({accelerometer}, {}).ok());
}

bool says(const HammerResult& result, std::string_view what) {
  return std::any_of(result.remarks.begin(), result.remarks.end(),
                     [what](const Message& m) { return text(m).find(what) != std::string::npos; });
}

TEST(Hammer, AForceThatCountsAPushAsNegativeIsTurnedAndSaid) {
  Structure s(0.5);
  s.hit(0.1, 200.0);
  HammerRecord record = s.record();
  for (double& v : record.force) v = -v;
  HammerOptions flip;
  flip.flipForce = true;
  for (const HammerOptions& options : {HammerOptions{}, flip}) {
    const auto got = analyseHammer({record}, options);
    ASSERT_TRUE(got.ok()) << got.error().line();
    EXPECT_LT(worstError(got->frf, 100.0, 1000.0), 5e-3);
    EXPECT_EQ(says(*got, "negative: turned"), !options.flipForce);
  }
}

TEST(Hammer, AnAccelerometerAgainstTheForceIsTurnedAndSaid) {
  Structure s(0.5);
  s.hit(0.1, 200.0);
  HammerRecord record = s.record();
  for (double& v : record.response) v = -v;
  const auto got = analyseHammer({record}, {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_LT(worstError(got->frf, 100.0, 1000.0), 5e-3);
  EXPECT_TRUE(says(*got, "points against the force: turned"));
  EXPECT_FALSE(says(*analyseHammer({s.record()}, {}), "turned"));
}

TEST(Hammer, OneRecordOfSeveralWithItsSensorTurnedIsTurnedAlone) {
  Structure s(0.5);
  s.hit(0.1, 200.0);
  std::vector<HammerRecord> records{s.record(1.0, 1), s.record(1.0, 2), s.record(1.0, 3)};
  records[1].source = "second";
  for (double& v : records[1].response) v = -v;
  const auto got = analyseHammer(records, {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_LT(worstError(got->frf, 350.0, 450.0), 0.02);
  EXPECT_TRUE(says(*got, "against the force in second, and not in the other records: turned there"));
}

TEST(Hammer, AnOffsetOfEitherChannelIsTakenOff) {
  Structure s(1.0);
  s.hit(0.1, 200.0);
  HammerRecord record = s.record();
  for (double& v : record.force) v += 60.0;
  for (double& v : record.response) v -= 30.0;
  const auto got = analyseHammer({record}, {});
  ASSERT_TRUE(got.ok()) << got.error().line();
  EXPECT_NEAR(got->hits[0].peakForce, 200.0, 1.0);
  EXPECT_LT(worstError(got->frf, 100.0, 1000.0), 5e-3);
  EXPECT_FALSE(says(*got, "still rings"));
}

TEST(Hammer, ARecordThatBeginsInsideThePulseIsLeftOut) {
  Structure s(1.0);
  s.hit(0.1, 200.0);
  HammerRecord record = s.record();
  const auto rises = static_cast<std::ptrdiff_t>(0.1 * kRate) + 5;  // of 25 samples
  record.force.erase(record.force.begin(), record.force.begin() + rises);
  record.response.erase(record.response.begin(), record.response.begin() + rises);
  const auto cut = analyseHammer({record}, {});
  ASSERT_FALSE(cut.ok());
  EXPECT_NE(cut.error().line().find("begins inside the pulse"), std::string::npos) << cut.error().line();
  const auto both = analyseHammer({s.record(), record}, {});
  ASSERT_TRUE(both.ok()) << both.error().line();
  EXPECT_EQ(both->averages, 1);
  EXPECT_TRUE(says(*both, "hit 2 left out: the record begins inside the pulse"));
}

TEST(Hammer, HitsAlongXAndAlongYInOneRecordAreToldApart) {
  std::vector<Hit> x(3), y(3);
  for (std::size_t i = 0; i < 3; ++i) {
    x[i].time = y[i].time = static_cast<double>(i);
    x[i].response = i < 2 ? 10.0 : 1.5;
    y[i].response = i < 2 ? 1.0 : 12.0;
  }
  const auto out = hitsAlongOther(x, y);
  EXPECT_EQ(out[0], std::vector<int>{3});
  EXPECT_EQ(out[1], (std::vector<int>{1, 2}));
  x[1].response = 1.2;
  EXPECT_TRUE(hitsAlongOther(x, y)[0].empty()) << "one hit moved both alike";
  x[1].response = x[2].response = 100.0;
  EXPECT_TRUE(hitsAlongOther(x, y)[0].empty()) << "all went along x";
}

TEST(Hammer, HitsOfSeveralRecordsAreAveragedAndNumberedOn) {
  Structure first(1.0);
  first.hit(0.1, 200.0);
  Structure second(1.2);
  second.hit(0.2, 150.0);
  second.hit(0.7, 100.0);
  const std::vector<HammerRecord> records{first.record(1.0, 1), second.record(1.0, 2)};
  const auto all = analyseHammer(records, {});
  ASSERT_TRUE(all.ok()) << all.error().line();
  EXPECT_EQ(all->averages, 3);
  EXPECT_EQ(all->hits[2].record, 1u);
  EXPECT_FALSE(all->frf.coherence.empty());
  HammerOptions without;
  without.without = {2};
  const auto fewer = analyseHammer(records, without);
  ASSERT_TRUE(fewer.ok()) << fewer.error().line();
  EXPECT_EQ(fewer->averages, 2);
  EXPECT_FALSE(fewer->hits[1].used);
  EXPECT_TRUE(says(*fewer, "hit 2 left out: as asked"));
  without.without = {4};
  EXPECT_EQ(analyseHammer(records, without).error().line(), "synthetic: there is no hit 4 (it holds 3 hits)");
  std::vector<HammerRecord> other = records;
  other[1].rate *= 2.0;
  EXPECT_FALSE(analyseHammer(other, {}).ok());
}

TEST(Hammer, TheTwoEstimatesEncloseTheTruthWhereTheResponseIsNoisy) {
  Structure s(5.0);
  for (int i = 0; i < 10; ++i) s.hit(0.1 + 0.5 * i, 150.0 + 10 * i);
  HammerOptions second;
  second.estimate = FrfEstimate::H2;
  const auto h1 = analyseHammer({s.record(20.0)}, {});
  const auto h2 = analyseHammer({s.record(20.0)}, second);
  ASSERT_TRUE(h1.ok() && h2.ok());
  // |H1| = coherence |H2| on every line; at the resonance H1 is the one without bias.
  for (std::size_t k = 10; k < 1000; ++k) {
    EXPECT_NEAR(std::abs(h1->frf.value[k]), h1->frf.coherence[k] * std::abs(h2->frf.value[k]),
                1e-6 * std::abs(h2->frf.value[k]));
  }
}

TEST(Hammer, ARingingThatIsCutOffIsSaid) {
  Structure s(0.03);
  s.hit(0.005, 200.0);
  const auto cut = analyseHammer({s.record()}, {});
  ASSERT_TRUE(cut.ok()) << cut.error().line();
  EXPECT_TRUE(says(*cut, "still rings"));
  HammerOptions window;
  window.exponentialEnd = 0.01;
  EXPECT_FALSE(says(*analyseHammer({s.record()}, window), "still rings"));
}

TEST(Hammer, NonsenseIsRefused) {
  Structure s(0.5);
  s.hit(0.1, 200.0);
  HammerRecord bad = s.record();
  bad.rate = 0.0;
  EXPECT_FALSE(analyseHammer({bad}, {}).ok());
  bad = s.record();
  bad.response.pop_back();
  EXPECT_FALSE(analyseHammer({bad}, {}).ok());
  bad = s.record();
  bad.response[7] = NAN;
  EXPECT_FALSE(analyseHammer({bad}, {}).ok());
  bad = s.record();
  std::fill(bad.force.begin(), bad.force.end(), 0.0);
  EXPECT_FALSE(analyseHammer({bad}, {}).ok());
  HammerOptions options;
  options.exponentialEnd = 0.0;
  EXPECT_FALSE(analyseHammer({s.record()}, options).ok());
}

}  // namespace
}  // namespace stillcut::identify
