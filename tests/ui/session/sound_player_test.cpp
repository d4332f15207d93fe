// What is played, by an ALSA whose default device is a file, and what is said where there is no device.
#include "app/io/sound_player.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstring>
#include <vector>

namespace stillcut::app {
namespace {

class Sound : public testing::Test {
 protected:
  void configure(const QByteArray& text) {
    QFile file(folder_.filePath(QStringLiteral("asound-%1.conf").arg(++written_)));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    file.close();
    qputenv("ALSA_CONFIG_PATH", file.fileName().toLocal8Bit());
  }
  void TearDown() override { qunsetenv("ALSA_CONFIG_PATH"); }
  static SoundStretch tone(Hertz rate, std::int64_t frames) {
    SoundStretch stretch;
    stretch.read = [](std::int64_t first, std::span<float> out) {
      for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = static_cast<float>(2.0 * std::sin(0.05 * static_cast<double>(first + static_cast<std::int64_t>(k))));
      return true;
    };
    stretch.rate = rate;
    stretch.to = frames;
    stretch.gain = 0.25;
    return stretch;
  }
  static bool over(const SoundPlayer& player) {
    return QTest::qWaitFor([&player] { return !player.at().has_value(); }, 30'000);
  }

  QTemporaryDir folder_;
  int written_ = 0;
};

TEST_F(Sound, ComesOutAsItWasRecordedWithItsGain) {
  const QString heard = folder_.filePath(QStringLiteral("heard.raw"));
  configure(QStringLiteral("pcm.!default { type file slave.pcm { type null } file \"%1\" format \"raw\" }")
                .arg(heard)
                .toLocal8Bit());
  SoundPlayer player;
  if (const Status begun = player.play(tone(Hertz(16'000.0), 8'000)); !begun) GTEST_SKIP() << begun.error().line();
  ASSERT_TRUE(over(player));
  EXPECT_TRUE(player.problem().empty()) << text(player.problem());
  player.stop();
  QFile file(heard);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  std::vector<float> samples(static_cast<std::size_t>(bytes.size()) / sizeof(float));
  std::memcpy(samples.data(), bytes.data(), samples.size() * sizeof(float));
  ASSERT_GE(samples.size(), 8'000U);
  for (std::size_t k = 0; k < 8'000; k += 37)
    EXPECT_NEAR(samples[k], 0.5 * std::sin(0.05 * static_cast<double>(k)), 1e-4) << k;
}

TEST_F(Sound, WithoutADeviceItSaysSo) {
  configure("# nothing is plugged in\n");
  SoundPlayer player;
  if (const Status begun = player.play(tone(Hertz(1'000.0), 1'000)); !begun) GTEST_SKIP() << begun.error().line();
  ASSERT_TRUE(over(player));
  EXPECT_NE(text(player.problem()).find("no sound output"), std::string::npos) << text(player.problem());
}

}  // namespace
}  // namespace stillcut::app
