// StreamSource: samples that come as bytes over a wire, a serial line or a socket, at a nominal rate. When the
// wire breaks it is taken up again every half second until stop(), and what was missed is flagged as a gap. Thread: as
// DaqSource says.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "core/base/byte_channel.h"
#include "core/base/time.h"
#include "core/daq/block_stamper.h"
#include "core/daq/daq_source.h"
#include "core/daq/stream_decoder.h"

namespace stillcut::daq {

class StreamSource final : public DaqSource {
 public:
  // `name` begins every error line: "source 'serial'". The clock outlives the source.
  StreamSource(std::string name, SourceFormat format, std::unique_ptr<ByteChannel> wire,
               std::unique_ptr<StreamDecoder> decoder, const Clock& clock);

  // Waits up to three seconds for the wire, six for its first byte (many boards start anew when a port is opened) and
  // three from there for the first sample, so that a wrong address, rate or frame shows at once. The wire stays open.
  Result<SourceFormat> open() override;
  bool read(SampleBlock& block) noexcept override;
  void stop() noexcept override { stopped_.store(true, std::memory_order_relaxed); }
  Message fault() const override { return {}; }
  Message trouble() const override;
  bool live() const override { return true; }

 private:
  bool collect(SampleBlock& block) noexcept;
  void drain() noexcept;
  void listen() noexcept;
  void mind() noexcept;

  std::string name_;
  SourceFormat format_;
  std::unique_ptr<ByteChannel> wire_;
  std::unique_ptr<StreamDecoder> decoder_;
  const Clock& clock_;
  BlockStamper stamper_;
  std::atomic<bool> stopped_{false};
  std::array<char, 4096> chunk_{};
  std::size_t chunkBegin_ = 0, chunkEnd_ = 0;
  std::vector<float> values_;  // of an instant that begins the next block
  bool pending_ = false;
  std::uint64_t pendingLost_ = 0;
  bool anew_ = false;  // the wire was cut: the next block begins after a gap
  Instant heard_{};    // the last byte
  Instant nextTry_{};
  bool linked_ = false;
  std::atomic<bool> away_{false};  // the wire was cut and is not back
  bool spoken_ = false;            // a byte has come since it was linked
  bool drained_ = false;           // what had come before the first read() is gone
  std::uint64_t bytes_ = 0;
};

}  // namespace stillcut::daq
