#include "app/io/comedi_driver.h"

#ifdef STILLCUT_COMEDI
#include <comedilib.h>
#include <poll.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <vector>

#include "app/io/comedi_inputs.h"
#include "core/daq/device_messages.h"

namespace stillcut::app {

#ifdef STILLCUT_COMEDI
namespace {

constexpr int kWaitMs = 100;
constexpr double kRateTolerance = 1e-3;  // a card divides its clock by whole numbers
constexpr double kFull = 2147483648.0;
constexpr double kHeld = 2.0;   // s that its buffer should hold
constexpr int kMostCards = 16;  // as the kernel numbers them

class ComediDriver final : public daq::PcmDriver {
 public:
  ComediDriver(int range, int reference) : range_(range), reference_(reference) {}
  ComediDriver(const ComediDriver&) = delete;
  ComediDriver& operator=(const ComediDriver&) = delete;
  ~ComediDriver() override { ComediDriver::close(); }

  Result<daq::PcmFormat> open(const daq::PcmRequest& request) override {
    close();
    device_ = ::comedi_open(request.device.c_str());
    if (device_ == nullptr) return Error{"'device' = '" + request.device + "'", daq::notOpened(), fault()};
    auto format = configure(request);
    if (!format) close();
    return format;
  }

  int read(void* into, int frames, Instant& taken) noexcept override {
    if (device_ == nullptr) return daq::kPcmGone;
    const std::size_t whole = frameBytes_ * static_cast<std::size_t>(frames);
    if (held_ < frameBytes_) {
      pollfd entry{::comedi_fileno(device_), POLLIN, 0};
      if (::poll(&entry, 1, kWaitMs) == 0) return 0;
      const ssize_t got = ::read(entry.fd, raw_.data() + held_, std::min(whole, raw_.size()) - held_);
      if (got < 0) return faultOf(errno);
      if (got == 0) return daq::kPcmOverrun;  // the command has ended
      held_ += static_cast<std::size_t>(got);
    }
    const std::size_t count = std::min(held_, whole) / frameBytes_;
    auto* out = static_cast<std::int32_t*>(into);
    for (std::size_t i = 0; i < count * channels_; ++i) out[i] = sample(i);
    const std::size_t used = count * frameBytes_;
    std::memmove(raw_.data(), raw_.data() + used, held_ - used);
    held_ -= used;
    const int waiting = std::max(0, ::comedi_get_buffer_contents(device_, subdevice_));
    const std::size_t left = static_cast<std::size_t>(waiting) / frameBytes_;
    const double older = static_cast<double>(left) / rate_;
    taken = SteadyClock().now() - toDuration(Seconds(older));
    return static_cast<int>(count);
  }

  bool recover() noexcept override {
    held_ = 0;
    return device_ != nullptr && ::comedi_cancel(device_, subdevice_) >= 0 && ::comedi_command(device_, &command_) >= 0;
  }

  bool countsLosses() const noexcept override { return true; }

  void close() noexcept override {
    if (device_ != nullptr) {
      ::comedi_cancel(device_, subdevice_);
      ::comedi_close(device_);
    }
    device_ = nullptr;
    held_ = 0;
  }

 private:
  static Message fault() { return foreign(::comedi_strerror(::comedi_errno())); }
  static int faultOf(int error) noexcept {
    if (error == EPIPE) return daq::kPcmOverrun;
    return error == ENODEV || error == EBADF ? daq::kPcmGone : daq::kPcmBroken;
  }

  Result<daq::PcmFormat> configure(const daq::PcmRequest& request) {
    const std::string where = "device '" + request.device + "'";
    const int readable = ::comedi_get_read_subdevice(device_);
    if (readable < 0) return Error{where, daq::noInputs(), daq::singleValues()};
    subdevice_ = static_cast<unsigned>(readable);
    const int inputs = ::comedi_get_n_channels(device_, subdevice_);
    if (inputs < request.channels) {
      return Error{where, message("has no input %1 ('inputs')", std::to_string(request.channels - 1)),
                   message("it has 0 to %1", std::to_string(inputs - 1))};
    }
    const int ranges = ::comedi_get_n_ranges(device_, subdevice_, 0);
    if (range_ >= ranges) {
      return Error{where, message("has no range %1 ('range')", std::to_string(range_)),
                   message("it has 0 to %1", std::to_string(ranges - 1))};
    }
    daq::PcmFormat format;
    format.channels = request.channels;
    format.periodFrames = request.periodFrames;
    channels_ = static_cast<std::size_t>(request.channels);
    sampleBytes_ = (::comedi_get_subdevice_flags(device_, subdevice_) & SDF_LSAMPL) != 0 ? 4 : 2;
    frameBytes_ = channels_ * sampleBytes_;
    raw_.assign(frameBytes_ * static_cast<std::size_t>(request.periodFrames), 0);
    list_.clear();
    most_ = ::comedi_get_maxdata(device_, subdevice_, 0);
    converters_ =
        converters(device_, subdevice_, static_cast<unsigned>(channels_), static_cast<unsigned>(range_), format.doubt);
    if (converters_.empty()) return Error{where, message("does not tell its range"), fault()};
    full_.clear();
    for (unsigned c = 0; c < channels_; ++c) {
      list_.push_back(CR_PACK(c, static_cast<unsigned>(range_), static_cast<unsigned>(reference_)));
      full_.push_back(std::max(std::abs(volts(converters_[c], 0)), std::abs(volts(converters_[c], most_ + 1))));
    }
    format.siOfFullScale = full_;
    rate_ = request.rate.value;
    makeRoom();
    if (const Status begun = begin(request.rate); !begun) return Error{where, begun.error().what, begun.error().why};
    return format;
  }

