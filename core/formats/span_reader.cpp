#include "core/formats/span_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stillcut::record {
namespace {

constexpr double kFarthest = 9e15;  // [frames]

class SpanReader final : public RecordingReader {
 public:
  SpanReader(std::unique_ptr<RecordingReader> whole, std::int64_t from, std::int64_t to)
      : whole_(std::move(whole)), format_(whole_->format()), from_(from), to_(to) {
    const std::int64_t last = std::min(to_, format_.frames);
    format_.frames = std::max<std::int64_t>(0, last - from_);
  }

  const RecordingFormat& format() const override { return format_; }

  Result<bool> read(SampleBlock& block) override {
    while (true) {
      Result<bool> more = whole_->read(block);
      if (!more || !*more) return more;
      if (!first_) first_ = block.firstSample;
      const std::int64_t at = std::llround(secondsBetween(*first_, block.firstSample).value * format_.rate.value);
      if (at >= to_) return false;
      const std::int64_t begin = std::max<std::int64_t>(from_ - at, 0);
      const std::int64_t end = std::min<std::int64_t>(to_ - at, block.frames);
      if (begin >= end) continue;
      cut(block, static_cast<int>(begin), static_cast<int>(end));
      if (at + end >= to_) block.flags |= kBlockEnd;
      return true;
    }
  }

 private:
  void cut(SampleBlock& block, int begin, int end) {
    for (int c = 0; c < block.channels; ++c) {
      const std::span<float> samples = block.channel(c);
      std::copy(samples.begin() + begin, samples.begin() + end, samples.begin());
    }
    block.frames = end - begin;
    block.firstSample += toDuration(Seconds(begin / format_.rate.value));
    if (begin > 0 || !begun_) {  // what was missing before the span is not missing in it
      block.flags &= ~static_cast<std::uint32_t>(kBlockGap);
      block.lostFrames = 0;
    }
    begun_ = true;
  }

  std::unique_ptr<RecordingReader> whole_;
  RecordingFormat format_;
  std::int64_t from_;  // frames from the first sample, missing ones included
  std::int64_t to_;
  std::optional<Instant> first_;
  bool begun_ = false;
};

}  // namespace

Result<std::unique_ptr<RecordingReader>> openSpan(std::unique_ptr<RecordingReader> whole, const TimeSpan& span,
                                                  const std::string& where) {
  const double from = span.from.value_or(Seconds(0.0)).value;
  const double to = span.to.value_or(Seconds(std::numeric_limits<double>::infinity())).value;
  const std::string text = std::to_string(from) + " s to " + (span.to ? std::to_string(to) + " s" : "the end");
  if (!(from >= 0.0) || !(to > from)) return Error{where, message("the span from %1 is empty", text)};
  const double rate = whole->format().rate.value;
  const auto frame = [rate](double seconds) {
    return static_cast<std::int64_t>(std::llround(std::min(seconds * rate, kFarthest)));
  };
  return std::unique_ptr<RecordingReader>(new SpanReader(std::move(whole), frame(from), frame(to)));
}

}  // namespace stillcut::record
