// Real recordings (microphone at a face mill; TRUTH.csv beside them). Not part of the repository.
#include "tests/support/recording_runner.h"

namespace stillcut::detect::testing {
namespace {

std::filesystem::path audio(const char* name) {
  return sharedDir() / "recordings/face_mill_audio" / name;
}

RunOptions faceMill(double rpm) {
  RunOptions o;
  o.teeth = 6;
  o.rpm = rpm;
  o.quantity = SensorQuantity::Sound;
  o.blockFrames = 120;
  o.channels = {0};  // both are the same
  return o;
}

TEST(Recordings, StableFaceMillAndItsRunUpAreSilent) {
  STILLCUT_NEEDS(audio("Stable.wav"));
  const Recording recording = readWav(audio("Stable.wav"));
  // 74.81 Hz measured; 898 Hz is twice tooth passing here. Labelled to 7.2 s: as the tool leaves, for 0.4 s a line at
  // 903 Hz, which is on no order, fills the sound.
  for (const double rpm : {4489.0 * 0.98, 4489.0, 4489.0 * 1.02}) {
    const double first = run(recording, faceMill(rpm)).firstAlarm;
    EXPECT_TRUE(first < 0.0 || first >= 7.2) << rpm << ": " << first;
  }
}

TEST(Recordings, IdleMachineNoiseIsSilent) {
  STILLCUT_NEEDS(audio("Idle Sound.wav"));
  const Recording recording = readWav(audio("Idle Sound.wav"));
  for (const double rpm : {1655.0, 4489.0}) EXPECT_LT(run(recording, faceMill(rpm)).firstAlarm, 0.0) << rpm;
}

TEST(Recordings, ChatterFromTheEntryIsFoundAndHeld) {
  STILLCUT_NEEDS(audio("Chatter.wav"));
  const Recording recording = readWav(audio("Chatter.wav"));
  for (const double rpm : {1655.0 * 0.98, 1655.0, 1655.0 * 1.02}) {
    const RunResult r = run(recording, faceMill(rpm));
    EXPECT_LT(r.firstAlarmAfter(16.5), 0.0) << rpm;
    EXPECT_GT(r.firstAlarm, 1.0) << rpm;        // idle until then
    EXPECT_LT(r.firstAlarm, 1.8 + 1.0) << rpm;  // how soon depends on where the windows fall
    EXPECT_GT(r.alarmTimeIn(1.8, 15.5), 0.9 * (15.5 - 1.8)) << rpm;
  }
  EXPECT_NEAR(run(recording, faceMill(1655.0)).at(8.0).frequency.value, 898.5, 0.005 * 898.5);
}

}  // namespace
}  // namespace stillcut::detect::testing
