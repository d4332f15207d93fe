#include "tests/support/field_cases/memory_reader.h"

#include <algorithm>

namespace stillcut::field {

MemoryReader::MemoryReader(const Signal& signal) : signal_(signal) {
  format_.kind = "memory";
  format_.rate = Hertz(signal.rate);
  format_.frames = static_cast<std::int64_t>(signal.channels.front().size());
  for (std::size_t c = 0; c < signal.channels.size(); ++c) {
    record::RecordedChannel channel;
    channel.info.name = "channel " + std::to_string(c);
    channel.info.quantity = signal.quantity;
    format_.channels.push_back(channel);
  }
}

Result<bool> MemoryReader::read(SampleBlock& block) {
  if (read_ == format_.frames) return false;
  block.frames = static_cast<int>(std::min<std::int64_t>(block.capacityFrames, format_.frames - read_));
  block.sequence = sequence_++;
  block.rate = format_.rate;
  block.firstSample = Instant(toDuration(Seconds(static_cast<double>(read_) / signal_.rate)));
  block.lostFrames = 0;
  for (std::size_t c = 0; c < signal_.channels.size(); ++c) {
    const auto from = signal_.channels[c].begin() + static_cast<std::ptrdiff_t>(read_);
    std::copy_n(from, block.frames, block.channel(static_cast<int>(c)).begin());
  }
  read_ += block.frames;
  block.flags = read_ == format_.frames ? static_cast<std::uint32_t>(kBlockEnd) : 0U;
  return true;
}

}  // namespace stillcut::field
