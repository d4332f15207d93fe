// PcmSource: samples of an audio-class device (measurement microphones, USB accelerometers, IEPE conditioners)
// and IIO accelerometers. A sample is a part of full scale, -1 to 1; a channel's scale says how many SI units full
// scale is, times what the device itself knows of it. 24 bits come through bit by bit. After an overrun it goes on; a
// device that was unplugged is opened again every half second. Thread: as DaqSource says.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/daq/block_stamper.h"
#include "core/daq/daq_source.h"
#include "core/daq/pcm_driver.h"

namespace stillcut::daq {

class PcmSource final : public DaqSource {
 public:
  // inputs[c]: the device's channel, from 0, that is channel c of `channels`.
  PcmSource(std::string name, PcmRequest request, std::vector<ChannelInfo> channels, std::vector<int> inputs,
            std::unique_ptr<PcmDriver> driver, const Clock& clock);

  Result<SourceFormat> open() override;
  bool read(SampleBlock& block) noexcept override;
  void stop() noexcept override { stopped_.store(true, std::memory_order_relaxed); }
  Message fault() const override { return fault_; }
  Message trouble() const override;
  bool live() const override { return true; }

 private:
  bool reopen() noexcept;
  void say(const Message& trouble);
  void unpack(SampleBlock& block, int frames) const noexcept;

  std::string name_;
  PcmRequest request_;
  std::vector<ChannelInfo> channels_;
  std::vector<int> inputs_;
  std::unique_ptr<PcmDriver> driver_;
  const Clock& clock_;
  PcmFormat format_;
  int blockFrames_ = 0;
  BlockStamper stamper_;
  std::vector<unsigned char> raw_;
  bool streaming_ = false;
  Instant nextOpen_{};  // not before: a device that opens and delivers nothing is not asked in a tight loop
  Message fault_;
  mutable std::mutex saying_;  // while the device is away
  Message trouble_;
  std::atomic<bool> stopped_{false};
};

}  // namespace stillcut::daq