  // As much as the card's driver allows; it then loses nothing while the program is late.
  void makeRoom() {
    const int most = ::comedi_get_max_buffer_size(device_, subdevice_);
    const auto wanted = static_cast<std::size_t>(kHeld * rate_) * frameBytes_;
    if (most <= 0 || ::comedi_get_buffer_size(device_, subdevice_) >= static_cast<int>(wanted)) return;
    static_cast<void>(::comedi_set_buffer_size(
        device_, subdevice_, static_cast<unsigned>(std::min(wanted, static_cast<std::size_t>(most)))));
  }

  Status begin(Hertz rate) {
    const double asked = 1e9 / rate.value;  // ns
    if (::comedi_get_cmd_generic_timed(device_, subdevice_, &command_, static_cast<unsigned>(channels_),
                                       static_cast<unsigned>(std::lround(asked))) < 0) {
      return Error{{}, message("cannot stream at a rate"), fault()};
    }
    command_.chanlist = list_.data();
    command_.chanlist_len = static_cast<unsigned>(channels_);
    command_.stop_src = TRIG_NONE;
    command_.stop_arg = 0;
    ::comedi_command_test(device_, &command_);  // the card puts its own values where ours do not fit
    ::comedi_command_test(device_, &command_);
    const double is = command_.scan_begin_src == TRIG_TIMER
                          ? command_.scan_begin_arg
                          : static_cast<double>(command_.convert_arg) * static_cast<double>(channels_);
    if (std::abs(is - asked) > kRateTolerance * asked) {
      return Error{{},
                   message("'rate_hz' = %1 is not among its rates", std::to_string(std::lround(rate.value))),
                   message("the nearest is %1", std::to_string(is > 0.0 ? 1e9 / is : 0.0))};
    }
    if (::comedi_command(device_, &command_) < 0) return Error{{}, daq::noStream(), fault()};
    return Done{};
  }

  // Where it lies in the card's range, which need not begin at minus full scale, at the top of 32 bits.
  std::int32_t sample(std::size_t i) const noexcept {
    std::uint32_t value = 0;
    if (sampleBytes_ == 4) {
      std::memcpy(&value, raw_.data() + 4 * i, 4);
    } else {
      std::uint16_t narrow = 0;
      std::memcpy(&narrow, raw_.data() + 2 * i, 2);
      value = narrow;
    }
    if (value >= most_) return std::numeric_limits<std::int32_t>::max();  // at its limit
    const std::size_t c = i % channels_;
    return static_cast<std::int32_t>(std::clamp(kFull * volts(converters_[c], value) / full_[c], -kFull, kFull - 1.0));
  }

  int range_, reference_;
  comedi_t* device_ = nullptr;
  unsigned subdevice_ = 0;
  comedi_cmd command_{};
  std::vector<unsigned> list_;
  std::vector<comedi_polynomial_t> converters_;  // by channel
  std::vector<double> full_;                     // V, by channel
  lsampl_t most_ = 65535;
  double rate_ = 1.0;
  std::size_t channels_ = 1, sampleBytes_ = 2, frameBytes_ = 2;
  std::vector<char> raw_;
  std::size_t held_ = 0;  // bytes
};

}  // namespace

std::unique_ptr<daq::PcmDriver> makeComediDriver(int range, int reference) {
  return std::make_unique<ComediDriver>(range, reference);
}

std::vector<daq::PcmDevice> comediDevices(const std::string& devices) {
  std::vector<daq::PcmDevice> all;
  for (int number = 0; number < kMostCards; ++number) {
    const std::string name = devices + "/comedi" + std::to_string(number);
    std::error_code none;
    comedi_t* card = std::filesystem::exists(name, none) ? ::comedi_open(name.c_str()) : nullptr;
    if (card == nullptr) continue;
    const int inputs = ::comedi_get_read_subdevice(card);
    if (inputs >= 0) {
      const char* board = ::comedi_get_board_name(card);
      all.push_back({name, board != nullptr ? board : "", rangeOf(card, static_cast<unsigned>(inputs))});
    }
    ::comedi_close(card);
  }
  return all;
}
#else
std::unique_ptr<daq::PcmDriver> makeComediDriver(int, int) {
  return nullptr;
}

std::vector<daq::PcmDevice> comediDevices(const std::string&) {
  return {};
}
#endif

}  // namespace stillcut::app
