// The watches of the sensor check, each by itself: hum, a doubled input, the rate, and the marks of past turns.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "core/detect/caliskan/turn_marks.h"
#include "core/dsp/rate_watch.h"
#include "core/sensing/hum_watch.h"
#include "core/sensing/pair_watch.h"

namespace stillcut::detect {
namespace {

using Signal = std::function<double(double)>;

// The largest part that is ever called hum in `seconds` of a signal.
double humIn(const Signal& signal, double seconds, double rate, Hertz spindle, Hertz* mains = nullptr) {
  HumWatch watch;
  watch.prepare(Hertz(rate));
  double largest = 0.0;
  std::vector<double> block(static_cast<std::size_t>(rate * 0.01));
  std::size_t n = 0;
  for (int i = 0; i < static_cast<int>(seconds * 100.0); ++i) {
    for (double& x : block) x = signal(static_cast<double>(n++) / rate);
    watch.push(block, spindle);
    if (watch.part() > largest) {
      largest = watch.part();
      if (mains != nullptr) *mains = watch.mains();
    }
  }
  return largest;
}

Signal tones(std::vector<std::pair<double, double>> lines) {
  return [lines = std::move(lines)](double t) {
    double x = 0.0;
    for (const auto& [f, a] : lines) x += a * std::sin(kTwoPi * f * t + f);
    return x;
  };
}

TEST(HumWatch, FindsTheMainsOfEitherContinent) {
  for (double hertz : {50.0, 60.0}) {
    for (double off : {-0.05, 0.0, 0.05}) {  // grids keep within that
      Hertz mains;
      const double f = hertz + off;
      EXPECT_GT(humIn(tones({{f, 1.0}, {3.0 * f, 0.3}}), 5.0, 25600.0, Hertz(141.7), &mains), 0.9) << f;
      EXPECT_EQ(mains.value, hertz);
    }
  }
}

TEST(HumWatch, ItsPartIsThePowersPart) {
  // 50 Hz with a tenth of the power beside a tone of the cut.
  const double part = humIn(tones({{50.0, 1.0}, {730.0, 3.0}}), 5.0, 25600.0, Hertz(141.7));
  EXPECT_NEAR(part, 0.1, 0.02);
}

TEST(HumWatch, ALineBesideTheMainsIsNotTheMains) {
  for (double f : {48.5, 50.6, 51.0, 58.9, 61.2, 149.0}) {
    EXPECT_LT(humIn(tones({{f, 1.0}}), 6.0, 25600.0, Hertz(141.7)), 0.05) << f;
  }
}

TEST(HumWatch, ASpindleThatTurnsWithTheMainsIsNotHeldAgainstTheSensor) {
  EXPECT_LT(humIn(tones({{50.0, 1.0}, {100.0, 0.5}}), 5.0, 25600.0, Hertz(50.0)), 1e-20);
  EXPECT_LT(humIn(tones({{50.0, 1.0}}), 5.0, 25600.0, Hertz(25.0)), 1e-20);
}

TEST(HumWatch, HowTheStreamIsCutMakesNoDifference) {
  const auto tone = tones({{50.0, 1.0}, {730.0, 3.0}});
  std::vector<double> x;
  for (int n = 0; n < 3 * 25600; ++n) x.push_back(tone(n / 25600.0));
  const auto heard = [&x](std::size_t block) {
    HumWatch watch;
    watch.prepare(Hertz(25600.0));
    for (std::size_t f = 0; f < x.size(); f += block) {
      watch.push(std::span<const double>(x).subspan(f, std::min(block, x.size() - f)), Hertz(141.7));
    }
    return std::pair(watch.part(), watch.meanSquare());
  };
  EXPECT_GT(heard(1).first, 0.0);
  for (const std::size_t block : {7UL, 256UL, 10000UL}) EXPECT_EQ(heard(block), heard(1)) << block;
}

TEST(HumWatch, NoiseHasNone) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  EXPECT_LT(humIn([&](double) { return noise(random); }, 10.0, 25600.0, Hertz(141.7)), 0.05);
}

CutSetup channelsOf(const std::vector<std::pair<const char*, SensorQuantity>>& axes) {
  CutSetup setup;
  setup.rate = Hertz(10000.0);
  for (const auto& [axis, quantity] : axes) {
    ChannelInfo info;
    info.axis = axis;
    info.quantity = quantity;
    setup.channels.push_back(info);
  }
  return setup;
}

// Blocks of 100 frames for two seconds; channel c of instant n.
template <class Value>
void feed(PairWatch& watch, int channels, const Value& value) {
  SampleBlock block;
  block.allocate(channels, 100);
  int n = 0;
  for (int i = 0; i < 200; ++i) {
    block.frames = 100;
    for (int f = 0; f < 100; ++f, ++n) {
      for (int c = 0; c < channels; ++c) block.channel(c)[static_cast<std::size_t>(f)] = value(c, n);
    }
    watch.push(block);
  }
}

const auto kAcceleration = SensorQuantity::Acceleration;

TEST(PairWatch, ADoubledInputIsFoundWhateverItsGainSignAndOffset) {
  for (float gain : {1.0F, -1.0F, 0.37F}) {
    std::mt19937 random(2);
    std::normal_distribution<float> noise;
    PairWatch watch;
    watch.prepare(channelsOf({{"x", kAcceleration}, {"y", kAcceleration}}));
    float last = 0.0F;
    feed(watch, 2, [&](int c, int) {
      if (c == 0) last = noise(random);
      return c == 0 ? last : gain * last + 0.25F;
    });
    EXPECT_EQ(watch.twinOf(1), 0) << gain;
    EXPECT_EQ(watch.twinOf(0), -1);
  }
}

TEST(PairWatch, TwoSensorsOfOneMotionEachHaveTheirNoise) {
  std::mt19937 random(3);
  std::normal_distribution<float> noise;
  PairWatch watch;
  watch.prepare(channelsOf({{"x", kAcceleration}, {"y", kAcceleration}}));
  feed(watch, 2, [&](int, int n) {
    return std::sin(0.3F * static_cast<float>(n)) + 3e-4F * noise(random);  // 67 dB below
  });
  EXPECT_EQ(watch.twinOf(1), -1);
}

// Whole numbers: y is x times a gain, rounded. Two sensors that each flicker by a step are not.
TEST(PairWatch, ADoubledInputIsFoundThroughTheRoundingOfWholeNumbers) {
  for (const bool own : {false, true}) {
    for (const float gain : {1.0F, 0.7F, -0.33F}) {
      std::mt19937 random(6);
      std::normal_distribution<float> noise;
      PairWatch watch;
      watch.prepare(channelsOf({{"x", kAcceleration}, {"y", kAcceleration}}));
      float last = 0.0F;
      feed(watch, 2, [&](int c, int n) {
        if (c == 0) last = std::round(2000.0F * std::sin(0.3F * static_cast<float>(n)) + 300.0F * noise(random));
        return c == 0 ? last : std::round(gain * last + (own ? noise(random) : 0.0F));
      });
      EXPECT_EQ(watch.twinOf(1), own ? -1 : 0) << gain;
    }
  }
}

TEST(PairWatch, OnlyDifferentAxesOfOneQuantityAreCompared) {
  for (const auto& setup : {channelsOf({{"x", kAcceleration}, {"x", kAcceleration}}),
                            channelsOf({{"x", kAcceleration}, {"y", SensorQuantity::Force}}),
                            channelsOf({{"x", kAcceleration}, {"", kAcceleration}})}) {
    PairWatch watch;
    watch.prepare(setup);
    feed(watch, 2, [](int, int n) { return std::sin(0.3F * static_cast<float>(n)); });
    EXPECT_EQ(watch.twinOf(1), -1);
  }
}

TEST(PairWatch, EveryPairHasItsTurn) {
  std::mt19937 random(4);
  std::normal_distribution<float> noise;
  PairWatch watch;
  watch.prepare(channelsOf({{"x", kAcceleration}, {"y", kAcceleration}, {"z", kAcceleration}}));
  float last = 0.0F;
  feed(watch, 3, [&](int c, int) {
    if (c == 1) last = noise(random);
    return c == 0 ? noise(random) : 2.0F * last;
  });
  EXPECT_EQ(watch.twinOf(2), 1);
  EXPECT_EQ(watch.twinOf(1), -1);
}

// Blocks stamped as by a device whose true rate differs from what was told, with jitter of the clock.
dsp::RateWatch watched(double told, double trueRate, double jitter, double seconds, int gapAt = -1) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, jitter);
  dsp::RateWatch watch;
  watch.prepare(Hertz(told));
  SampleBlock block;
  block.frames = 256;
  double shift = 0.0;
  for (int i = 0; i * 256.0 / trueRate < seconds; ++i) {
    block.flags = i == gapAt ? kBlockGap : 0U;
    if (i == gapAt) shift = 1.0;
    const double at = 10.0 + shift + i * 256.0 / trueRate + (jitter > 0.0 ? noise(random) : 0.0);
    block.firstSample = Instant{} + toDuration(Seconds(at));
    watch.push(block);
  }
  return watch;
}

