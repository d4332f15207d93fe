// ArrayReader: samples in memory as a recording, for what looks at a whole recording first (evaluate::surveyChannels).
// Thread: one at a time. Refers to samples that outlive it.
#pragma once

#include <span>

#include "core/formats/recording_reader.h"

namespace stillcut::app {

class ArrayReader final : public record::RecordingReader {
 public:
  // Shape: samples[frame * channels + channel].
  ArrayReader(std::span<const float> samples, const std::vector<ChannelInfo>& channels, Hertz rate);
  const record::RecordingFormat& format() const override { return format_; }
  Result<bool> read(SampleBlock& block) override;

 private:
  std::span<const float> samples_;
  record::RecordingFormat format_;
  std::size_t next_ = 0;  // frame
};

}  // namespace stillcut::app
