// A PulseAudio server of the test's own with one null sink, reached through ALSA's pulse plugin: what is played to the
// ALSA device "played" is heard, bit by bit, at "heard". It stands in for an audio-class device. "looped" is
// both as one device, "fixed" is "heard" behind ALSA's own converters, with the sink's rate as the only one that needs
// none.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <thread>

namespace stillcut::testing {

class NullSink {
 public:
  NullSink() = default;
  ~NullSink();
  NullSink(const NullSink&) = delete;
  NullSink& operator=(const NullSink&) = delete;

  // Empty: it runs, and this process' ALSA knows its two devices. Else why it cannot run here, one line.
  // channelMap: as PulseAudio spells it; what is heard is mixed where it is not the one that ALSA asks for.
  // resampling: its method for who asks for another rate; "trivial" repeats and drops samples.
  std::string start(int rate, int channels, const std::string& channelMap = {}, const std::string& resampling = {});
  // As if the cable were pulled, and put back.
  void unplug();
  std::string plug();

 private:
  std::filesystem::path folder_;
  int rate_ = 0;
  int channels_ = 0;
  std::string map_, resampling_;
  pid_t server_ = -1;
};

// The calling thread, and those that it starts, come before ordinary ones for as long as this lives, where permitted:
// what stands in for a device must not be late because the computer is busy.
class OnTime {
 public:
  OnTime();
  ~OnTime();
  OnTime(const OnTime&) = delete;
  OnTime& operator=(const OnTime&) = delete;
};

// Plays interleaved 32-bit frames until it is destroyed. fill: one call after the other, on the player's own thread.
// ahead: so many seconds are handed over before they are due.
class NullSinkPlayer {
 public:
  using Fill = std::function<void(std::span<std::int32_t> interleaved)>;
  NullSinkPlayer(int rate, int channels, Fill fill, double ahead = 1.0);
  ~NullSinkPlayer();
  NullSinkPlayer(const NullSinkPlayer&) = delete;
  NullSinkPlayer& operator=(const NullSinkPlayer&) = delete;

  bool couldPlay() const { return !refused_; }
  // Times it was too late itself, so that silence was played in between.
  int underruns() const { return underruns_; }

 private:
  void run(int rate, int channels, double ahead);

  Fill fill_;
  std::atomic<bool> stopped_{false};
  std::atomic<bool> refused_{false};
  std::atomic<int> underruns_{0};
  std::thread thread_;
};

}  // namespace stillcut::testing
