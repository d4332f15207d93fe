// SoundPlayer: samples of a recording out of this computer's loudspeakers, by ALSA's default device (which is
// PulseAudio's or PipeWire's where they run). A rate that no sound card has is brought to one.
// Thread: its owner's; what takes time runs on a thread of its own.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>

#include "core/base/result.h"
#include "core/base/units.h"

namespace stillcut::app {

struct SoundStretch {
  // From frame `first` on; not a number where nothing was measured. Called on the player's thread.
  std::function<bool(std::int64_t first, std::span<float> out)> read;
  Hertz rate{};
  std::int64_t from = 0, to = 0;  // frames
  double gain = 1.0;              // what is played is within -1 .. 1
};

class SoundPlayer {
 public:
  ~SoundPlayer() { stop(); }

  // What was played before ends. An error: this program was built without sound.
  Status play(SoundStretch stretch);
  void stop();
  // The frame that is played now; empty: nothing is played.
  std::optional<std::int64_t> at() const;
  // Why the last one was not played, or not to its end; empty: it was.
  Message problem() const;

 private:
  void run(const std::stop_token& stop, const SoundStretch& stretch);
  void tell(Message problem);

  std::jthread thread_;
  std::atomic<std::int64_t> at_{-1};
  mutable std::mutex lock_;
  Message problem_;
};

}  // namespace stillcut::app
