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
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/io/iio_inputs.h"
#include "core/daq/device_messages.h"
#include "core/daq/scan_stamps.h"

namespace stillcut::app {

#ifdef STILLCUT_IIO
namespace {

constexpr unsigned kPatienceMs = 500;
constexpr double kRateTolerance = 1e-3;  // what a device may round

Message reasonOf(int error) {
  std::array<char, 128> text{};
  ::iio_strerror(error, text.data(), text.size());
  return foreign(text.data());
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
    if (context_ == nullptr) return Error{"'uri' = '" + uri_ + "'", daq::noAnswer(), reasonOf(errno)};
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
      takeStamps();
    }
    int taking = std::min(frames, left_);
    if (stamp_ != nullptr && taking > 0) {
      taking = stamps_.run({stampsHeld_.data() + at_, static_cast<std::size_t>(taking)});
      missed_ = taking == 0;
      if (missed_) return daq::kPcmOverrun;
    }
    for (std::size_t c = 0; c < inputs_.size(); ++c) copy(c, static_cast<std::int32_t*>(into), taking);
    at_ += taking;
    left_ -= taking;
    const bool stamped = stamp_ != nullptr && stamps_.believed();
    taken = stamped ? stamps_.taken(stampsHeld_[static_cast<std::size_t>(at_ - 1)])
                    : seen_ - toDuration(Seconds(left_ / rate_));
    return taking;
  }

  // Scans that are missing in the buffer end nothing; else the context is made anew.
  bool recover() noexcept override { return std::exchange(missed_, false); }

  bool countsLosses() const noexcept override { return false; }

  void close() noexcept override {
    const QuietPipe quiet;
    if (buffer_ != nullptr) ::iio_buffer_destroy(buffer_);
    if (context_ != nullptr) ::iio_context_destroy(context_);
    buffer_ = nullptr;
    context_ = nullptr;
    inputs_.clear();
    stamp_ = nullptr;
    left_ = 0;
  }

 private:
  Result<daq::PcmFormat> configure(const daq::PcmRequest& request) {
    const std::string where = "device '" + request.device + "'";
    iio_device* device = ::iio_context_find_device(context_, request.device.c_str());
    if (device == nullptr)
      return Error{where, message("is not at %1", uri_), message("there are: %1", namesOfAll(false))};
    const std::vector<IioInput> all = inputsOf(device);
    if (static_cast<int>(all.size()) < request.channels) {
      return Error{where, message("has no input %1 ('inputs')", std::to_string(request.channels - 1)),
                   message("it has, from 0: %1", namesOf(all))};
    }
    if (const Status set = setRate(device, request.rate); !set) return Error{where, set.error().what, set.error().why};
    if (const Status set = setTrigger(device); !set) return Error{where, set.error().what, set.error().why};
    daq::PcmFormat format;
    format.channels = request.channels;
    format.periodFrames = request.periodFrames;
    for (const IioInput& input : all) ::iio_channel_disable(input.channel);
    stamp_ = stampOf(device);
    if (stamp_ != nullptr) {
      ::iio_channel_enable(stamp_);
      static_cast<void>(::iio_device_attr_write(device, "current_timestamp_clock", "monotonic"));  // the one not set
      stamps_.prepare(request.rate);
    } else {
      format.doubt = daq::uncounted();
    }
    for (int c = 0; c < request.channels; ++c) {
      IioInput input = all[static_cast<std::size_t>(c)];
      const iio_data_format* data = ::iio_channel_get_data_format(input.channel);
      if (data->length > 64 || data->length % 8 != 0 || data->bits == 0 || data->bits + data->shift > data->length) {
        return Error{where,
                     message("input %1 has %2 bits in %3", nameOf(input), std::to_string(data->bits),
                             std::to_string(data->length)),
                     message("up to 64 can be read")};
      }
      ::iio_channel_enable(input.channel);
      format.siOfFullScale.push_back(unitOf(input.channel) * fullScaleOf(input));
      inputs_.push_back(input);
    }
    rate_ = request.rate.value;
    stampsHeld_.assign(static_cast<std::size_t>(request.periodFrames), 0);
    buffer_ = ::iio_device_create_buffer(device, static_cast<std::size_t>(request.periodFrames), false);
    if (buffer_ == nullptr) {
      return Error{where, daq::noStream(), message("%1; some devices need a 'trigger'", reasonOf(errno))};
    }
    return format;
  }

  Status setRate(iio_device* device, Hertz rate) const {
    static constexpr const char* kName = "sampling_frequency";
    if (attributeOf(device, kName).empty()) return Done{};  // its trigger sets the pace
    if (::iio_device_attr_write_double(device, kName, rate.value) < 0) {
      for (const IioInput& input : inputsOf(device)) {
        static_cast<void>(::iio_channel_attr_write_double(input.channel, kName, rate.value));
      }
    }
    const std::string text = attributeOf(device, kName);
    const double is = std::strtod(text.c_str(), nullptr);
    if (std::abs(is - rate.value) <= kRateTolerance * rate.value) return Done{};
    const std::string available = attributeOf(device, "sampling_frequency_available");
    return Error{{},
                 message("'rate_hz' = %1 is not among its rates", std::to_string(std::lround(rate.value))),
                 available.empty() ? message("it samples at %1", text)
                                   : message("it samples at %1, and could at %2", text, available)};
  }

