#include "app/io/alsa_driver.h"

#ifdef STILLCUT_ALSA
#include <alsa/asoundlib.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace stillcut::app {

#ifdef STILLCUT_ALSA
namespace {

constexpr int kWaitMs = 100;
constexpr std::array<unsigned, 12> kRates{8000,  11025, 16000, 22050, 32000,  44100,
                                          48000, 64000, 88200, 96000, 176400, 192000};
struct Kind {
  snd_pcm_format_t format;
  int bits, bytes;
};
// Best first. S24_LE is 24 bits in the lower three of four bytes.
constexpr std::array<Kind, 4> kKinds{{{SND_PCM_FORMAT_S32_LE, 32, 4},
                                      {SND_PCM_FORMAT_S24_3LE, 24, 3},
                                      {SND_PCM_FORMAT_S24_LE, 24, 4},
                                      {SND_PCM_FORMAT_S16_LE, 16, 2}}};

// "8000, 16000, 48000"
std::string ratesOf(snd_pcm_t* pcm, snd_pcm_hw_params_t* hw) {
  std::string rates;
  for (const unsigned rate : kRates) {
    if (::snd_pcm_hw_params_test_rate(pcm, hw, rate, 0) == 0)
      rates += (rates.empty() ? "" : ", ") + std::to_string(rate);
  }
  return rates.empty() ? "none of the usual ones" : rates;
}

std::string bitsOf(snd_pcm_t* pcm, snd_pcm_hw_params_t* hw) {
  std::string bits;
  for (const Kind& kind : kKinds) {
    const std::string word = std::to_string(kind.bits);
    if (::snd_pcm_hw_params_test_format(pcm, hw, kind.format) == 0 && bits.find(word) == std::string::npos) {
      bits += (bits.empty() ? "" : ", ") + word;
    }
  }
  return bits;
}

std::pair<unsigned, unsigned> channelsOf(snd_pcm_hw_params_t* hw) {
  unsigned least = 0;
  unsigned most = 0;
  ::snd_pcm_hw_params_get_channels_min(hw, &least);
  ::snd_pcm_hw_params_get_channels_max(hw, &most);
  return {least, most};
}

// alsa-lib would print its own lines beside ours.
void sayNothing(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/, const char* /*format*/,
                ...) {}  // NOLINT(cert-dcl50-cpp): the library's signature

class AlsaDriver final : public daq::PcmDriver {
 public:
  AlsaDriver() = default;
  AlsaDriver(const AlsaDriver&) = delete;
  AlsaDriver& operator=(const AlsaDriver&) = delete;
  ~AlsaDriver() override { AlsaDriver::close(); }

  Result<daq::PcmFormat> open(const daq::PcmRequest& request) override {
    close();
    ::snd_lib_error_set_handler(sayNothing);
    const int opened = ::snd_pcm_open(&pcm_, request.device.c_str(), SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK);
    if (opened < 0) {
      pcm_ = nullptr;
      return Error{"'device' = '" + request.device + "'", "cannot be opened",
                   std::string(::snd_strerror(opened)) + "; stillcut-cli devices lists what there is"};
    }
    auto set = configure(request);
    if (!set) close();
    return set;
  }

  int read(void* into, int frames, Instant& taken) noexcept override {
    if (pcm_ == nullptr) return daq::kPcmGone;
    const int ready = ::snd_pcm_wait(pcm_, kWaitMs);
    if (ready == 0) return 0;
    if (ready < 0) return faultOf(ready);
    const snd_pcm_sframes_t got = ::snd_pcm_readi(pcm_, into, static_cast<snd_pcm_uframes_t>(frames));
    if (got == -EAGAIN) return 0;
    if (got < 0) return faultOf(static_cast<int>(got));
    stamp(taken);
    return static_cast<int>(got);
  }

  bool recover() noexcept override {
    return pcm_ != nullptr && ::snd_pcm_prepare(pcm_) == 0 && ::snd_pcm_start(pcm_) == 0;
  }

  bool countsLosses() const noexcept override { return true; }

  void close() noexcept override {
    if (pcm_ != nullptr) ::snd_pcm_close(pcm_);
    pcm_ = nullptr;
  }

 private:
  Result<daq::PcmFormat> configure(const daq::PcmRequest& request) {
    const std::string where = "device '" + request.device + "'";
    snd_pcm_hw_params_t* hw = nullptr;
    snd_pcm_hw_params_alloca(&hw);
    ::snd_pcm_hw_params_any(pcm_, hw);
    ::snd_pcm_hw_params_set_rate_resample(pcm_, hw, 0);
    ::snd_pcm_hw_params_set_access(pcm_, hw, SND_PCM_ACCESS_RW_INTERLEAVED);
    const auto rate = static_cast<unsigned>(std::lround(request.rate.value));
    if (::snd_pcm_hw_params_set_rate(pcm_, hw, rate, 0) < 0) {
      return Error{where, "'rate_hz' = " + std::to_string(rate) + " is not among its rates",
                   "it has " + ratesOf(pcm_, hw)};
    }
    daq::PcmFormat format;
    const auto [least, most] = channelsOf(hw);
    format.channels = static_cast<int>(std::max(static_cast<unsigned>(request.channels), least));
    if (::snd_pcm_hw_params_set_channels(pcm_, hw, static_cast<unsigned>(format.channels)) < 0) {
      return Error{where, "has no " + std::to_string(request.channels) + " channels ('inputs')",
                   "it has " + std::to_string(least) + " to " + std::to_string(most)};
    }
    const Kind* kind = nullptr;
    for (const Kind& k : kKinds) {
      if (request.bits != 0 && k.bits != request.bits) continue;
      if (::snd_pcm_hw_params_set_format(pcm_, hw, k.format) == 0) {
        kind = &k;
        break;
      }
    }
    if (kind == nullptr) {
      return Error{where, "has no samples of " + std::to_string(request.bits) + " bits ('bits')",
                   "it has " + bitsOf(pcm_, hw)};
    }
    format.bits = kind->bits;
    format.sampleBytes = kind->bytes;
    auto period = static_cast<snd_pcm_uframes_t>(request.periodFrames);
    ::snd_pcm_hw_params_set_period_size_near(pcm_, hw, &period, nullptr);
    // As much as it has, up to two seconds: it is read a period at a time all the same.
    snd_pcm_uframes_t buffer = std::max<snd_pcm_uframes_t>(2 * rate, 4 * period);
    ::snd_pcm_hw_params_set_buffer_size_near(pcm_, hw, &buffer);
    const int set = ::snd_pcm_hw_params(pcm_, hw);
    if (set < 0) return Error{where, "does not take these settings together", ::snd_strerror(set)};
    format.periodFrames = static_cast<int>(period);
    // A plugin that reads elsewhere: PulseAudio, PipeWire, JACK. What those convert, they convert unseen.
    if (::snd_pcm_type(pcm_) == SND_PCM_TYPE_IOPLUG) {
      format.doubt = "'" + request.device +
                     "' is a sound server's, which may change the rate and mix channels; hw: names the " +
                     "device itself";
    }
    rate_ = request.rate.value;
    const Status begun = begin(period);
    if (!begun) return Error{where, begun.error().what, begun.error().why};
    return format;
  }

