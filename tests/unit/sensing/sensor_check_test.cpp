// A second of air, then a cut on two axes, into which one fault after another is put.
#include "core/sensing/sensor_check.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/sensing/conditioner.h"
#include "tests/support/path_counter.h"
#include "tests/support/signals.h"

namespace stillcut::detect {
namespace {

constexpr double kRate = 25600.0;
constexpr double kSpindle = 100.0;
constexpr double kCutBegins = 1.0;
constexpr double kFaultBegins = 3.0;

using Samples = std::vector<std::vector<float>>;  // [channel][frame]

class SensorCheckTest : public ::testing::Test {
 protected:
  static std::size_t frame(double seconds) { return static_cast<std::size_t>(seconds * kRate); }

  static Samples cut(double seconds, double spindle = kSpindle, double growthStart = -1.0) {
    Samples all;
    for (unsigned c = 0; c < 2; ++c) {
      testing::CutSignal s;
      s.rate = kRate;
      s.seconds = seconds;
      s.spindle = spindle;
      s.growthStart = growthStart;
      s.seed = 10 + c;
      std::vector<float> x = testing::makeCut(s).channels[0];
      std::mt19937 engine(20 + c);
      std::normal_distribution<float> noise(0.0F, 0.01F);
      for (std::size_t f = 0; f < x.size(); ++f) x[f] = noise(engine) + (f < frame(kCutBegins) ? 0.0F : x[f]);
      all.push_back(std::move(x));
    }
    return all;
  }

  struct Run {
    std::vector<std::pair<double, Reason>> faults;  // end of each block of which not all was believed
    int invalid = 0;                                // blocks that cannot be judged at all
    SensorStatus status;
    // Time until the first of them; -1: none.
    double first(ReasonCode code) const {
      for (const auto& [t, reason] : faults) {
        if (reason.code == code) return t;
      }
      return -1.0;
    }
    double last() const { return faults.empty() ? -1.0 : faults.back().first; }
  };

  // clock: seconds by the stamps for each second of samples.
  static Run run(const Samples& samples, double spindle = kSpindle, int blockFrames = 256, double clock = 1.0,
                 SensorQuantity second = SensorQuantity::Acceleration,
                 SensorQuantity first = SensorQuantity::Acceleration) {
    CutSetup setup;
    setup.rate = Hertz(kRate);
    setup.blockFrames = blockFrames;
    setup.teeth = 4;
    setup.nominalSpeed = toRpm(Hertz(spindle));
    setup.channels = {{"x", first, 1.0, "x"}, {"y", second, 1.0, "y"}};
    config::ParamSet params;
    Conditioner conditioner;
    conditioner.prepare(setup, params);
    SampleBlock block;
    block.allocate(2, blockFrames);
    block.rate = setup.rate;
    Run out;
    const std::size_t total = samples[0].size();
    for (std::size_t at = 0; at < total; at += static_cast<std::size_t>(block.frames)) {
      block.frames = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(blockFrames), total - at));
      block.firstSample = Instant(toDuration(Seconds(clock * static_cast<double>(at) / kRate)));
      for (int c = 0; c < 2; ++c) {
        const auto from = samples[static_cast<std::size_t>(c)].begin() + static_cast<std::ptrdiff_t>(at);
        std::copy_n(from, block.frames, block.channel(c).begin());
      }
      const test::PathCounter counter;
      const ConditionedBlock& conditioned = conditioner.process(block, {});
      if (test::PathCounter::works()) {
        EXPECT_TRUE(counter.counts().none());
      }
      const Reason& fault = conditioner.sensors().fault;
      if (fault.code != ReasonCode::None)
        out.faults.emplace_back(static_cast<double>(at + static_cast<std::size_t>(block.frames)) / kRate, fault);
      out.invalid += conditioned.valid ? 0 : 1;
      ++block.sequence;
    }
    out.status = conditioner.sensors();
    return out;
  }

  // From kFaultBegins to `end`, channel c's sample f becomes change(x, f).
  static Run faulty(int channel, const std::function<float(float, std::size_t)>& change, double seconds = 6.0,
                    double end = 1e9) {
    Samples samples = cut(seconds);
    auto& x = samples[static_cast<std::size_t>(channel)];
    for (std::size_t f = frame(kFaultBegins); f < x.size() && static_cast<double>(f) < end * kRate; ++f) {
      x[f] = change(x[f], f);
    }
    return run(samples);
  }
  // Found within `within` of its begin, with nothing before.
  static void expectFound(const Run& r, ReasonCode code, double within) {
    EXPECT_GE(r.first(code), kFaultBegins);
    EXPECT_LT(r.first(code), kFaultBegins + within);
    ASSERT_FALSE(r.faults.empty());
    EXPECT_GE(r.faults.front().first, kFaultBegins);
    EXPECT_FALSE(sentence(r.faults.back().second).empty());
  }
};

