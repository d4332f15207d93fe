// StreamDecoder: from the bytes of a serial line or a socket to one sample of every channel at a time.
// Thread: driver; real-time after it is made.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/config/component_settings.h"

namespace stillcut::daq {

class StreamDecoder {
 public:
  virtual ~StreamDecoder() = default;
  // Takes as many bytes as it has room for and returns how many: take() what is there, then feed the rest.
  virtual std::size_t feed(std::string_view bytes) noexcept = 0;
  static constexpr std::uint64_t kUnknown = ~std::uint64_t{0};
  // The next instant: one value a channel. `lost` are the instants missing before it, as far as the stream tells;
  // kUnknown: its counter has begun anew.
  // False: more bytes are needed.
  virtual bool take(std::span<float> values, std::uint64_t& lost) noexcept = 0;
  // The line was cut: what is half there is dropped, and counters begin anew.
  virtual void reset() noexcept = 0;
  // The stream has a counter: what is missing shows in it, however much it is.
  virtual bool countsLosses() const noexcept = 0;
  // A counter of few bits shows what is missing but for multiples of so many instants; 1: there is no such counter.
  virtual std::uint64_t lossUnit() const noexcept { return 1; }
  // Frames or lines that were damaged, since the start.
  virtual std::uint64_t damaged() const noexcept = 0;
};

// Key `format`: binary or text. Of binary frames: sync, counter, instants (in a frame), sample, byte_order, checksum;
// of text: counted (each line begins with a counter). What is wrong stays in `settings`.
std::unique_ptr<StreamDecoder> makeDecoder(config::ComponentSettings& settings, int channels);

}  // namespace stillcut::daq
