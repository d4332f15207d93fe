#include "app/io/alsa_duplex.h"

#ifdef STILLCUT_ALSA
#include <alsa/asoundlib.h>
#endif

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace stillcut::app {

#ifdef STILLCUT_ALSA
namespace {

constexpr int kWaitMs = 500;
constexpr unsigned kQueued = 2;  // periods of silence before the first output: one is played, one is written

class AlsaDuplexDriver final : public active::PcmDuplexDriver {
 public:
  AlsaDuplexDriver() = default;
  AlsaDuplexDriver(const AlsaDuplexDriver&) = delete;
  AlsaDuplexDriver& operator=(const AlsaDuplexDriver&) = delete;
  ~AlsaDuplexDriver() override { AlsaDuplexDriver::close(); }

  Result<active::PcmDuplexFormat> open(const active::PcmDuplexRequest& request) override {
    close();
    if (auto opened = openOne(in_, SND_PCM_STREAM_CAPTURE, request); !opened) return opened.error();
    if (auto opened = openOne(out_, SND_PCM_STREAM_PLAYBACK, request); !opened) return opened.error();
    format_.inputs = request.inputs;
    format_.outputs = request.outputs;
    format_.frames = request.frames;
    for (snd_pcm_t* pcm : {in_, out_}) {
      int& channels = pcm == in_ ? format_.inputs : format_.outputs;
      if (auto set = configure(pcm, request, channels); !set) {
        close();
        return set.error();
      }
    }
    silence_.assign(static_cast<std::size_t>(format_.frames * format_.outputs), 0);
    linked_ = ::snd_pcm_link(in_, out_) == 0;  // one start for both; a device without it is started one after the other
    format_.together = linked_;
    if (!restart()) {
      close();
      return Error{where(request), message("does not start")};
    }
    return format_;
  }

  int read(std::int32_t* into) noexcept override {
    return transfer(in_, [&](snd_pcm_uframes_t done, snd_pcm_uframes_t left) {
      return ::snd_pcm_readi(in_, into + done * static_cast<snd_pcm_uframes_t>(format_.inputs), left);
    });
  }

  int write(const std::int32_t* from) noexcept override {
    return transfer(out_, [&](snd_pcm_uframes_t done, snd_pcm_uframes_t left) {
      return ::snd_pcm_writei(out_, from + done * static_cast<snd_pcm_uframes_t>(format_.outputs), left);
    });
  }

  bool restart() noexcept override {
    if (in_ == nullptr || out_ == nullptr) return false;
    ::snd_pcm_drop(in_);
    if (!linked_) ::snd_pcm_drop(out_);
    if (::snd_pcm_prepare(in_) < 0) return false;
    if (!linked_ && ::snd_pcm_prepare(out_) < 0) return false;
    for (unsigned i = 0; i < kQueued; ++i) {
      if (write(silence_.data()) != 0) return false;
    }
    if (::snd_pcm_start(in_) < 0) return false;
    return linked_ || ::snd_pcm_start(out_) == 0;
  }

  void close() noexcept override {
    for (snd_pcm_t** pcm : {&in_, &out_}) {
      if (*pcm != nullptr) ::snd_pcm_close(*pcm);
      *pcm = nullptr;
    }
    linked_ = false;
  }

 private:
  static std::string where(const active::PcmDuplexRequest& request) { return "device '" + request.device + "'"; }

  static Status openOne(snd_pcm_t*& pcm, snd_pcm_stream_t stream, const active::PcmDuplexRequest& request) {
    const int opened = ::snd_pcm_open(&pcm, request.device.c_str(), stream, SND_PCM_NONBLOCK);
    if (opened == 0) return Done{};
    pcm = nullptr;
    return Error{
        where(request),
        message("cannot be opened for %1", stream == SND_PCM_STREAM_CAPTURE ? message("input") : message("output")),
        foreign(::snd_strerror(opened))};
  }

  // Exactly what was asked, but for the period, which must then be the same both ways.
  Status configure(snd_pcm_t* pcm, const active::PcmDuplexRequest& request, int& channels) {
    const std::string side = pcm == in_ ? "input" : "output";
    snd_pcm_hw_params_t* hw = nullptr;
    snd_pcm_hw_params_alloca(&hw);
    ::snd_pcm_hw_params_any(pcm, hw);
    ::snd_pcm_hw_params_set_rate_resample(pcm, hw, 0);
    ::snd_pcm_hw_params_set_access(pcm, hw, SND_PCM_ACCESS_RW_INTERLEAVED);
    if (::snd_pcm_hw_params_set_format(pcm, hw, SND_PCM_FORMAT_S32_LE) < 0) {
      return Error{where(request), message("has no samples of 32 bits (%1)", side),
                   message("plughw: in front of it converts them")};
    }
    const auto rate = static_cast<unsigned>(std::lround(request.rate.value));
    if (::snd_pcm_hw_params_set_rate(pcm, hw, rate, 0) < 0) {
      return Error{where(request), message("has no %1 Hz (%2)", std::to_string(rate), side), foreign("'rate_hz'")};
    }
    unsigned least = 0;
    ::snd_pcm_hw_params_get_channels_min(hw, &least);
    channels = std::max(channels, static_cast<int>(least));
    if (::snd_pcm_hw_params_set_channels(pcm, hw, static_cast<unsigned>(channels)) < 0) {
      return Error{where(request), message("has no %1 channels (%2)", std::to_string(channels), side)};
    }
    auto period = static_cast<snd_pcm_uframes_t>(format_.frames);
    ::snd_pcm_hw_params_set_period_size_near(pcm, hw, &period, nullptr);
    if (pcm == in_) format_.frames = static_cast<int>(period);
    if (static_cast<int>(period) != format_.frames) {
      return Error{where(request), message("has different periods for input and output"),
                   message("%1 and %2 frames", std::to_string(format_.frames), std::to_string(period))};
    }
    snd_pcm_uframes_t buffer = 2 * kQueued * period;
    ::snd_pcm_hw_params_set_buffer_size_near(pcm, hw, &buffer);
    int done = ::snd_pcm_hw_params(pcm, hw);
    if (done == 0) done = startByHand(pcm, period);
    if (done < 0)
      return Error{where(request), message("does not take these settings together"), foreign(::snd_strerror(done))};
    return Done{};
  }

  int startByHand(snd_pcm_t* pcm, snd_pcm_uframes_t period) {
    snd_pcm_sw_params_t* sw = nullptr;
    snd_pcm_sw_params_alloca(&sw);
    ::snd_pcm_sw_params_current(pcm, sw);
    snd_pcm_uframes_t boundary = 0;
    ::snd_pcm_sw_params_get_boundary(sw, &boundary);
    ::snd_pcm_sw_params_set_start_threshold(pcm, sw, boundary);
    ::snd_pcm_sw_params_set_avail_min(pcm, sw, period);
    if (pcm == out_) {  // an underrun plays silence, and not what the buffer held a round ago
      ::snd_pcm_sw_params_set_silence_threshold(pcm, sw, 0);
      ::snd_pcm_sw_params_set_silence_size(pcm, sw, boundary);
    }
    return ::snd_pcm_sw_params(pcm, sw);
  }

  template <class Call>
  int transfer(snd_pcm_t* pcm, Call call) noexcept {
    if (pcm == nullptr) return active::kDuplexGone;
    const auto frames = static_cast<snd_pcm_uframes_t>(format_.frames);
    for (snd_pcm_uframes_t done = 0; done < frames;) {
      const snd_pcm_sframes_t got = call(done, frames - done);
      if (got > 0) done += static_cast<snd_pcm_uframes_t>(got);
      if (got > 0) continue;
      if (got < 0 && got != -EAGAIN) return faultOf(static_cast<int>(got));
      const int ready = ::snd_pcm_wait(pcm, kWaitMs);
      if (ready == 0) return active::kDuplexGone;
      if (ready < 0) return faultOf(ready);
    }
    return 0;
  }

  static int faultOf(int error) noexcept {
    return error == -EPIPE || error == -ESTRPIPE ? active::kDuplexLost : active::kDuplexGone;
  }

  snd_pcm_t* in_ = nullptr;
  snd_pcm_t* out_ = nullptr;
  active::PcmDuplexFormat format_;
  std::vector<std::int32_t> silence_;
  bool linked_ = false;
};

}  // namespace

std::unique_ptr<active::PcmDuplexDriver> makeAlsaDuplexDriver() {
  return std::make_unique<AlsaDuplexDriver>();
}
#else
std::unique_ptr<active::PcmDuplexDriver> makeAlsaDuplexDriver() {
  return nullptr;
}
#endif

}  // namespace stillcut::app
