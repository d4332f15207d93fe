#include "core/daq/stream_source.h"

#include <algorithm>
#include <utility>

#include "core/daq/device_messages.h"

namespace stillcut::daq {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
constexpr Duration kSilence = std::chrono::seconds(2);   // a device that streams is never silent for so long
constexpr Duration kBoot = std::chrono::seconds(6);      // silence of a device that is starting
constexpr Duration kOpenTime = std::chrono::seconds(3);  // of a wire, and from its first byte to the first sample
constexpr Duration kWait = std::chrono::milliseconds(20);

}  // namespace

StreamSource::StreamSource(std::string name, SourceFormat format, std::unique_ptr<ByteChannel> wire,
                           std::unique_ptr<StreamDecoder> decoder, const Clock& clock)
    : name_(std::move(name)),
      format_(std::move(format)),
      wire_(std::move(wire)),
      decoder_(std::move(decoder)),
      clock_(clock),
      values_(format_.channels.size()) {
  if (!decoder_->countsLosses() && decoder_->lossUnit() == 1) format_.doubt = uncounted();
  stamper_.prepare(format_.rate, format_.blockFrames, decoder_->countsLosses(), decoder_->lossUnit());
}

Result<SourceFormat> StreamSource::open() {
  Instant since = clock_.now();
  bool linked = false;
  bool spoken = false;
  std::uint64_t lost = 0;
  nextTry_ = since;
  while (true) {
    listen();
    if (linked_ && (!linked || (spoken_ && !spoken))) since = clock_.now();
    linked = linked || linked_;
    spoken = spoken || spoken_;
    if (decoder_->take(values_, lost)) break;
    if (stopped_.load(std::memory_order_relaxed) || clock_.now() - since > (linked && !spoken ? kBoot : kOpenTime)) {
      const std::string wire = name_ + " at " + std::string(wire_->address());
      wire_->close();
      if (!linked) return Error{wire, notOpened(), isItFree()};
      if (bytes_ == 0) return Error{wire, nothingSent(), doesItStream()};
      return Error{wire, noSampleInIt(), sameFrames()};
    }
  }
  wire_->handOver();
  return format_;
}

// What has come between open() and the first read() is old, and how old is not known.
void StreamSource::drain() noexcept {
  while (wire_->read(chunk_) == chunk_.size() && !stopped_.load(std::memory_order_relaxed)) {
  }
  decoder_->reset();
  chunkBegin_ = chunkEnd_ = 0;
  heard_ = clock_.now();
}

// Bytes to the decoder, and the wire taken up where it is down. Waits a little when there are none.
void StreamSource::listen() noexcept {
  mind();
  if (chunkBegin_ == chunkEnd_) {
    chunkBegin_ = 0;
    chunkEnd_ = wire_->read(chunk_);
    bytes_ += chunkEnd_;
    if (chunkEnd_ == 0) {
      wire_->wait(kWait);
      return;
    }
    heard_ = clock_.now();
    spoken_ = true;
  }
  chunkBegin_ += decoder_->feed({chunk_.data() + chunkBegin_, chunkEnd_ - chunkBegin_});
}

void StreamSource::mind() noexcept {
  const Instant now = clock_.now();
  if (linked_ && now - heard_ > (spoken_ ? kSilence : kBoot)) wire_->close();
  WireState state = wire_->state();
  if (state == WireState::Closed) {
    if (linked_) {
      linked_ = false;
      away_.store(true, std::memory_order_relaxed);
      anew_ = true;
      decoder_->reset();
      chunkBegin_ = chunkEnd_ = 0;
      nextTry_ = now + kRetry;
    }
    if (now < nextTry_) return;
    nextTry_ = now + kRetry;
    wire_->connect();
    state = wire_->state();
  }
  if (state == WireState::Open && !linked_) {
    linked_ = true;
    away_.store(false, std::memory_order_relaxed);
    spoken_ = false;
    heard_ = now;
  }
}

Message StreamSource::trouble() const {
  if (!away_.load(std::memory_order_relaxed)) return {};
  return message("%1 at %2: nothing comes any more, the wire is taken up again", name_, wire_->address());
}

// True: the block is complete, or has to end because samples are missing after it.
bool StreamSource::collect(SampleBlock& block) noexcept {
  while (block.frames < format_.blockFrames) {
    if (!pending_) {
      std::uint64_t lost = 0;
      if (!decoder_->take(values_, lost)) return anew_ && block.frames > 0;
      pendingLost_ = lost;
      pending_ = true;
    }
    if (pendingLost_ > 0 || anew_) {
      if (block.frames > 0) return true;
      if (anew_) {
        stamper_.anew();
      } else if (pendingLost_ == StreamDecoder::kUnknown) {
        stamper_.doubt();
      } else {
        block.lostFrames = pendingLost_;
      }
      anew_ = false;
      pendingLost_ = 0;
    }
    for (std::size_t c = 0; c < values_.size(); ++c) {
      block.channel(static_cast<int>(c)).data()[block.frames] = values_[c];
    }
    pending_ = false;
    ++block.frames;
  }
  return true;
}

bool StreamSource::read(SampleBlock& block) noexcept {
  if (!std::exchange(drained_, true)) drain();
  stamper_.begin(block);
  while (!stopped_.load(std::memory_order_relaxed)) {
    if (collect(block)) {
      stamper_.finish(block, clock_.now());
      return true;
    }
    listen();
  }
  return false;
}

}  // namespace stillcut::daq