TEST_F(SensorCheckTest, AGoodCutIsBelievedStableAndChattering) {
  EXPECT_TRUE(run(cut(5.0)).faults.empty());
  EXPECT_TRUE(run(cut(5.0, kSpindle, 2.5)).faults.empty());
  const SensorStatus status = run(cut(3.0)).status;
  EXPECT_NEAR(status.actualRate.value, kRate, 1e-3);
  EXPECT_GT(status.channel[0].rms, 0.5);
  EXPECT_GT(status.channel[0].peak, status.channel[0].rms);
  EXPECT_EQ(status.fault.code, ReasonCode::None);
}

// Gain that jumps and knocks, 300 times a second together, for a second and a half.
TEST_F(SensorCheckTest, ALooseSensorIsFoundAndBelievedAgainOnceItHolds) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  std::normal_distribution<float> normal(0.0F, 8.0F);
  float gain = 1.0F;
  const Run r = faulty(
      0,
      [&](float x, std::size_t) {
        if (uniform(engine) < 0.01F) gain = 0.1F + 0.9F * uniform(engine);
        return gain * x + (uniform(engine) < 0.002F ? normal(engine) : 0.0F);
      },
      7.0, 4.5);
  expectFound(r, ReasonCode::InputLoose, 0.5);
  EXPECT_GT(r.last(), 4.5);  // not given up while it lasts
  EXPECT_LT(r.last(), 6.0);
}

// The same strength and number of knocks, but where the edges enter.
TEST_F(SensorCheckTest, ImpactsOfTheEdgesAreNoLooseSensor) {
  std::mt19937 engine(4);
  std::normal_distribution<float> scatter(8.0F, 0.8F);
  Samples samples = cut(5.0);
  for (double t = kCutBegins; t < 4.9; t += 0.25 / kSpindle) {
    for (auto& x : samples) x[frame(t)] += scatter(engine);
  }
  EXPECT_EQ(run(samples).first(ReasonCode::InputLoose), -1.0);
}

// Silence of eight bits: a last bit that flips now and then.
TEST_F(SensorCheckTest, ACoarseConverterIsNoLooseSensor) {
  Samples samples = cut(4.0);
  for (auto& x : samples) {
    for (float& v : x) v = std::round(v * 17.0F) / 17.0F;
  }
  EXPECT_EQ(run(samples).first(ReasonCode::InputLoose), -1.0);
}

TEST_F(SensorCheckTest, ACableThatBreaksInTheCutIsNoEndOfTheCut) {
  std::mt19937 engine(5);
  std::normal_distribution<float> noise(0.0F, 0.01F);
  const Run broken = faulty(1, [&](float, std::size_t) { return noise(engine); });
  expectFound(broken, ReasonCode::InputSilent, 0.8);
  EXPECT_EQ(broken.faults.back().second.n[0], 1.0);
  EXPECT_GT(broken.last(), 5.9);
  EXPECT_EQ(broken.invalid, 0) << "the other axis goes on";

  Samples ended = cut(6.0);
  for (auto& x : ended) {
    for (std::size_t f = frame(kFaultBegins); f < x.size(); ++f) x[f] = noise(engine);
  }
  EXPECT_TRUE(run(ended).faults.empty());
}

// One accelerometer beside a sensor of another kind: a structure rings on when the tool has left, a cable does not.
TEST_F(SensorCheckTest, ALoneSensorThatFallsSilentAtOnceHasLostItsCable) {
  const auto ended = [](double ring) {
    Samples samples = cut(6.0);
    std::mt19937 engine(8);
    std::normal_distribution<float> noise(0.0F, 0.01F);
    for (std::size_t f = frame(kFaultBegins); f < samples[0].size(); ++f) {
      const double t = static_cast<double>(f) / kRate - kFaultBegins;
      const double rings = ring > 0.0 ? std::exp(-t / ring) : 0.0;
      samples[0][f] = static_cast<float>(rings) * samples[0][f] + noise(engine);
      samples[1][f] = 0.0F;
    }
    return run(samples, kSpindle, 256, 1.0, SensorQuantity::SpindleSpeed);
  };
  const Run broken = ended(0.0);
  expectFound(broken, ReasonCode::InputSilent, 0.9);
  EXPECT_GT(broken.last(), 5.9);
  // Modes of 2 kHz with 5 %, and of 300 Hz with 3 %.
  for (const double ring : {1.0 / (0.05 * kTwoPi * 2000.0), 1.0 / (0.03 * kTwoPi * 300.0)}) {
    EXPECT_EQ(ended(ring).first(ReasonCode::InputSilent), -1.0) << ring;
  }
}