TEST(RateWatch, FindsTheTrueRate) {
  for (double off : {-0.03, -0.001, 0.0, 0.002, 0.05}) {
    const double rate = 25600.0 * (1.0 + off);
    const dsp::RateWatch watch = watched(25600.0, rate, 1e-4, 5.0);
    EXPECT_NEAR(watch.rate().value / rate, 1.0, 1e-4) << off;
    EXPECT_EQ(watch.wrong(), std::abs(off) > 0.005) << off;
  }
}

constexpr double kLag = 1e-3;  // s, by which a transport may have wandered

TEST(RateWatch, ItsDoubtIsTheScatterOfTheLineAndAWanderOfTheTransport) {
  const dsp::RateWatch watch = watched(25600.0, 25600.0, 2e-3, 5.0);
  EXPECT_LT(std::abs(watch.rate().value - 25600.0), 3.0 * watch.sd().value);
  // Of a slope through 500 stamps over 5 s: jitter / sqrt(n T^2 / 12).
  EXPECT_NEAR(watch.sd().value - 25600.0 * kLag / 5.0, 25600.0 * 2e-3 / std::sqrt(500.0 * 25.0 / 12.0), 0.3);
  EXPECT_NEAR(watched(25600.0, 25600.0, 2e-5, 5.0).sd().value, 25600.0 * kLag / 5.0, 0.1);
}

