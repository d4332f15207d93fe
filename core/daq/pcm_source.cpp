#include "core/daq/pcm_source.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <thread>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr auto kRetry = std::chrono::milliseconds(500);
constexpr auto kSilence = std::chrono::seconds(2);  // a stream that says nothing for so long has ended
constexpr auto kNap = std::chrono::milliseconds(20);

// Little-endian, as every format that the driver asks for.
std::int32_t whole(const unsigned char* at, int bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) value |= static_cast<std::uint32_t>(at[i]) << (8 * i);
  return static_cast<std::int32_t>(value);
}

}  // namespace

PcmSource::PcmSource(std::string name, PcmRequest request, std::vector<ChannelInfo> channels, std::vector<int> inputs,
                     std::unique_ptr<PcmDriver> driver, const Clock& clock)
    : name_(std::move(name)),
      request_(std::move(request)),
      channels_(std::move(channels)),
      inputs_(std::move(inputs)),
      driver_(std::move(driver)),
      clock_(clock) {
  request_.channels = *std::max_element(inputs_.begin(), inputs_.end()) + 1;
}

Result<SourceFormat> PcmSource::open() {
  auto opened = driver_->open(request_);
  if (!opened) return Error{message("%1 %2", name_, opened.error().where), opened.error().what, opened.error().why};
  format_ = *opened;
  streaming_ = true;
  blockFrames_ = format_.periodFrames;
  stamper_.prepare(request_.rate, blockFrames_, driver_->countsLosses());
  raw_.assign(static_cast<std::size_t>(blockFrames_ * format_.channels * format_.sampleBytes), 0);
  SourceFormat format;
  format.rate = request_.rate;
  format.blockFrames = blockFrames_;
  format.channels = channels_;
  format.doubt = format_.doubt;
  for (std::size_t c = 0; c < inputs_.size() && !format_.siOfFullScale.empty(); ++c) {
    format.channels[c].scale *= format_.siOfFullScale[static_cast<std::size_t>(inputs_[c])];
  }
  return format;
}

Message PcmSource::trouble() const {
  const std::lock_guard lock(saying_);
  return trouble_;
}

void PcmSource::say(const Message& trouble) {
  const std::lock_guard lock(saying_);
  trouble_ = trouble;
}

// Unplugged: until it is back as it was, or stop().
bool PcmSource::reopen() noexcept {
  driver_->close();
  streaming_ = false;
  while (!stopped_.load(std::memory_order_relaxed)) {
    if (clock_.now() >= nextOpen_) {
      nextOpen_ = clock_.now() + kRetry;
      try {
        const auto opened = driver_->open(request_);
        streaming_ = opened && opened->channels == format_.channels && opened->sampleBytes == format_.sampleBytes;
        say(streaming_ ? Message()
            : opened   ? message("%1: is not the device that it was", name_)
                       : Error{message("%1 %2", name_, opened.error().where), opened.error().what, opened.error().why}
                           .asMessage());
      } catch (...) {
        streaming_ = false;
      }
      if (streaming_) {
        stamper_.anew();
        return true;
      }
      driver_->close();
    }
    std::this_thread::sleep_for(kNap);
  }
  return false;
}

// The largest whole number of 24 bits, or of fewer that are in use, is the converter's limit. The least one is, but
// where a device may rest there: one that knows its range may begin it at zero.
void PcmSource::unpack(SampleBlock& block, int frames) const noexcept {
  const auto bytes = static_cast<std::size_t>(format_.sampleBytes);
  const std::size_t stride = bytes * static_cast<std::size_t>(format_.channels);
  const int unused = 32 - format_.bits;  // to the top, where the sign is
  constexpr auto kLeast = std::numeric_limits<std::int32_t>::min();
  const int below = std::max(8, unused);
  const auto most = static_cast<std::int32_t>(0x7FFFFFFFU >> below << below);
  const bool least = format_.siOfFullScale.empty();
  for (std::size_t c = 0; c < inputs_.size(); ++c) {
    float* out = &block.channel(static_cast<int>(c)).data()[block.frames];
    const unsigned char* at = raw_.data() + static_cast<std::size_t>(inputs_[c]) * bytes;
    for (int f = 0; f < frames; ++f, at += stride) {
      const auto top = static_cast<std::int32_t>(static_cast<std::uint32_t>(whole(at, format_.sampleBytes)) << unused);
      if (top >= most || (least && top == kLeast)) block.flags |= kBlockClipped;
      out[f] = static_cast<float>(static_cast<double>(top) / 2147483648.0);
    }
  }
}

bool PcmSource::read(SampleBlock& block) noexcept {
  stamper_.begin(block);
  Instant taken{};
  Instant heard = clock_.now();
  while (!stopped_.load(std::memory_order_relaxed)) {
    int got = driver_->read(raw_.data(), blockFrames_ - block.frames, taken);
    if (got == 0 && clock_.now() - heard > kSilence) got = kPcmGone;
    if (got > 0) {
      heard = clock_.now();
      unpack(block, got);
      block.frames += got;
      if (block.frames < blockFrames_) continue;
      stamper_.finish(block, taken);
      return true;
    }
    if (got == 0) continue;
    // What came before the fault is whole and comes out first; the next block begins after the gap.
    const bool part = block.frames > 0;
    if (part) stamper_.finish(block, taken);
    stamper_.anew();
    if ((got != kPcmOverrun || !driver_->recover()) && !reopen()) return part;
    heard = clock_.now();
    if (part) return true;
  }
  return false;
}

}  // namespace stillcut::daq
