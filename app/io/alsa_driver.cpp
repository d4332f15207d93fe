#include "app/io/alsa_driver.h"

#ifdef STILLCUT_ALSA
#include <alsa/asoundlib.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "core/daq/device_messages.h"

namespace stillcut::app {

#ifdef STILLCUT_ALSA
namespace {

constexpr int kWaitMs = 100;
constexpr unsigned kMostCounts = 64;  // channels; a plugin takes thousands
constexpr std::array<unsigned, 17> kRates{8000,  11025, 12800, 16000, 22050, 24000,  25600,  32000, 44100,
                                          48000, 51200, 64000, 88200, 96000, 102400, 176400, 192000};
struct Kind {
  snd_pcm_format_t format;
  int bits, bytes;
};
// Best first. S24_LE is 24 bits in the lower three of four bytes.
constexpr std::array<Kind, 4> kKinds{{{SND_PCM_FORMAT_S32_LE, 32, 4},
                                      {SND_PCM_FORMAT_S24_3LE, 24, 3},
                                      {SND_PCM_FORMAT_S24_LE, 24, 4},
                                      {SND_PCM_FORMAT_S16_LE, 16, 2}}};

// "8000, 16000, 48000"; "24414 to 97656", where none of them is usual
std::string ratesOf(snd_pcm_t* pcm, snd_pcm_hw_params_t* hw) {
  std::string rates;
  for (const unsigned rate : kRates) {
    if (::snd_pcm_hw_params_test_rate(pcm, hw, rate, 0) == 0)
      rates += (rates.empty() ? "" : ", ") + std::to_string(rate);
  }
  if (!rates.empty()) return rates;
  unsigned least = 0;
  unsigned most = 0;
  int beside = 0;
  ::snd_pcm_hw_params_get_rate_min(hw, &least, &beside);
  ::snd_pcm_hw_params_get_rate_max(hw, &most, &beside);
  return std::to_string(least) + " to " + std::to_string(most);
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

// "2, 8": a card may have some numbers of channels and none between them.
std::string countsOf(snd_pcm_t* pcm, snd_pcm_hw_params_t* hw) {
  const auto [least, most] = channelsOf(hw);
  std::string counts;
  unsigned some = 0;
  for (unsigned count = least; count <= std::min(most, kMostCounts); ++count) {
    if (::snd_pcm_hw_params_test_channels(pcm, hw, count) != 0) continue;
    counts += (some++ == 0 ? "" : ", ") + std::to_string(count);
  }
  const bool all = some > 2 && some == most - least + 1;
  return all || most > kMostCounts ? std::to_string(least) + " to " + std::to_string(most) : counts;
}

// What the type of an opened PCM says of its samples; empty: they are the device's.
Message doubtOf(snd_pcm_type_t type, const std::string& device) {
  if (type == SND_PCM_TYPE_HW || type == SND_PCM_TYPE_NULL || type == SND_PCM_TYPE_DSNOOP) return {};
  // A plugin that reads elsewhere is PulseAudio, PipeWire, JACK; others may stand before one. What those convert, they
  // convert unseen.
  if (type == SND_PCM_TYPE_IOPLUG)
    return message("'%1' is a sound server's, which may change the rate and mix channels; hw: names the device itself",
                   device);
  return message(
      "'%1' converts, or stands before what does, which may change the rate and mix channels; hw: names the device "
      "itself",
      device);
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
      return Error{"'device' = '" + request.device + "'", daq::notOpened(),
                   message("%1; stillcut-cli devices lists what there is", ::snd_strerror(opened))};
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
    const snd_pcm_sframes_t got = take(into, static_cast<snd_pcm_uframes_t>(frames));
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
    const bool interleaved = ::snd_pcm_hw_params_set_access(pcm_, hw, SND_PCM_ACCESS_RW_INTERLEAVED) == 0;
    if (!interleaved && ::snd_pcm_hw_params_set_access(pcm_, hw, SND_PCM_ACCESS_RW_NONINTERLEAVED) < 0) {
      return Error{where, daq::notRead(), daq::onlyShared()};
    }
    const auto rate = static_cast<unsigned>(std::lround(request.rate.value));
    if (::snd_pcm_hw_params_set_rate(pcm_, hw, rate, 0) < 0) {
      return Error{where, message("'rate_hz' = %1 is not among its rates", std::to_string(rate)),
                   message("it has %1", ratesOf(pcm_, hw))};
    }
    daq::PcmFormat format;
    auto channels = static_cast<unsigned>(request.channels);  // at the least
    const unsigned most = channelsOf(hw).second;
    while (channels < most && ::snd_pcm_hw_params_test_channels(pcm_, hw, channels) != 0) ++channels;
    if (::snd_pcm_hw_params_set_channels(pcm_, hw, channels) < 0) {
      return Error{where, message("has no %1 channels ('inputs')", std::to_string(request.channels)),
                   message("it has %1", countsOf(pcm_, hw))};
    }
    format.channels = static_cast<int>(channels);
    const Kind* kind = nullptr;
    for (const Kind& k : kKinds) {
      if (request.bits != 0 && k.bits != request.bits) continue;
      if (::snd_pcm_hw_params_set_format(pcm_, hw, k.format) == 0) {
        kind = &k;
        break;
      }
    }
    if (kind == nullptr) {
      return Error{where, message("has no samples of %1 bits ('bits')", std::to_string(request.bits)),
                   message("it has %1", bitsOf(pcm_, hw))};
    }
    format.bits = kind->bits;
    format.sampleBytes = kind->bytes;
    auto period = static_cast<snd_pcm_uframes_t>(request.periodFrames);
    ::snd_pcm_hw_params_set_period_size_near(pcm_, hw, &period, nullptr);
    // As much as it has, up to two seconds: it is read a period at a time all the same.
    snd_pcm_uframes_t buffer = std::max<snd_pcm_uframes_t>(2 * rate, 4 * period);
    ::snd_pcm_hw_params_set_buffer_size_near(pcm_, hw, &buffer);
    const int set = ::snd_pcm_hw_params(pcm_, hw);
    if (set < 0) return Error{where, daq::notTogether(), foreign(::snd_strerror(set))};
    format.periodFrames = static_cast<int>(period);
    sampleBytes_ = static_cast<std::size_t>(kind->bytes);
    apart_.assign(interleaved ? 0 : channels, std::vector<char>(period * sampleBytes_));
    parts_.clear();
    for (std::vector<char>& part : apart_) parts_.push_back(part.data());
    format.doubt = doubtOf(::snd_pcm_type(pcm_), request.device);
    rate_ = request.rate.value;
    oldest_ = toDuration(Seconds(static_cast<double>(buffer) / rate_)) + std::chrono::seconds(1);
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
    if (done < 0) return Error{{}, daq::noStart(), foreign(::snd_strerror(done))};
    return Done{};
  }

  // Interleaved; a card that delivers its channels apart has them put together.
  snd_pcm_sframes_t take(void* into, snd_pcm_uframes_t frames) noexcept {
    if (parts_.empty()) return ::snd_pcm_readi(pcm_, into, frames);
    const snd_pcm_sframes_t got = ::snd_pcm_readn(pcm_, parts_.data(), frames);
    auto* to = static_cast<char*>(into);
    for (std::size_t f = 0; f < static_cast<std::size_t>(std::max<snd_pcm_sframes_t>(0, got)); ++f) {
      for (const std::vector<char>& part : apart_) {
        to = std::copy_n(part.data() + f * sampleBytes_, sampleBytes_, to);
      }
    }
    return got;
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
    if (told <= now && now - told < oldest_) taken = told;  // else it runs on another clock
  }

  snd_pcm_t* pcm_ = nullptr;
  double rate_ = 1.0;
  Duration oldest_{};  // so old a frame in its buffer can be
  std::size_t sampleBytes_ = 4;
  std::vector<std::vector<char>> apart_;  // by channel, where the card does not interleave
  std::vector<void*> parts_;              // their beginnings
};

std::string rangeOf(const std::string& device) {
  snd_pcm_t* pcm = nullptr;
  const int opened = ::snd_pcm_open(&pcm, device.c_str(), SND_PCM_STREAM_CAPTURE, SND_PCM_NONBLOCK);
  if (opened < 0) return std::string("cannot be opened: ") + ::snd_strerror(opened);
  snd_pcm_hw_params_t* hw = nullptr;
  snd_pcm_hw_params_alloca(&hw);
  ::snd_pcm_hw_params_any(pcm, hw);
  ::snd_pcm_hw_params_set_rate_resample(pcm, hw, 0);
  std::string text = countsOf(pcm, hw) + " channels, " + ratesOf(pcm, hw) + " Hz, " + bitsOf(pcm, hw) + " bits";
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
      // By the card's own word: its number goes to whichever was plugged in first.
      const std::string whose =
          known ? std::string("CARD=") + ::snd_ctl_card_info_get_id(card) : std::to_string(number);
      const std::string full = "hw:" + whose + (known ? ",DEV=" : ",") + std::to_string(device);
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
