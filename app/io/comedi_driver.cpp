#include "app/io/comedi_driver.h"

#ifdef STILLCUT_COMEDI
#include <comedilib.h>
#include <poll.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace stillcut::app {

#ifdef STILLCUT_COMEDI
namespace {

constexpr int kWaitMs = 100;
constexpr double kRateTolerance = 1e-3;  // a card divides its clock by whole numbers

class ComediDriver final : public daq::PcmDriver {
 public:
  ComediDriver(int range, int reference) : range_(range), reference_(reference) {}
  ComediDriver(const ComediDriver&) = delete;
  ComediDriver& operator=(const ComediDriver&) = delete;
  ~ComediDriver() override { ComediDriver::close(); }

  Result<daq::PcmFormat> open(const daq::PcmRequest& request) override {
    close();
    device_ = ::comedi_open(request.device.c_str());
    if (device_ == nullptr) return Error{"'device' = '" + request.device + "'", "cannot be opened", fault()};
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
    taken = SteadyClock().now();
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
  static std::string fault() { return ::comedi_strerror(::comedi_errno()); }
  static int faultOf(int error) noexcept {
    if (error == EPIPE) return daq::kPcmOverrun;
    return error == ENODEV || error == EBADF ? daq::kPcmGone : daq::kPcmBroken;
  }

  Result<daq::PcmFormat> configure(const daq::PcmRequest& request) {
    const std::string where = "device '" + request.device + "'";
    const int readable = ::comedi_get_read_subdevice(device_);
    if (readable < 0) return Error{where, "has no inputs that stream", "it may read single values only"};
    subdevice_ = static_cast<unsigned>(readable);
    const int inputs = ::comedi_get_n_channels(device_, subdevice_);
    if (inputs < request.channels) {
      return Error{where, "has no input " + std::to_string(request.channels - 1) + " ('inputs')",
                   "it has 0 to " + std::to_string(inputs - 1)};
    }
    const int ranges = ::comedi_get_n_ranges(device_, subdevice_, 0);
    if (range_ >= ranges) {
      return Error{where, "has no range " + std::to_string(range_) + " ('range')",
                   "it has 0 to " + std::to_string(ranges - 1)};
    }
    daq::PcmFormat format;
    format.channels = request.channels;
    format.periodFrames = request.periodFrames;
    channels_ = static_cast<std::size_t>(request.channels);
    sampleBytes_ = (::comedi_get_subdevice_flags(device_, subdevice_) & SDF_LSAMPL) != 0 ? 4 : 2;
    frameBytes_ = channels_ * sampleBytes_;
    raw_.assign(frameBytes_ * static_cast<std::size_t>(request.periodFrames), 0);
    list_.clear();
    for (unsigned c = 0; c < channels_; ++c) {
      list_.push_back(CR_PACK(c, static_cast<unsigned>(range_), static_cast<unsigned>(reference_)));
      const comedi_range* span = ::comedi_get_range(device_, subdevice_, c, static_cast<unsigned>(range_));
      if (span == nullptr) return Error{where, "does not tell its range", fault()};
      format.siOfFullScale.push_back(0.5 * (span->max - span->min));
    }
    bits_ = std::bit_width(::comedi_get_maxdata(device_, subdevice_, 0));
    if (const Status begun = begin(request.rate); !begun) return Error{where, begun.error().what, begun.error().why};
    return format;
  }

  Status begin(Hertz rate) {
    const double asked = 1e9 / rate.value;  // ns
    if (::comedi_get_cmd_generic_timed(device_, subdevice_, &command_, static_cast<unsigned>(channels_),
                                       static_cast<unsigned>(std::lround(asked))) < 0) {
      return Error{"", "cannot stream at a rate", fault()};
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
      return Error{"", "'rate_hz' = " + std::to_string(std::lround(rate.value)) + " is not among its rates",
                   "the nearest is " + std::to_string(is > 0.0 ? 1e9 / is : 0.0)};
    }
    if (::comedi_command(device_, &command_) < 0) return Error{"", "does not stream", fault()};
    return Done{};
  }

  // Offset binary to the top of 32 bits.
  std::int32_t sample(std::size_t i) const noexcept {
    std::uint32_t value = 0;
    if (sampleBytes_ == 4) {
      std::memcpy(&value, raw_.data() + 4 * i, 4);
    } else {
      std::uint16_t narrow = 0;
      std::memcpy(&narrow, raw_.data() + 2 * i, 2);
      value = narrow;
    }
    return static_cast<std::int32_t>((value - (1U << (bits_ - 1))) << (32 - bits_));
  }

  int range_, reference_;
  comedi_t* device_ = nullptr;
  unsigned subdevice_ = 0;
  comedi_cmd command_{};
  std::vector<unsigned> list_;
  std::size_t channels_ = 1, sampleBytes_ = 2, frameBytes_ = 2;
  int bits_ = 16;
  std::vector<char> raw_;
  std::size_t held_ = 0;  // bytes
};

}  // namespace

std::unique_ptr<daq::PcmDriver> makeComediDriver(int range, int reference) {
  return std::make_unique<ComediDriver>(range, reference);
}
#else
std::unique_ptr<daq::PcmDriver> makeComediDriver(int, int) {
  return nullptr;
}
#endif

}  // namespace stillcut::app
