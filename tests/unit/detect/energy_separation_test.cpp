// Bands between the tooth passings and the energy separation in each.
#include "core/detect/caliskan/energy_separation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/dsp/kernels/choose.h"

namespace stillcut::detect {
namespace {

constexpr double kRate = 25600.0;

double tone(double hertz, int k) {
  return std::sin(kTwoPi * hertz * k / kRate);
}

TEST(EnergySeparation, FindsAmplitudeAndFrequencyOfATone) {
  EnergySeparation bands;
  bands.prepare(1, 6, Hertz(kRate), Hertz(200.0), dsp::kernels::bestKernels());
  bands.tune(Hertz(91.7), 4, 62);
  for (int k = 0; k < 12800; ++k) {
    if (k == 12000) bands.estimate();
    const double x = 3.0 * tone(935.0, k);  // band 3: 733..1100 Hz, flat there
    bands.process(0, &x, 1);
    bands.advance(1);
  }
  bands.estimate();
  const BandEstimate& b = bands.band(0, 2);
  EXPECT_TRUE(b.valid);
  EXPECT_NEAR(b.frequency.value, 935.0, 1.0);
  EXPECT_NEAR(std::sqrt(b.power), 3.0, 0.1);
}

// Two bands of twelve orders, and half of a third below the top: what chatters there is heard as well. A sixth is none.
TEST(EnergySeparation, HearsUpToTheTop) {
  for (const int left : {6, 2}) {
    EnergySeparation bands;
    bands.prepare(1, 4, Hertz(kRate), Hertz(200.0), dsp::kernels::bestKernels());
    bands.tune(Hertz(30.0), 12, 24);
    bands.tune(Hertz(30.0), 12, 24 + left);  // the speed alone does not tell
    ASSERT_EQ(bands.active(), left == 6 ? 3 : 2);
    for (int k = 0; k < 12800; ++k) {
      if (k == 12000) bands.estimate();
      const double x = 3.0 * tone(810.0, k);
      bands.process(0, &x, 1);
      bands.advance(1);
    }
    bands.estimate();
    EXPECT_NEAR(std::sqrt(bands.band(0, 2).power), left == 6 ? 3.0 : 0.0, 0.1);
  }
}

// A spindle faster than half of the rate: no filter may reach beyond that, and what lies below it is heard.
TEST(EnergySeparation, StaysAFilterWhereTheRateHearsNoOrder) {
  EnergySeparation bands;
  bands.prepare(1, 2, Hertz(kRate), Hertz(200.0), dsp::kernels::bestKernels());
  bands.tune(Hertz(0.6 * kRate), 4, 1);
  for (int k = 0; k < 2000; ++k) {
    const double x = 3.0 * tone(0.4 * kRate, k);
    bands.process(0, &x, 1);
    bands.advance(1);
  }
  bands.estimate();
  EXPECT_NEAR(std::sqrt(bands.band(0, 0).power), 3.0, 0.5);
}

TEST(EnergySeparation, SilenceGivesNoEstimateAndNoNan) {
  EnergySeparation bands;
  bands.prepare(1, 3, Hertz(kRate), Hertz(200.0), dsp::kernels::bestKernels());
  bands.tune(Hertz(91.7), 4, 62);
  const double zero = 0.0;
  for (int k = 0; k < 1000; ++k) {
    bands.process(0, &zero, 1);
    bands.advance(1);
  }
  bands.estimate();
  for (int m = 0; m < 3; ++m) {
    EXPECT_FALSE(bands.band(0, m).valid);
    EXPECT_TRUE(std::isfinite(bands.band(0, m).power));
  }
}

}  // namespace
}  // namespace stillcut::detect
