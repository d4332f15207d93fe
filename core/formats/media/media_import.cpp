#include "core/formats/media/media_import.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/formats/media/media_track.h"

namespace stillcut::record {
namespace {

constexpr int kMostChannels = 64;
constexpr double kSpare_s = 0.25;  // by which a container and its sound may differ

class MediaReader final : public RecordingReader {
 public:
  MediaReader(std::string path, std::unique_ptr<MediaTrack> track, std::vector<int> picked, RecordingFormat format)
      : path_(std::move(path)), track_(std::move(track)), picked_(std::move(picked)), format_(std::move(format)) {}

  const RecordingFormat& format() const override { return format_; }

  Result<bool> read(SampleBlock& block) override {
    const std::int64_t left = format_.frames - framesRead_;
    if (left <= 0) return false;
    const auto wanted = static_cast<int>(std::min<std::int64_t>(left, block.capacityFrames));
    block.frames = 0;
    while (block.frames < wanted) {
      if (at_ == held_) {
        const Result<bool> more = track_->next();
        if (!more) return more.error();
        if (!*more) return Error{path_, message("ends early"), message("it has changed since it was opened")};
        held_ = track_->frames();
        at_ = 0;
        continue;
      }
      if (const Status s = takeFrame(block); !s) return s.error();
    }
    block.sequence = sequence_++;
    block.rate = format_.rate;
    block.firstSample = Instant(toDuration(Seconds(static_cast<double>(framesRead_) / format_.rate.value)));
    block.lostFrames = 0;
    framesRead_ += block.frames;
    block.flags = framesRead_ >= format_.frames ? static_cast<std::uint32_t>(kBlockEnd) : 0U;
    return true;
  }

 private:
  Status takeFrame(SampleBlock& block) {
    for (std::size_t c = 0; c < picked_.size(); ++c) {
      const float value = track_->sample(picked_[c], at_);
      if (!std::isfinite(value)) return Error{path_, message("holds a sample that is not a finite number")};
      block.samples[c * static_cast<std::size_t>(block.capacityFrames) + static_cast<std::size_t>(block.frames)] =
          value;
    }
    ++block.frames;
    ++at_;
    return Done{};
  }

  std::string path_;
  std::unique_ptr<MediaTrack> track_;
  std::vector<int> picked_;
  RecordingFormat format_;
  int at_ = 0;    // in the piece at hand
  int held_ = 0;  // frames of it
  std::int64_t framesRead_ = 0;
  std::uint64_t sequence_ = 0;
};

std::string inSeconds(double seconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", seconds);
  return text.data();
}

// Length, rate and kind, by decoding all of it.
Result<RecordingFormat> measure(const std::string& path, int& channels) {
  Result<std::unique_ptr<MediaTrack>> track = MediaTrack::open(path);
  if (!track) return track.error();
  RecordingFormat format;
  while (true) {
    const Result<bool> more = (*track)->next();
    if (!more) return more.error();
    if (!*more) break;
    format.frames += (*track)->frames();
  }
  channels = (*track)->channels();
  format.kind = (*track)->kind();
  format.rate = Hertz((*track)->rate());
  if (format.frames <= 0 || channels < 1 || channels > kMostChannels || (*track)->rate() <= 0)
    return Error{path, message("no sample of its sound track can be decoded"), message("a damaged file")};
  if ((*track)->damaged()) {
    format.notes.push_back(
        message("is damaged %1 s from its beginning: what is before is read", inSeconds(format.length().value)));
  } else if ((*track)->promised() > format.length().value + kSpare_s) {
    format.notes.push_back(message("ends after %1 of %2 s: what is there is read", inSeconds(format.length().value),
                                   inSeconds((*track)->promised())));
  }
  if ((*track)->tracks() > 1)
    format.notes.push_back(message("holds %1 sound tracks, of which one is read", (*track)->tracks()));
  return format;
}

}  // namespace

Result<std::unique_ptr<RecordingReader>> openMedia(const std::string& path, const ReadOptions& options) {
  int channels = 0;
  Result<RecordingFormat> format = measure(path, channels);
  if (!format) return format.error();
  std::vector<RecordedChannel> all;
  std::vector<int> picked = options.channels;
  for (int c = 0; c < channels; ++c) {
    RecordedChannel channel;
    channel.info.name = "channel " + std::to_string(c);
    channel.info.quantity = SensorQuantity::Sound;
    channel.unit = "full scale";
    all.push_back(channel);
    if (options.channels.empty()) picked.push_back(c);
  }
  Result<std::vector<RecordedChannel>> kept = keepChannels(all, options.channels, path);
  if (!kept) return kept.error();
  format->channels = std::move(*kept);
  if (const Status s = applyOptions(format->channels, options); !s) return s.error();
  Result<std::unique_ptr<MediaTrack>> track = MediaTrack::open(path);
  if (!track) return track.error();
  return std::unique_ptr<RecordingReader>(
      new MediaReader(path, std::move(*track), std::move(picked), std::move(*format)));
}

}  // namespace stillcut::record