TEST_F(SensorCheckTest, AForceOrASpeedMayRestButNoForceStandsStillInACutOfOthers) {
  Samples still = cut(4.0);
  for (float& v : still[1]) v = 6000.0F;
  const auto with = [&](SensorQuantity second, SensorQuantity first) {
    return run(still, kSpindle, 256, 1.0, second, first);
  };
  for (const auto q : {SensorQuantity::SpindleSpeed, SensorQuantity::Force, SensorQuantity::Current}) {
    EXPECT_TRUE(with(q, SensorQuantity::Acceleration).faults.empty());
  }
  const Run dead = with(SensorQuantity::Force, SensorQuantity::Force);
  EXPECT_GT(dead.first(ReasonCode::InputDead), kCutBegins);
  EXPECT_LT(dead.first(ReasonCode::InputDead), kCutBegins + 1.0);
  EXPECT_EQ(dead.invalid, 0) << "the other axis goes on";
  EXPECT_GT(dead.last(), 3.9);
}

TEST_F(SensorCheckTest, ALostBiasIsAnOffsetAndGravityIsNot) {
  expectFound(faulty(0, [](float x, std::size_t) { return x + 100.0F; }), ReasonCode::InputOffset, 0.8);
  EXPECT_TRUE(faulty(0, [](float x, std::size_t) { return x + 9.81F; }).faults.empty());
}

TEST_F(SensorCheckTest, AnOffsetThatIsThereFromTheStartIsOneAndABiasWithinGravityIsNot) {
  Samples off = cut(4.0);
  for (float& v : off[1]) v -= 60.0F;
  const Run r = run(off);
  EXPECT_GT(r.first(ReasonCode::InputOffset), 0.9);
  EXPECT_LT(r.first(ReasonCode::InputOffset), 2.0);
  Samples biased = cut(4.0);
  for (float& v : biased[1]) v -= 15.0F;
  EXPECT_TRUE(run(biased).faults.empty());
}

TEST_F(SensorCheckTest, MainsHumIsFoundAndASpindleAtFiftyHertzIsNot) {
  const auto hum = [](float x, std::size_t f) {
    const double t = static_cast<double>(f) / kRate;
    return x + static_cast<float>(4.0 * std::sin(kTwoPi * 60.01 * t) + 2.0 * std::sin(kTwoPi * 180.03 * t));
  };
  const Run r = faulty(0, hum, 8.0);
  expectFound(r, ReasonCode::InputHum, 3.5);
  EXPECT_EQ(r.faults.back().second.n[1], 60.0);

  Samples spindle = cut(7.0, 50.0);
  for (auto& x : spindle) {
    for (std::size_t f = frame(kCutBegins); f < x.size(); ++f) {
      x[f] += static_cast<float>(5.0 * std::sin(kTwoPi * 50.0 * static_cast<double>(f) / kRate));
    }
  }
  EXPECT_EQ(run(spindle, 50.0).first(ReasonCode::InputHum), -1.0);
}

TEST_F(SensorCheckTest, LoudNoiseIsNoCut) {
  std::mt19937 engine(6);
  std::normal_distribution<float> noise(0.0F, 1.0F);
  expectFound(faulty(0, [&](float, std::size_t) { return noise(engine); }), ReasonCode::InputNoise, 0.8);
  // Through the filter of an audio converter.
  constexpr int kTaps = 97;
  constexpr double kEnd = 0.907;  // of half the rate
  std::vector<float> taps(kTaps);
  for (int k = 0; k < kTaps; ++k) {
    const double n = k - 0.5 * (kTaps - 1);
    const double window = 0.42 + 0.5 * std::cos(kTwoPi * n / kTaps) + 0.08 * std::cos(2.0 * kTwoPi * n / kTaps);
    const double sinc = n == 0.0 ? kEnd : std::sin(0.5 * kTwoPi * kEnd * n) / (0.5 * kTwoPi * n);
    taps[static_cast<std::size_t>(k)] = static_cast<float>(window * sinc);
  }
  std::vector<float> heard(kTaps, 0.0F);
  expectFound(faulty(0,
                     [&](float, std::size_t f) {
                       heard[f % kTaps] = noise(engine);
                       float sum = 0.0F;
                       for (std::size_t k = 0; k < kTaps; ++k) sum += taps[k] * heard[(f + kTaps - k) % kTaps];
                       return sum;
                     }),
              ReasonCode::InputNoise, 0.8);
}

