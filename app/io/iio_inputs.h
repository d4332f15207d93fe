// What an IIO device delivers in every scan, and how its bytes become numbers. In a build with libiio alone.
// Thread: that of IioDriver; bitsAt() and countAt() are real-time.
#pragma once

#ifdef STILLCUT_IIO
#include <iio.h>

#include <cstdint>
#include <string>
#include <vector>

namespace stillcut::app {

// A channel, or one of the values that a channel repeats (a quaternion has four).
struct IioInput {
  iio_channel* channel = nullptr;
  unsigned place = 0;   // among the repeated
  double offset = 0.0;  // added to what the device counts
  double parts = 1.0;   // of full scale in one step, times 2^31
};

// Of the device, or of the first of its channels that has it; empty: none has.
std::string attributeOf(const iio_device* device, const char* name);
// All that stream but the time stamp, in the order of the scan.
std::vector<IioInput> inputsOf(const iio_device* device);
std::string nameOf(const IioInput& input);
std::string namesOf(const std::vector<IioInput>& inputs);
// The time stamp of each scan; null: the device has none of 64 bits.
iio_channel* stampOf(const iio_device* device);

// SI units of one step.
double unitOf(const iio_channel* channel);
// Sets how steps become parts of full scale, a power of two of steps that holds all there can be. Returns it.
double fullScaleOf(IioInput& input);
// What the device counts at that place of its buffer, of 1 to 64 bits; as bits: at the top, where the sign is.
std::uint64_t bitsAt(const iio_data_format& format, const char* at) noexcept;
double countAt(const iio_data_format& format, const char* at) noexcept;

}  // namespace stillcut::app
#endif
