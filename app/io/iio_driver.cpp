#include "app/io/iio_driver.h"

#ifdef STILLCUT_IIO
#include <iio.h>
#include <pthread.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace stillcut::app {

#ifdef STILLCUT_IIO
namespace {

constexpr unsigned kPatienceMs = 500;
constexpr double kRateTolerance = 1e-3;  // what a device may round

std::string reasonOf(int error) {
  std::array<char, 128> text{};
  ::iio_strerror(error, text.data(), text.size());
  return text.data();
}

std::string attributeOf(const iio_device* device, const char* name) {
  std::array<char, 512> text{};
  if (::iio_device_attr_read(device, name, text.data(), text.size()) > 0) return text.data();
  for (unsigned i = 0; i < ::iio_device_get_channels_count(device); ++i) {
    const iio_channel* channel = ::iio_device_get_channel(device, i);
    if (::iio_channel_attr_read(channel, name, text.data(), text.size()) > 0) return text.data();
  }
  return {};
}

std::vector<iio_channel*> inputsOf(const iio_device* device) {
  std::vector<iio_channel*> inputs;
  for (unsigned i = 0; i < ::iio_device_get_channels_count(device); ++i) {
    iio_channel* channel = ::iio_device_get_channel(device, i);
    const bool timestamp = std::string_view(::iio_channel_get_id(channel)) == "timestamp";
    if (!::iio_channel_is_output(channel) && ::iio_channel_is_scan_element(channel) && !timestamp) {
      inputs.push_back(channel);
    }
  }
  std::sort(inputs.begin(), inputs.end(), [](const iio_channel* a, const iio_channel* b) {
    return ::iio_channel_get_index(a) < ::iio_channel_get_index(b);
  });
  return inputs;
}

std::string namesOf(const std::vector<iio_channel*>& inputs) {
  std::string names;
  for (const iio_channel* c : inputs) names += (names.empty() ? "" : ", ") + std::string(::iio_channel_get_id(c));
  return names.empty() ? "none" : names;
}

// SI units of one step: IIO scales are in m/s2, but for voltages in mV.
double unitOf(const iio_channel* channel) {
  const iio_data_format* format = ::iio_channel_get_data_format(channel);
  double scale = 1.0;
  if (format->with_scale) {
    scale = format->scale;
  } else if (::iio_channel_attr_read_double(channel, "scale", &scale) < 0) {
    scale = 1.0;
  }
  return ::iio_channel_get_type(channel) == IIO_VOLTAGE ? scale * 1e-3 : scale;
}

// libiio writes to a socket whose peer has hung up, and that would end the program.
class QuietPipe {
 public:
  QuietPipe() noexcept {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~QuietPipe() {
    const timespec atOnce{};
    while (::sigismember(&before_, SIGPIPE) == 0 && ::sigtimedwait(&pipe_, nullptr, &atOnce) > 0) {
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  QuietPipe(const QuietPipe&) = delete;
  QuietPipe& operator=(const QuietPipe&) = delete;

 private:
  sigset_t pipe_{}, before_{};
};

class IioDriver final : public daq::PcmDriver {
 public:
  IioDriver(std::string uri, std::string trigger) : uri_(std::move(uri)), trigger_(std::move(trigger)) {}
  IioDriver(const IioDriver&) = delete;
  IioDriver& operator=(const IioDriver&) = delete;
  ~IioDriver() override { IioDriver::close(); }

  Result<daq::PcmFormat> open(const daq::PcmRequest& request) override {
    const QuietPipe quiet;
    close();
    context_ = ::iio_create_context_from_uri(uri_.c_str());
    if (context_ == nullptr) return Error{"'uri' = '" + uri_ + "'", "does not answer", reasonOf(errno)};
    static_cast<void>(::iio_context_set_timeout(context_, kPatienceMs));
    auto format = configure(request);
    if (!format) close();
    return format;
  }

  int read(void* into, int frames, Instant& taken) noexcept override {
    if (buffer_ == nullptr) return daq::kPcmGone;
    if (left_ == 0) {
      const QuietPipe quiet;
      const ssize_t bytes = ::iio_buffer_refill(buffer_);
      if (bytes == -EAGAIN || bytes == 0) return 0;
      if (bytes < 0) return bytes == -EPIPE ? daq::kPcmOverrun : daq::kPcmGone;
      seen_ = SteadyClock().now();
      left_ = static_cast<int>(bytes / ::iio_buffer_step(buffer_));
      at_ = 0;
    }
    const int taking = std::min(frames, left_);
    for (std::size_t c = 0; c < inputs_.size(); ++c) copy(c, static_cast<std::int32_t*>(into), taking);
    at_ += taking;
    left_ -= taking;
    taken = seen_ - toDuration(Seconds(left_ / rate_));
    return taking;
  }

  bool recover() noexcept override { return false; }  // the context is made anew

  bool countsLosses() const noexcept override { return false; }

  void close() noexcept override {
    const QuietPipe quiet;
    if (buffer_ != nullptr) ::iio_buffer_destroy(buffer_);
    if (context_ != nullptr) ::iio_context_destroy(context_);
    buffer_ = nullptr;
    context_ = nullptr;
    inputs_.clear();
    left_ = 0;
  }

 private:
  Result<daq::PcmFormat> configure(const daq::PcmRequest& request) {
    const std::string where = "device '" + request.device + "'";
    iio_device* device = ::iio_context_find_device(context_, request.device.c_str());
    if (device == nullptr) return Error{where, "is not at " + uri_, "there are: " + namesOfAll(false)};
    const std::vector<iio_channel*> all = inputsOf(device);
    if (static_cast<int>(all.size()) < request.channels) {
      return Error{where, "has no input " + std::to_string(request.channels - 1) + " ('inputs')",
                   "it has, from 0: " + namesOf(all)};
    }
    if (const Status set = setRate(device, request.rate); !set) return Error{where, set.error().what, set.error().why};
    if (const Status set = setTrigger(device); !set) return Error{where, set.error().what, set.error().why};
    daq::PcmFormat format;
    format.channels = request.channels;
    format.periodFrames = request.periodFrames;
    for (iio_channel* channel : all) {
      const bool wanted = static_cast<int>(inputs_.size()) < request.channels;
      wanted ? ::iio_channel_enable(channel) : ::iio_channel_disable(channel);
      if (!wanted) continue;
      const iio_data_format* data = ::iio_channel_get_data_format(channel);
      if (data->length > 32 || data->repeat > 1) {
        return Error{where, std::string("input ") + ::iio_channel_get_id(channel) + " has more than 32 bits", ""};
      }
      inputs_.push_back(channel);
      format.siOfFullScale.push_back(unitOf(channel) * std::ldexp(1.0, static_cast<int>(data->bits) - 1));
    }
    rate_ = request.rate.value;
    buffer_ = ::iio_device_create_buffer(device, static_cast<std::size_t>(request.periodFrames), false);
    if (buffer_ == nullptr) {
      return Error{where, "does not stream", reasonOf(errno) + "; some devices need a 'trigger'"};
    }
    return format;
  }

  Status setRate(iio_device* device, Hertz rate) const {
    static constexpr const char* kName = "sampling_frequency";
    if (attributeOf(device, kName).empty()) return Done{};  // its trigger sets the pace
    if (::iio_device_attr_write_double(device, kName, rate.value) < 0) {
      for (iio_channel* c : inputsOf(device)) static_cast<void>(::iio_channel_attr_write_double(c, kName, rate.value));
    }
    const std::string text = attributeOf(device, kName);
    const double is = std::strtod(text.c_str(), nullptr);
    if (std::abs(is - rate.value) <= kRateTolerance * rate.value) return Done{};
    const std::string available = attributeOf(device, "sampling_frequency_available");
    return Error{"", "'rate_hz' = " + std::to_string(std::lround(rate.value)) + " is not among its rates",
                 "it samples at " + text + (available.empty() ? "" : ", and could at " + available)};
  }

  Status setTrigger(const iio_device* device) const {
    if (trigger_.empty()) return Done{};
    const iio_device* trigger = ::iio_context_find_device(context_, trigger_.c_str());
    if (trigger == nullptr || !::iio_device_is_trigger(trigger)) {
      return Error{"", "there is no trigger '" + trigger_ + "' at " + uri_, "there are: " + namesOfAll(true)};
    }
    const int set = ::iio_device_set_trigger(device, trigger);
    if (set < 0) return Error{"", "does not take the trigger '" + trigger_ + "'", reasonOf(-set)};
    return Done{};
  }

  std::string namesOfAll(bool triggers) const {
    std::string names;
    for (unsigned i = 0; i < ::iio_context_get_devices_count(context_); ++i) {
      const iio_device* device = ::iio_context_get_device(context_, i);
      if (::iio_device_is_trigger(device) != triggers) continue;
      const char* name = ::iio_device_get_name(device);
      names += (names.empty() ? "" : ", ") + std::string(name != nullptr ? name : ::iio_device_get_id(device));
    }
    return names.empty() ? "none" : names;
  }

  // One channel of the buffer to the top of 32 bits each.
  void copy(std::size_t c, std::int32_t* into, int frames) const noexcept {
    const iio_channel* channel = inputs_[c];
    const iio_data_format* format = ::iio_channel_get_data_format(channel);
    const auto* from = static_cast<const char*>(::iio_buffer_first(buffer_, channel));
    const std::ptrdiff_t step = ::iio_buffer_step(buffer_);
    for (int f = 0; f < frames; ++f) {
      std::uint32_t value = 0;
      ::iio_channel_convert(channel, &value, from + (at_ + f) * step);
      if (!format->is_signed) value -= 1U << (format->bits - 1);
      into[static_cast<std::size_t>(f) * inputs_.size() + c] = static_cast<std::int32_t>(value << (32 - format->bits));
    }
  }

  std::string uri_, trigger_;
  iio_context* context_ = nullptr;
  iio_buffer* buffer_ = nullptr;
  std::vector<iio_channel*> inputs_;
  double rate_ = 1.0;
  int left_ = 0, at_ = 0;  // frames of the buffer
  Instant seen_{};
};

}  // namespace

std::unique_ptr<daq::PcmDriver> makeIioDriver(const std::string& uri, const std::string& trigger) {
  return std::make_unique<IioDriver>(uri, trigger);
}

std::vector<daq::PcmDevice> iioDevices(const std::string& uri) {
  std::vector<daq::PcmDevice> all;
  iio_context* context = ::iio_create_context_from_uri(uri.c_str());
  if (context == nullptr) return all;
  for (unsigned i = 0; i < ::iio_context_get_devices_count(context); ++i) {
    const iio_device* device = ::iio_context_get_device(context, i);
    const std::vector<iio_channel*> inputs = inputsOf(device);
    if (inputs.empty()) continue;
    const char* name = ::iio_device_get_name(device);
    const std::string rate = attributeOf(device, "sampling_frequency");
    const std::string rates = attributeOf(device, "sampling_frequency_available");
    all.push_back(
        {name != nullptr ? name : ::iio_device_get_id(device), uri,
         namesOf(inputs) + (rate.empty() ? "" : "; " + rate + " Hz") + (rates.empty() ? "" : " of " + rates)});
  }
  ::iio_context_destroy(context);
  return all;
}
#else
std::unique_ptr<daq::PcmDriver> makeIioDriver(const std::string&, const std::string&) {
  return nullptr;
}

std::vector<daq::PcmDevice> iioDevices(const std::string&) {
  return {};
}
#endif

}  // namespace stillcut::app
