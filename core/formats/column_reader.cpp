#include "core/formats/column_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/units/unit_names.h"

namespace stillcut::record {
namespace {

constexpr std::size_t kMostChannels = 64;

class ColumnReader final : public RecordingReader {
 public:
  ColumnReader(std::string path, RecordingFormat format, std::vector<std::unique_ptr<Column>> columns)
      : path_(std::move(path)), format_(std::move(format)), columns_(std::move(columns)) {}

  const RecordingFormat& format() const override { return format_; }

  // Frames that hold no number are missing: that is how a gap is written where there are no times.
  Result<bool> read(SampleBlock& block) override {
    std::uint64_t lost = 0;
    while (true) {
      if (taken_ == held_) {
        const std::int64_t left = format_.frames - framesRead_;
        if (left <= 0) return ended();
        if (const Status s = fetch(std::min<std::int64_t>(left, block.capacityFrames)); !s) return s.error();
      }
      if (!isGap(taken_)) break;
      ++taken_;
      ++framesRead_;
      ++lost;
    }
    std::size_t end = taken_ + 1;
    while (end < held_ && end - taken_ < static_cast<std::size_t>(block.capacityFrames) && isWhole(end)) ++end;
    block.frames = static_cast<int>(end - taken_);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      if (const Status s = take(block, static_cast<int>(c)); !s) return s.error();
    }
    block.sequence = sequence_++;
    block.rate = format_.rate;
    block.firstSample = Instant(toDuration(Seconds(static_cast<double>(framesRead_) / format_.rate.value)));
    block.lostFrames = lost;
    block.flags = lost > 0 ? static_cast<std::uint32_t>(kBlockGap) : 0U;
    framesRead_ += block.frames;
    taken_ = end;
    if (framesRead_ >= format_.frames) block.flags |= kBlockEnd;
    any_ = true;
    return true;
  }

 private:
  Result<bool> ended() const {
    if (!any_) return Error{path_, message("none of its samples is a number")};
    return false;
  }
  Status fetch(std::int64_t frames) {
    held_ = static_cast<std::size_t>(frames);
    taken_ = 0;
    values_.resize(columns_.size());
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      values_[c].resize(held_);
      if (const Status s = columns_[c]->read(values_[c]); !s) return s.error();
    }
    return Done{};
  }
  bool missing(std::size_t frame) const {
    return std::all_of(values_.begin(), values_.end(),
                       [frame](const std::vector<double>& v) { return std::isnan(v[frame]); });
  }
  // A frame that lacks one channel's number is missing as a whole, as long as they are few.
  bool isGap(std::size_t frame) {
    if (missing(frame)) return true;
    const bool some = std::any_of(values_.begin(), values_.end(),
                                  [frame](const std::vector<double>& v) { return std::isnan(v[frame]); });
    constexpr std::int64_t kOneIn = 10;
    if (!some || (torn_ + 1) * kOneIn > format_.frames) return false;
    ++torn_;
    return true;
  }
  bool isWhole(std::size_t frame) const {
    return std::none_of(values_.begin(), values_.end(),
                        [frame](const std::vector<double>& v) { return std::isnan(v[frame]); });
  }
  Status take(SampleBlock& block, int channel) const {
    constexpr double kLargest = std::numeric_limits<float>::max();
    const std::vector<double>& values = values_[static_cast<std::size_t>(channel)];
    const std::span<float> to = block.channel(channel);
    for (std::size_t f = 0; f < to.size(); ++f) {
      const double value = values[taken_ + f];
      if (!(std::abs(value) <= kLargest)) {
        const std::string what = "sample " + std::to_string(framesRead_ + static_cast<std::int64_t>(f)) + " of '" +
                                 format_.channels[static_cast<std::size_t>(channel)].info.name + "'";
        if (std::isfinite(value)) return Error{path_, message("%1 is too large for a sample", what)};
        return Error{path_, message("%1 is not a finite number", what),
                     message("write NaN on every channel where samples are missing, or leave this one out")};
      }
      to[f] = static_cast<float>(value);
    }
    return Done{};
  }

