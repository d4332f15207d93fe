// Simulated cuts with known truth.
#include "tests/unit/detect/recording_runner.h"

namespace stillcut::detect::testing {
namespace {

TEST(Cases, StableCutIsSilent) {
  const auto path = sharedDir() / "cases/c1_stable_acc.wav";
  STILLCUT_NEEDS(path);
  const Recording recording = readWav(path);
  RunOptions options;
  options.teeth = 2;
  for (const double rpm : {11000.0, 10700.0, 11300.0}) {
    options.rpm = rpm;
    EXPECT_LT(run(recording, options).firstAlarm, 0.0) << rpm;
  }
}

}  // namespace
}  // namespace stillcut::detect::testing
