#include "core/daq/stream_source.h"

#include <algorithm>
#include <utility>

namespace stillcut::daq {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(500);
constexpr Duration kSilence = std::chrono::seconds(2);  // a device that streams is never silent for so long
constexpr Duration kOpenTime = std::chrono::seconds(3);
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
  stamper_.prepare(format_.rate, format_.blockFrames, decoder_->countsLosses());
}

Result<SourceFormat> StreamSource::open() {
  const Instant began = clock_.now();
  bool linked = false;
  std::uint64_t lost = 0;
  nextTry_ = began;
  while (true) {
    listen();
    linked = linked || linked_;
    if (decoder_->take(values_, lost)) break;
    if (stopped_.load(std::memory_order_relaxed) || clock_.now() - began > kOpenTime) {
      const std::string wire = name_ + " at " + std::string(wire_->address());
      wire_->close();
      if (!linked) return Error{wire, "cannot be opened", "is it there, and free?"};
      if (bytes_ == 0) return Error{wire, "nothing is sent", "does the device stream?"};
      return Error{wire,
                   std::to_string(bytes_) + " bytes came and no sample of " + std::to_string(format_.channels.size()) +
                       " channels is in them",
                   "are format, sync, sample, checksum, baud and the number of channels those of the sender?"};
    }
  }
  wire_->close();  // taken up again by the thread that reads from now on
  linked_ = false;
  nextTry_ = clock_.now();
  decoder_->reset();
  chunkBegin_ = chunkEnd_ = 0;
  return format_;
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
  }
  chunkBegin_ += decoder_->feed({chunk_.data() + chunkBegin_, chunkEnd_ - chunkBegin_});
}

void StreamSource::mind() noexcept {
  const Instant now = clock_.now();
  if (linked_ && now - heard_ > kSilence) wire_->close();
  WireState state = wire_->state();
  if (state == WireState::Closed) {
    if (linked_) {
      linked_ = false;
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
    heard_ = now;
  }
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
      if (anew_ || pendingLost_ == StreamDecoder::kUnknown) {
        stamper_.anew();
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
