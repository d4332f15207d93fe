#include "app/io/iio_inputs.h"

#ifdef STILLCUT_IIO
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace stillcut::app {

std::string attributeOf(const iio_device* device, const char* name) {
  std::array<char, 512> text{};
  if (::iio_device_attr_read(device, name, text.data(), text.size()) > 0) return text.data();
  for (unsigned i = 0; i < ::iio_device_get_channels_count(device); ++i) {
    const iio_channel* channel = ::iio_device_get_channel(device, i);
    if (::iio_channel_attr_read(channel, name, text.data(), text.size()) > 0) return text.data();
  }
  return {};
}

namespace {

bool isStamp(const iio_channel* channel) {
  return std::string_view(::iio_channel_get_id(channel)) == "timestamp";
}

}  // namespace

iio_channel* stampOf(const iio_device* device) {
  for (unsigned i = 0; i < ::iio_device_get_channels_count(device); ++i) {
    iio_channel* channel = ::iio_device_get_channel(device, i);
    if (!isStamp(channel) || !::iio_channel_is_scan_element(channel)) continue;
    if (::iio_channel_get_data_format(channel)->length == 64) return channel;
  }
  return nullptr;
}

std::vector<IioInput> inputsOf(const iio_device* device) {
  std::vector<IioInput> inputs;
  for (unsigned i = 0; i < ::iio_device_get_channels_count(device); ++i) {
    iio_channel* channel = ::iio_device_get_channel(device, i);
    if (::iio_channel_is_output(channel) || !::iio_channel_is_scan_element(channel) || isStamp(channel)) continue;
    const unsigned places = std::max(1U, ::iio_channel_get_data_format(channel)->repeat);
    for (unsigned place = 0; place < places; ++place) inputs.push_back({channel, place});
  }
  std::stable_sort(inputs.begin(), inputs.end(), [](const IioInput& a, const IioInput& b) {
    return ::iio_channel_get_index(a.channel) < ::iio_channel_get_index(b.channel);
  });
  return inputs;
}

std::string nameOf(const IioInput& input) {
  const std::string id = ::iio_channel_get_id(input.channel);
  return ::iio_channel_get_data_format(input.channel)->repeat > 1 ? id + "[" + std::to_string(input.place) + "]" : id;
}

std::string namesOf(const std::vector<IioInput>& inputs) {
  std::string names;
  for (const IioInput& input : inputs) names += (names.empty() ? "" : ", ") + nameOf(input);
  return names.empty() ? "none" : names;
}

// The scales of IIO lead to mV, mA, mW, thousandths of a degree, kPa (Linux, sysfs-bus-iio).
double unitOf(const iio_channel* channel) {
  const iio_data_format* format = ::iio_channel_get_data_format(channel);
  double scale = 1.0;
  if (format->with_scale) {
    scale = format->scale;
  } else if (::iio_channel_attr_read_double(channel, "scale", &scale) < 0) {
    scale = 1.0;
  }
  switch (::iio_channel_get_type(channel)) {
    case IIO_VOLTAGE:
    case IIO_ALTVOLTAGE:
    case IIO_CURRENT:
    case IIO_POWER:
    case IIO_TEMP:
      return scale * 1e-3;
    case IIO_PRESSURE:
      return scale * 1e3;
    default:
      return scale;
  }
}

double fullScaleOf(IioInput& input) {
  const iio_data_format* format = ::iio_channel_get_data_format(input.channel);
  if (::iio_channel_find_attr(input.channel, "offset") != nullptr &&
      ::iio_channel_attr_read_double(input.channel, "offset", &input.offset) < 0) {
    input.offset = 0.0;
  }
  const int bits = static_cast<int>(format->bits);
  const double low = format->is_signed ? -std::ldexp(1.0, bits - 1) : 0.0;
  const double high = std::ldexp(1.0, format->is_signed ? bits - 1 : bits);
  const double most = std::max(std::abs(low + input.offset), std::abs(high + input.offset));
  const int exponent = static_cast<int>(std::ceil(std::log2(most)));
  input.parts = std::ldexp(1.0, 31 - exponent);
  return std::ldexp(1.0, exponent);
}

std::uint64_t bitsAt(const iio_data_format& format, const char* at) noexcept {
  const unsigned bytes = format.length / 8;
  std::uint64_t value = 0;
  for (unsigned i = 0; i < bytes; ++i) {
    const unsigned from = format.is_be ? i : bytes - 1 - i;
    value = value << 8 | static_cast<unsigned char>(at[from]);
  }
  return value >> format.shift << (64 - format.bits);
}

double countAt(const iio_data_format& format, const char* at) noexcept {
  const unsigned unused = 64 - format.bits;
  const std::uint64_t value = bitsAt(format, at);
  if (!format.is_signed) return static_cast<double>(value >> unused);
  return static_cast<double>(static_cast<std::int64_t>(value) >> unused);
}

}  // namespace stillcut::app
#endif