// Stamps that were filtered err alike for a while: the line through them scatters less than it is wrong.
TEST(RateWatch, ItsDoubtHoldsForFilteredStamps) {
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 1.0);
  constexpr double kAlike = 0.98;  // half a second
  double squares = 0.0;
  double doubt = 0.0;
  constexpr int kTimes = 40;
  for (int time = 0; time < kTimes; ++time) {
    dsp::RateWatch watch;
    watch.prepare(Hertz(8000.0));
    SampleBlock block;
    block.frames = 80;
    double error = noise(random);
    for (int i = 0; i < 1000; ++i) {
      block.firstSample = Instant{} + toDuration(Seconds(1.0 + 0.01 * i + 5e-3 * error));
      watch.push(block);
      error = kAlike * error + std::sqrt(1.0 - kAlike * kAlike) * noise(random);
    }
    const double off = watch.rate().value - 8000.0;
    EXPECT_LT(std::abs(off), 3.0 * watch.sd().value) << time;
    squares += off * off / kTimes;
    doubt += (watch.sd().value - 8000.0 * kLag / 10.0) / kTimes;
  }
  EXPECT_NEAR(doubt / std::sqrt(squares), 1.0, 0.35);
}

TEST(RateWatch, ForgetsSoThatARateThatChangesAfterAnHourIsFound) {
  for (const double off : {-0.025, 0.008}) {
    dsp::RateWatch watch;
    watch.prepare(Hertz(8000.0));
    SampleBlock block;
    block.frames = 800;
    double at = 0.0;
    for (int i = 0; i < 36000; ++i, at += 0.1) {
      block.firstSample = Instant{} + toDuration(Seconds(at));
      watch.push(block);
      ASSERT_FALSE(watch.wrong());
    }
    int blocks = 0;
    for (; !watch.wrong() && blocks < 1000; ++blocks, at += 0.1 / (1.0 + off)) {
      block.firstSample = Instant{} + toDuration(Seconds(at));
      watch.push(block);
    }
    EXPECT_LT(blocks, 150) << off;
  }
}

