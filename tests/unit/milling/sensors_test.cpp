// One channel of the simulated measurement: bandwidth, noise, echoes, faults.
#include "core/milling/simulation/sensors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stillcut::milling {
namespace {

constexpr double kRate = 10000.0;
constexpr int kFold = 4;

SensorSettings plain() {
  SensorSettings s;
  s.name = "x";
  s.axis = "x";
  return s;
}

// What comes out for `input` of time, at the channel rate.
template <class Input>
std::vector<double> heard(const SensorSettings& settings, Input input, int samples) {
  Sensor sensor(settings, Hertz(kRate), kFold, 9);
  std::vector<double> out;
  for (int i = 0; i < samples; ++i) {
    for (int f = 0; f < kFold; ++f) sensor.push(input((i * kFold + f) / (kRate * kFold)));
    out.push_back(static_cast<double>(sensor.take(i / kRate)));
  }
  return out;
}

double rmsOf(const std::vector<double>& v, std::size_t from) {
  double sum = 0.0;
  for (std::size_t i = from; i < v.size(); ++i) sum += v[i] * v[i];
  return std::sqrt(sum / static_cast<double>(v.size() - from));
}

double response(double hz) {
  SensorSettings s = plain();
  s.gain = 0.02;
  s.bandwidth = Hertz(1000.0);
  const auto v = heard(
      s, [&](double t) { return std::sin(kTwoPi * hz * t); }, 5000);
  return rmsOf(v, 1000) / (0.02 / std::sqrt(2.0));
}

TEST(Sensor, BandwidthIsTheMinusThreeDecibelEdgeOfAFourthOrderFilter) {
  EXPECT_NEAR(response(100.0), 1.0, 0.001);
  EXPECT_NEAR(20.0 * std::log10(response(1000.0)), -3.01, 0.05);
  EXPECT_NEAR(20.0 * std::log10(response(2000.0)), -24.1, 1.0);
}

// What lies above half the rate is kept out before the channel is sampled: 9.9 kHz would come out at 100 Hz.
TEST(Sensor, KeepsOutWhatWouldFoldBack) {
  EXPECT_LT(response(9900.0), 1e-3);
}

TEST(Sensor, NoiseHasItsRms) {
  SensorSettings s = plain();
  s.noise = 0.3;
  EXPECT_NEAR(rmsOf(heard(
                        s, [](double) { return 0.0; }, 20000),
                    0),
              0.3, 0.006);
}

TEST(Sensor, EveryWayOfTheSoundArrivesInItsTimeAndSize) {
  SensorSettings s = plain();
  s.quantity = SensorQuantity::Sound;
  s.echoes = {{Seconds(0.010), 1.0}, {Seconds(0.025), 0.5}, {Seconds(0.040), 0.25}};
  // A click of 0.5 ms: its energy arrives three times.
  const auto v = heard(
      s, [](double t) { return t < 5e-4 ? 1.0 : 0.0; }, 800);
  const auto sumAround = [&](double t) {
    double sum = 0.0;
    const auto at = static_cast<std::size_t>(t * kRate);
    for (std::size_t i = at; i < at + 40; ++i) sum += v[i];
    return sum;
  };
  EXPECT_NEAR(rmsOf(std::vector<double>(v.begin(), v.begin() + 95), 0), 0.0, 1e-9) << "before the direct sound";
  EXPECT_NEAR(sumAround(0.025) / sumAround(0.010), 0.5, 0.01);
  EXPECT_NEAR(sumAround(0.040) / sumAround(0.010), 0.25, 0.01);
}

// An encoder tells whole places: of a speed it leaves the mean, and the doubt of the last place, which the difference
// makes the louder the higher the frequency.
// What was there before a recording begins is no step in it.
TEST(Sensor, BeginsAtRest) {
  SensorSettings s = plain();
  s.quantity = SensorQuantity::SpindleSpeed;
  const auto steady = [](double) { return 8500.0; };
  for (const double v : heard(s, steady, 50)) EXPECT_NEAR(v, 8500.0, 1e-3);
  s.counts = 1 << 24;
  for (const double v : heard(s, steady, 50)) EXPECT_NEAR(v, 8500.0, 0.2);
}

TEST(Sensor, AnEncoderCountsPlaces) {
  SensorSettings s = plain();
  s.quantity = SensorQuantity::SpindleSpeed;
  s.axis.clear();
  s.counts = 1 << 20;
  const double place = 60.0 * kRate / s.counts;  // [rev/min]
  const auto v = heard(
      s, [](double t) { return 8531.0 + 3.0 * std::sin(kTwoPi * 700.0 * t); }, 20000);
  double mean = 0.0;
  std::vector<double> error;
  for (std::size_t i = 100; i < v.size(); ++i) {
    mean += v[i] / static_cast<double>(v.size() - 100);
    EXPECT_NEAR(v[i] / place, std::round(v[i] / place), 1e-3);
  }
  EXPECT_NEAR(mean, 8531.0, 0.01);
  s.counts = 0.0;
  const auto exact = heard(
      s, [](double t) { return 8531.0 + 3.0 * std::sin(kTwoPi * 700.0 * t); }, 20000);
  // The mean over the sample before, half a sample late, of which a sine keeps sinc(f / rate).
  for (std::size_t i = 101; i < v.size(); ++i) error.push_back(v[i] - 0.5 * (exact[i] + exact[i - 1]));
  EXPECT_NEAR(rmsOf(error, 0) / place, std::sqrt(2.0 * (1.0 / 12.0 + 0.25)), 0.05) << "two places, each rounded";
}

TEST(Sensor, FaultsBeginWhenTheyAreDue) {
  SensorSettings s = plain();
  s.fault = SensorFault::Dead;
  s.faultFrom = Seconds(0.1);
  const auto one = [](double) { return 1.0; };
  const auto dead = heard(s, one, 2000);
  EXPECT_NEAR(dead[990], 1.0, 1e-6);
  EXPECT_EQ(dead[1010], 0.0);
  s.fault = SensorFault::Loose;
  const auto loose = heard(s, one, 20000);
  std::vector<double> after(loose.begin() + 2000, loose.end());
  for (double& v : after) v -= 1.0;
  EXPECT_NEAR(loose[990], 1.0, 1e-6);
  EXPECT_GT(rmsOf(after, 0), 0.2) << "its contact comes and goes";
}

}  // namespace
}  // namespace stillcut::milling
