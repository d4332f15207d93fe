#include "app/embed/array_reader.h"

#include <algorithm>

namespace stillcut::app {

ArrayReader::ArrayReader(std::span<const float> samples, const std::vector<ChannelInfo>& channels, Hertz rate)
    : samples_(samples) {
  format_.kind = "samples in memory";
  format_.rate = rate;
  format_.frames = static_cast<std::int64_t>(samples.size() / std::max<std::size_t>(1, channels.size()));
  for (const ChannelInfo& info : channels) format_.channels.push_back({info, {}, true});
}

Result<bool> ArrayReader::read(SampleBlock& block) {
  const std::size_t channels = format_.channels.size();
  const auto left = static_cast<std::size_t>(format_.frames) - next_;
  block.rate = format_.rate;
  block.firstSample = Instant(toDuration(Seconds(static_cast<double>(next_) / format_.rate.value)));
  block.frames = static_cast<int>(std::min(left, static_cast<std::size_t>(block.capacityFrames)));
  if (block.frames == 0) return false;
  for (std::size_t c = 0; c < channels; ++c) {
    const std::span<float> to = block.channel(static_cast<int>(c));
    for (std::size_t f = 0; f < to.size(); ++f) to[f] = samples_[(next_ + f) * channels + c];
  }
  next_ += static_cast<std::size_t>(block.frames);
  return true;
}

}  // namespace stillcut::app