  Status setTrigger(const iio_device* device) const {
    if (trigger_.empty()) return Done{};
    const iio_device* trigger = ::iio_context_find_device(context_, trigger_.c_str());
    if (trigger == nullptr || !::iio_device_is_trigger(trigger)) {
      return Error{
          {}, message("there is no trigger '%1' at %2", trigger_, uri_), message("there are: %1", namesOfAll(true))};
    }
    const int set = ::iio_device_set_trigger(device, trigger);
    if (set < 0) return Error{{}, message("does not take the trigger '%1'", trigger_), reasonOf(-set)};
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

  void takeStamps() noexcept {
    if (stamp_ == nullptr || left_ == 0) return;
    const iio_data_format& format = *::iio_channel_get_data_format(stamp_);
    const auto* from = static_cast<const char*>(::iio_buffer_first(buffer_, stamp_));
    const std::ptrdiff_t step = ::iio_buffer_step(buffer_);
    left_ = std::min(left_, static_cast<int>(stampsHeld_.size()));
    for (int f = 0; f < left_; ++f) {
      stampsHeld_[static_cast<std::size_t>(f)] = static_cast<std::int64_t>(bitsAt(format, from + f * step));
    }
    stamps_.arrived(stampsHeld_[static_cast<std::size_t>(left_ - 1)], seen_);
  }

  // One input of the buffer, full scale at the top of 32 bits.
  void copy(std::size_t c, std::int32_t* into, int frames) const noexcept {
    constexpr double kTop = 2147483647.0;
    const IioInput& input = inputs_[c];
    const iio_data_format& format = *::iio_channel_get_data_format(input.channel);
    const auto* from =
        static_cast<const char*>(::iio_buffer_first(buffer_, input.channel)) + input.place * (format.length / 8);
    const std::ptrdiff_t step = ::iio_buffer_step(buffer_);
    for (int f = 0; f < frames; ++f) {
      const double value = (countAt(format, from + (at_ + f) * step) + input.offset) * input.parts;
      into[static_cast<std::size_t>(f) * inputs_.size() + c] = static_cast<std::int32_t>(std::min(value, kTop));
    }
  }

  std::string uri_, trigger_;
  iio_context* context_ = nullptr;
  iio_buffer* buffer_ = nullptr;
  std::vector<IioInput> inputs_;
  double rate_ = 1.0;
  iio_channel* stamp_ = nullptr;  // null: its scans bear no time
  daq::ScanStamps stamps_;
  std::vector<std::int64_t> stampsHeld_;  // ns, of the buffer
  bool missed_ = false;                   // what recover() is asked about is a loss that the stamps show
  int left_ = 0, at_ = 0;                 // frames of the buffer
  Instant seen_{};
};

}  // namespace

std::unique_ptr<daq::PcmDriver> makeIioDriver(const std::string& uri, const std::string& trigger) {
  return std::make_unique<IioDriver>(uri, trigger);
}

Result<std::vector<daq::PcmDevice>> iioDevices(const std::string& uri) {
  const QuietPipe quiet;
  iio_context* context = ::iio_create_context_from_uri(uri.c_str());
  if (context == nullptr) return Error{"'uri' = '" + uri + "'", daq::noAnswer(), reasonOf(errno)};
  std::vector<daq::PcmDevice> all;
  for (unsigned i = 0; i < ::iio_context_get_devices_count(context); ++i) {
    const iio_device* device = ::iio_context_get_device(context, i);
    const std::vector<IioInput> inputs = inputsOf(device);
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

std::vector<std::string> iioContexts() {
  std::vector<std::string> uris;
  // Who announces itself on the network is known to Avahi, without which the library complains.
  const bool announced = std::filesystem::exists("/run/avahi-daemon/socket");
  iio_scan_context* scan = ::iio_create_scan_context(announced ? "usb,ip" : "usb", 0);
  if (scan == nullptr) return uris;
  iio_context_info** found = nullptr;
  const ssize_t count = ::iio_scan_context_get_info_list(scan, &found);
  for (ssize_t i = 0; i < count; ++i) {
    uris.emplace_back(::iio_context_info_get_uri(found[i]));
  }
  if (count >= 0) ::iio_context_info_list_free(found);
  ::iio_scan_context_destroy(scan);
  return uris;
}
#else
std::unique_ptr<daq::PcmDriver> makeIioDriver(const std::string&, const std::string&) {
  return nullptr;
}

Result<std::vector<daq::PcmDevice>> iioDevices(const std::string&) {
  return std::vector<daq::PcmDevice>();
}

std::vector<std::string> iioContexts() {
  return {};
}
#endif

}  // namespace stillcut::app