  std::string path_;
  RecordingFormat format_;
  std::vector<std::unique_ptr<Column>> columns_;
  std::vector<std::vector<double>> values_;  // [channel], of the frames held
  std::size_t held_ = 0;                     // frames
  std::size_t taken_ = 0;                    // of them
  std::int64_t torn_ = 0;                    // frames that some channels have, and some have not
  std::int64_t framesRead_ = 0;              // missing ones included
  bool any_ = false;
  std::uint64_t sequence_ = 0;
};

bool isSpeed(const ColumnChannel& c) {
  return c.channel.info.quantity == SensorQuantity::SpindleSpeed;
}

void leaveSpeedOut(std::vector<ColumnChannel>& all, RecordingFormat& format, const ReadOptions& options) {
  const bool only = std::all_of(all.begin(), all.end(), isSpeed);
  const bool asked = options.quantity == SensorQuantity::SpindleSpeed && std::any_of(all.begin(), all.end(), isSpeed);
  if (only) return;
  std::vector<ColumnChannel> kept;
  for (ColumnChannel& c : all) {
    if (isSpeed(c) == asked) {
      kept.push_back(std::move(c));
    } else {
      leaveOut(format, c.channel.info.name, message("it is a speed of the spindle"));
    }
  }
  all = std::move(kept);
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openColumns(const std::string& path, RecordingFormat format,
                                                     std::vector<ColumnChannel> all, const ReadOptions& options) {
  leaveSpeedOut(all, format, options);
  if (all.empty() || format.frames <= 0) return Error{path, message("holds no samples")};
  if (!(format.rate.value > 0.0) || !std::isfinite(format.rate.value)) {
    return Error{path, message("the sampling rate is senseless"), message("give it with --rate HZ")};
  }
  std::vector<RecordedChannel> channels;
  channels.reserve(all.size());
  for (const ColumnChannel& c : all) channels.push_back(c.channel);
  Result<std::vector<RecordedChannel>> kept = keepChannels(channels, options.channels, path);
  if (!kept) return kept.error();
  if (kept->size() > kMostChannels)
    return Error{path, message("has more than 64 channels"), message("choose some with --channel N[,N]")};
  format.channels = std::move(*kept);
  if (const Status s = applyOptions(format.channels, options); !s) return s.error();
  std::vector<std::unique_ptr<Column>> columns;
  for (std::size_t c = 0; c < format.channels.size(); ++c) {
    const std::size_t index = options.channels.empty() ? c : static_cast<std::size_t>(options.channels[c]);
    Result<std::unique_ptr<Column>> column = all[index].open();
    if (!column) return column.error();
    columns.push_back(std::move(*column));
  }
  return std::unique_ptr<RecordingReader>(new ColumnReader(path, std::move(format), std::move(columns)));
}

RecordedChannel channelFromWords(const std::string& name, const std::string& unit) {
  RecordedChannel channel;
  channel.unit = unit;
  channel.info.name = name;
  channel.info.axis = axisOfName(name);
  if (const std::optional<UnitMeaning> meaning = unitFromText(unit); meaning && meaning->quantity) {
    channel.info.quantity = *meaning->quantity;
    channel.info.scale = meaning->toSi;
    channel.quantityKnown = true;
    return channel;
  }
  const NameMeaning meaning = meaningOfName(name);
  if (meaning == NameMeaning::Sound) channel.info.quantity = SensorQuantity::Sound;
  if (meaning == NameMeaning::Force) channel.info.quantity = SensorQuantity::Force;
  if (meaning == NameMeaning::SpindleSpeed) channel.info.quantity = SensorQuantity::SpindleSpeed;
  channel.quantityKnown = meaning != NameMeaning::Unknown;
  return channel;
}

double wholeRate(double rate, double relative) {
  const double whole = std::round(rate);
  return whole > 0.0 && std::abs(rate - whole) <= relative * rate ? whole : rate;
}

}  // namespace stillcut::record
