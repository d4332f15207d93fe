#include "app/io/sound_player.h"

#ifdef STILLCUT_ALSA
#include <alsa/asoundlib.h>
#endif

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stillcut::app {
void SoundPlayer::stop() {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
  at_.store(-1);
}

std::optional<std::int64_t> SoundPlayer::at() const {
  const std::int64_t frame = at_.load();
  return frame < 0 ? std::nullopt : std::optional(frame);
}

Message SoundPlayer::problem() const {
  const std::lock_guard guard(lock_);
  return problem_;
}

void SoundPlayer::tell(Message problem) {
  const std::lock_guard guard(lock_);
  problem_ = std::move(problem);
}

#ifdef STILLCUT_ALSA
namespace {

constexpr double kLowest = 8000.0, kHighest = 192000.0;  // that ALSA's plug layer takes from us
constexpr double kUsual = 48000.0;

double playedRate(Hertz rate) {
  return rate.value < kLowest || rate.value > kHighest ? kUsual : rate.value;
}

// `count` samples from place `at` (in frames of the recording) on, `step` frames apart, straight lines between them.
bool fill(const SoundStretch& s, double at, double step, std::vector<float>& heard, std::span<float> out) {
  const auto first = static_cast<std::int64_t>(std::floor(at));
  heard.resize(static_cast<std::size_t>(std::ceil(step * static_cast<double>(out.size()))) + 2);
  if (!s.read(first, heard)) return false;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double place = at - static_cast<double>(first) + step * static_cast<double>(k);
    const auto i = std::min(static_cast<std::size_t>(place), heard.size() - 2);
    const double part = place - static_cast<double>(i);
    const double value = s.gain * ((1.0 - part) * heard[i] + part * heard[i + 1]);
    out[k] = std::isfinite(value) ? static_cast<float>(std::clamp(value, -1.0, 1.0)) : 0.0F;
  }
  return true;
}

constexpr unsigned kLatency_us = 200'000;
constexpr double kChunk_s = 0.05;

struct PcmCloser {
  void operator()(snd_pcm_t* pcm) const { ::snd_pcm_close(pcm); }
};

// What this library prints to the terminal comes back as a number as well.
void quiet(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

Status SoundPlayer::play(SoundStretch stretch) {
  stop();
  tell({});
  at_.store(stretch.from);
  thread_ = std::jthread([this, s = std::move(stretch)](const std::stop_token& stop) { run(stop, s); });
  return Done{};
}

void SoundPlayer::run(const std::stop_token& stop, const SoundStretch& s) {
  ::snd_lib_error_set_handler(&quiet);
  const double rate = playedRate(s.rate);
  const double step = s.rate.value / rate;
  snd_pcm_t* raw = nullptr;
  int done = ::snd_pcm_open(&raw, "default", SND_PCM_STREAM_PLAYBACK, 0);
  const std::unique_ptr<snd_pcm_t, PcmCloser> pcm(raw);
  if (done == 0) {
    done = ::snd_pcm_set_params(raw, SND_PCM_FORMAT_FLOAT, SND_PCM_ACCESS_RW_INTERLEAVED, 1,
                                static_cast<unsigned>(std::lround(rate)), 1, kLatency_us);
  }
  if (done < 0) {
    tell(message("this computer has no sound output: %1", foreign(::snd_strerror(done))));
    at_.store(-1);
    return;
  }
  std::vector<float> heard, out(static_cast<std::size_t>(rate * kChunk_s));
  double at = static_cast<double>(s.from);
  while (!stop.stop_requested() && at < static_cast<double>(s.to)) {
    if (!fill(s, at, step, heard, out)) break;
    snd_pcm_sframes_t put = ::snd_pcm_writei(raw, out.data(), out.size());
    if (put < 0) put = ::snd_pcm_recover(raw, static_cast<int>(put), 1);
    if (put < 0) {
      tell(message("the sound output has failed: %1", foreign(::snd_strerror(static_cast<int>(put)))));
      break;
    }
    at += step * static_cast<double>(put);
    snd_pcm_sframes_t waiting = 0;
    if (::snd_pcm_delay(raw, &waiting) < 0) waiting = 0;
    at_.store(std::max(s.from, static_cast<std::int64_t>(at - step * static_cast<double>(waiting))));
  }
  if (stop.stop_requested()) {
    ::snd_pcm_drop(raw);
  } else {
    ::snd_pcm_drain(raw);
  }
  at_.store(-1);
}
#else
Status SoundPlayer::play(SoundStretch) {
  return Error{message("sound"), message("this Stillcut was built without sound output")};
}
void SoundPlayer::run(const std::stop_token&, const SoundStretch&) {}
#endif

}  // namespace stillcut::app