  Status begin(snd_pcm_uframes_t period) {
    snd_pcm_sw_params_t* sw = nullptr;
    snd_pcm_sw_params_alloca(&sw);
    ::snd_pcm_sw_params_current(pcm_, sw);
    ::snd_pcm_sw_params_set_avail_min(pcm_, sw, period);
    ::snd_pcm_sw_params_set_tstamp_mode(pcm_, sw, SND_PCM_TSTAMP_ENABLE);
    ::snd_pcm_sw_params_set_tstamp_type(pcm_, sw, SND_PCM_TSTAMP_TYPE_MONOTONIC);
    int done = ::snd_pcm_sw_params(pcm_, sw);
    if (done == 0) done = ::snd_pcm_start(pcm_);
    if (done < 0) return Error{"", "does not start", ::snd_strerror(done)};
    return Done{};
  }

  static int faultOf(int error) noexcept {
    if (error == -EPIPE || error == -ESTRPIPE) return daq::kPcmOverrun;
    return error == -ENODEV || error == -EBADFD ? daq::kPcmGone : daq::kPcmBroken;
  }

  // The driver's own time of its newest frame, less what still waits to be read; this clock's where it gives none.
  void stamp(Instant& taken) const noexcept {
    snd_pcm_uframes_t waiting = 0;
    snd_htimestamp_t at{};
    const Instant now = SteadyClock().now();
    taken = now;
    if (::snd_pcm_htimestamp(pcm_, &waiting, &at) != 0 || (at.tv_sec == 0 && at.tv_nsec == 0)) return;
    const Instant driver = instantFromNs(at.tv_sec * 1'000'000'000LL + at.tv_nsec);
    const Instant told = driver - toDuration(Seconds(static_cast<double>(waiting) / rate_));
    if (told <= now && now - told < std::chrono::seconds(1)) taken = told;  // else it runs on another clock
  }

  snd_pcm_t* pcm_ = nullptr;
  double rate_ = 1.0;
};

std::string rangeOf(const std::string& device) {
  snd_pcm_t* pcm = nullptr;
  const int opened = ::snd_pcm_open(&pcm, device.c_str(), SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK);
  if (opened < 0) return std::string("cannot be opened: ") + ::snd_strerror(opened);
  snd_pcm_hw_params_t* hw = nullptr;
  snd_pcm_hw_params_alloca(&hw);
  ::snd_pcm_hw_params_any(pcm, hw);
  ::snd_pcm_hw_params_set_rate_resample(pcm, hw, 0);
  const auto [least, most] = channelsOf(hw);
  std::string text = std::to_string(least) + " to " + std::to_string(most) + " channels, " + ratesOf(pcm, hw) +
                     " Hz, " + bitsOf(pcm, hw) + " bits";
  ::snd_pcm_close(pcm);
  return text;
}

}  // namespace

std::unique_ptr<daq::PcmDriver> makeAlsaDriver() {
  return std::make_unique<AlsaDriver>();
}

std::vector<daq::PcmDevice> alsaDevices() {
  std::vector<daq::PcmDevice> all;
  snd_ctl_card_info_t* card = nullptr;
  snd_ctl_card_info_alloca(&card);
  for (int number = -1; ::snd_card_next(&number) == 0 && number >= 0;) {
    const std::string name = "hw:" + std::to_string(number);
    snd_ctl_t* control = nullptr;
    if (::snd_ctl_open(&control, name.c_str(), 0) < 0) continue;
    const bool known = ::snd_ctl_card_info(control, card) == 0;
    for (int device = -1; ::snd_ctl_pcm_next_device(control, &device) == 0 && device >= 0;) {
      const std::string full = name + "," + std::to_string(device);
      const std::string range = rangeOf(full);
      if (range.find("No such") != std::string::npos) continue;  // plays only
      all.push_back({full, known ? ::snd_ctl_card_info_get_name(card) : "", range});
    }
    ::snd_ctl_close(control);
  }
  return all;
}
#else
std::unique_ptr<daq::PcmDriver> makeAlsaDriver() {
  return nullptr;
}

std::vector<daq::PcmDevice> alsaDevices() {
  return {};
}
#endif

}  // namespace stillcut::app