// Each gap begins a new line, and all have one slope: a rate is found through gaps that leave no second without one.
TEST(RateWatch, GapsDoNotHideAWrongRate) {
  for (const double real : {7200.0, 8000.0}) {
    dsp::RateWatch watch;
    watch.prepare(Hertz(8000.0));
    SampleBlock block;
    block.frames = 80;
    double at = 0.0;
    for (int i = 0; i < 1000; ++i, at += 80.0 / real) {
      block.flags = i % 30 == 29 ? kBlockGap : 0U;
      if (i % 30 == 29) at += 0.123;
      block.firstSample = Instant{} + toDuration(Seconds(at));
      watch.push(block);
    }
    EXPECT_NEAR(watch.rate().value, real, 1.0);
    EXPECT_EQ(watch.wrong(), real < 8000.0);
  }
}

TEST(RateWatch, StampsThatStandStillAreAWrongRateAndNotAnInfiniteOne) {
  dsp::RateWatch watch;
  watch.prepare(Hertz(8000.0));
  SampleBlock block;
  block.frames = 80;
  for (int i = 0; i < 200; ++i) watch.push(block);
  EXPECT_TRUE(std::isfinite(watch.rate().value));
  EXPECT_TRUE(watch.wrong());
}

TEST(RateWatch, ASecondIsNeededAndAGapBeginsAnew) {
  EXPECT_EQ(watched(25600.0, 25600.0, 0.0, 0.9).rate().value, 0.0);
  // A gap of a second in the midst is no slower rate.
  const dsp::RateWatch watch = watched(25600.0, 25600.0, 0.0, 6.0, 200);
  EXPECT_NEAR(watch.rate().value, 25600.0, 0.01);
  EXPECT_FALSE(watch.wrong());
}

TEST(TurnMarks, OneTurnAgoIsWhereTheAngleWasOneTurnLess) {
  TurnMarks marks;
  const double framesPerTurn = 180.0;
  for (int hop = 0; hop < 200; ++hop) {
    marks.advance(kTwoPi / framesPerTurn, 22);
    marks.endHop();
  }
  for (double turns : {0.5, 1.0, 2.0}) EXPECT_NEAR(marks.framesAgo(turns, -1.0), turns * framesPerTurn, 0.5);
}

// Speed that rises: a turn ago lies further back than the present speed would have it.
TEST(TurnMarks, FollowAChangingSpeed) {
  TurnMarks marks;
  std::vector<double> angles{0.0};  // by frame
  double step = 0.02;
  for (int hop = 0; hop < 400; ++hop) {
    const int frames = static_cast<int>(kTwoPi / step / kHopsPerTurn);
    step *= 1.004;
    marks.advance(step, frames);
    for (int f = 0; f < frames; ++f) angles.push_back(angles.back() + step);
    marks.endHop();
  }
  for (double turns : {1.0, 2.0}) {
    const double wanted = angles.back() - kTwoPi * turns;
    std::size_t frame = angles.size() - 1;
    while (angles[frame] > wanted) --frame;
    EXPECT_NEAR(marks.framesAgo(turns, -1.0), static_cast<double>(angles.size() - 1 - frame), 2.0) << turns;
  }
}

TEST(TurnMarks, BeyondTheMarksIsWhatTheCallerSays) {
  TurnMarks marks;
  marks.advance(0.03, 25);
  marks.endHop();
  EXPECT_EQ(marks.framesAgo(50.0, 1234.0), 1234.0);
}

}  // namespace
}  // namespace stillcut::detect