TEST_F(SensorCheckTest, OneAxisTwiceIsFound) {
  Samples samples = cut(3.0);
  for (std::size_t f = 0; f < samples[1].size(); ++f) samples[1][f] = -2.5F * samples[0][f];
  const Run r = run(samples);
  EXPECT_GT(r.first(ReasonCode::InputDoubled), 0.0);
  EXPECT_LT(r.first(ReasonCode::InputDoubled), 0.5);
  // Two sensors on a part that moves along one line only: the noise is their own.
  Samples line = cut(3.0);
  std::mt19937 engine(7);
  std::normal_distribution<float> noise(0.0F, 0.002F);
  for (std::size_t f = 0; f < line[1].size(); ++f) line[1][f] = line[0][f] + noise(engine);
  EXPECT_EQ(run(line).first(ReasonCode::InputDoubled), -1.0);
}

// Both axes lost: nothing is left to judge by. One of them comes back: it goes on at once.
TEST_F(SensorCheckTest, OnlyWhereNoChannelIsLeftNothingIsJudged) {
  Samples samples = cut(6.0);
  for (std::size_t f = frame(kFaultBegins); f < samples[0].size(); ++f) samples[0][f] = 0.0F;
  EXPECT_EQ(run(samples).invalid, 0);
  for (std::size_t f = frame(4.0); f < frame(5.0); ++f) samples[1][f] = std::nanf("");
  const int blocks = run(samples).invalid;
  EXPECT_NEAR(blocks * 256 / kRate, 1.0, 0.1);
}

// What begins with no numbers must not stay so: the first sample is what the offset is taken from.
TEST_F(SensorCheckTest, AChannelThatBeginsWithoutNumbersIsMeasuredOnceItHasThem) {
  Samples samples = cut(3.0);
  std::fill_n(samples[0].begin(), frame(0.2), std::nanf(""));
  const Run r = run(samples);
  EXPECT_GT(r.first(ReasonCode::InputNotFinite), 0.0);
  EXPECT_LT(r.last(), 0.3);
  EXPECT_EQ(r.invalid, 0);
  EXPECT_GT(r.status.channel[0].rms, 0.5);
}

TEST_F(SensorCheckTest, RepeatedValuesAreALowerRate) {
  Samples samples = cut(3.0);
  for (auto& x : samples) {
    for (std::size_t f = 0; f < x.size(); ++f) x[f] = x[f - f % 3];
  }
  const Run r = run(samples);
  EXPECT_GT(r.first(ReasonCode::InputRepeated), 0.0);
  EXPECT_LT(r.first(ReasonCode::InputRepeated), 0.5);
  // Coarse steps repeat values too, but not all of them.
  Samples coarse = cut(3.0);
  for (auto& x : coarse) {
    for (float& v : x) v = std::round(v * 4.0F) / 4.0F;
  }
  EXPECT_EQ(run(coarse).first(ReasonCode::InputRepeated), -1.0);
}

TEST_F(SensorCheckTest, ARateThatTheClockDoesNotConfirmIsWrong) {
  const Run slow = run(cut(4.0), kSpindle, 256, 1.0 / 0.98);
  EXPECT_GT(slow.first(ReasonCode::InputRate), 0.9);
  EXPECT_LT(slow.first(ReasonCode::InputRate), 1.2);
  EXPECT_NEAR(slow.status.actualRate.value, 0.98 * kRate, 1.0);
  EXPECT_TRUE(run(cut(4.0), kSpindle, 256, 1.0005).faults.empty());
}

TEST_F(SensorCheckTest, BlocksOfAnyLengthFindTheSame) {
  std::mt19937 engine(5);
  std::normal_distribution<float> noise(0.0F, 0.01F);
  Samples samples = cut(5.0);
  for (std::size_t f = frame(kFaultBegins); f < samples[1].size(); ++f) samples[1][f] = noise(engine);
  const double first = run(samples, kSpindle, 64).first(ReasonCode::InputSilent);
  EXPECT_GT(first, kFaultBegins);
  EXPECT_NEAR(run(samples, kSpindle, 1000).first(ReasonCode::InputSilent), first, 1000 / kRate);
}

}  // namespace
}  // namespace stillcut::detect
