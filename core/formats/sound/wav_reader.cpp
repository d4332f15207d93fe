#include <sndfile.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/formats/channel_notes.h"
#include "core/formats/sound/riff_header.h"
#include "core/formats/sound/sound_file.h"
#include "core/formats/sound/sound_length.h"
#include "core/formats/sound/wav_clock.h"
#include "core/formats/sound/wav_reader.h"
#include "core/formats/wall_clock.h"

namespace stillcut::record {
namespace {

constexpr int kMostChannels = 64;
constexpr int kFramesPerRead = 4096;

class WavReader final : public RecordingReader {
 public:
  WavReader(std::string path, std::unique_ptr<SoundFile> file, std::vector<int> picked, RecordingFormat format)
      : path_(std::move(path)),
        file_(std::move(file)),
        fileChannels_(file_->info().channels),
        picked_(std::move(picked)),
        format_(std::move(format)),
        interleaved_(static_cast<std::size_t>(kFramesPerRead) * static_cast<std::size_t>(fileChannels_)) {}

  const RecordingFormat& format() const override { return format_; }

  Result<bool> read(SampleBlock& block) override {
    const std::int64_t left = format_.frames - framesRead_;
    if (left <= 0) return false;
    const auto wanted = static_cast<int>(std::min<std::int64_t>(left, block.capacityFrames));
    block.frames = 0;
    while (block.frames < wanted) {
      const int ask = std::min(wanted - block.frames, kFramesPerRead);
      const auto got = static_cast<int>(sf_readf_float(file_->handle(), interleaved_.data(), ask));
      if (got <= 0) {
        return Error{path_,
                     message("ends after %1 of %2 frames", std::to_string(framesRead_ + block.frames),
                             std::to_string(format_.frames)),
                     message("a truncated or damaged file")};
      }
      for (int f = 0; f < got; ++f) {
        if (const Status s = takeFrame(block, f); !s) return s.error();
      }
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
  Status takeFrame(SampleBlock& block, int frame) {
    const float* from = interleaved_.data() + static_cast<std::ptrdiff_t>(frame) * fileChannels_;
    for (std::size_t c = 0; c < picked_.size(); ++c) {
      const float value = from[picked_[c]];
      if (!std::isfinite(value)) {
        return Error{path_,
                     message("frame %1 of channel %2 is not a finite number",
                             std::to_string(framesRead_ + block.frames), std::to_string(picked_[c])),
                     message("write 0 in its place, or read the other channels with --channel N")};
      }
      block.samples[c * static_cast<std::size_t>(block.capacityFrames) + static_cast<std::size_t>(block.frames)] =
          value;
    }
    ++block.frames;
    return Done{};
  }

  std::string path_;
  std::unique_ptr<SoundFile> file_;
  int fileChannels_;
  std::vector<int> picked_;
  RecordingFormat format_;
  std::vector<float> interleaved_;
  std::int64_t framesRead_ = 0;
  std::uint64_t sequence_ = 0;
};

// libsndfile's own words name its functions and guess at pipes.
Message whyNot(int error) {
  switch (error) {
    case SF_ERR_UNRECOGNISED_FORMAT:
      return message("nothing in it is known as sound");
    case SF_ERR_UNSUPPORTED_ENCODING:
      return message("its coding is not known; convert it to WAV: ffmpeg -i FILE cut.wav");
    default:
      return message("its header is damaged, or its coding is not known");
  }
}

}  // namespace

bool isRareSound(const std::string& path) {
  SF_INFO info{};
  SNDFILE* file = sf_open(path.c_str(), SFM_READ, &info);
  if (file == nullptr) return false;
  sf_close(file);
  const int major = info.format & SF_FORMAT_TYPEMASK;
  // Of two bytes and of a length that fits: too little to know random bytes by.
  if (major == SF_FORMAT_MPC2K || major == SF_FORMAT_RAW) return false;
  constexpr int kSlowest = 1000, kFastest = 10'000'000;  // [Hz]
  return info.frames > 0 && info.channels >= 1 && info.channels <= kMostChannels && info.samplerate >= kSlowest &&
         info.samplerate <= kFastest;
}

Result<std::unique_ptr<RecordingReader>> openWav(const std::string& path, const ReadOptions& options) {
  const Result<std::optional<RiffHeader>> header = readRiffHeader(path);
  if (!header) return header.error();
  auto file = std::make_unique<SoundFile>(path, *header ? &**header : nullptr);
  const SF_INFO& info = file->info();
  if (file->handle() == nullptr)
    return Error{path, message("is no sound file that can be read"), whyNot(sf_error(nullptr))};
  if (info.frames <= 0) return Error{path, message("holds no samples")};
  if (info.channels < 1 || info.channels > kMostChannels || info.samplerate <= 0) {
    return Error{path,
                 message("has %1 channels at %2 Hz", std::to_string(info.channels), std::to_string(info.samplerate)),
                 message("1 to 64 channels and a rate above zero were expected")};
  }
  RecordingFormat format;
  format.kind = "sound file";
  SF_FORMAT_INFO major{};
  major.format = info.format & SF_FORMAT_TYPEMASK;
  if (sf_command(nullptr, SFC_GET_FORMAT_INFO, &major, sizeof major) == 0) format.kind = major.name;
  format.rate = Hertz(info.samplerate);
  const SoundLength length = lengthOf(path, *file, *header ? &**header : nullptr);
  if (length.frames <= 0) return Error{path, message("no sample of it can be decoded"), message("a damaged file")};
  format.frames = length.frames;
  if (length.note) format.notes.push_back(*length.note);
  if (*header) {
    if (const std::optional<Message> note = noteOfSizes(**header)) format.notes.push_back(*note);
    format.started_ns = wavStarted(path, **header).value_or(0);
  } else if (const char* date = sf_get_string(file->handle(), SF_STR_DATE)) {
    format.started_ns = wallTime(date).value_or(0);
  }
  std::vector<RecordedChannel> all;
  std::vector<int> picked = options.channels;
  for (int c = 0; c < info.channels; ++c) {
    RecordedChannel channel;
    channel.info.name = "channel " + std::to_string(c);
    channel.info.quantity = SensorQuantity::Sound;
    channel.unit = "full scale";
    all.push_back(channel);
    if (options.channels.empty()) picked.push_back(c);
  }
  if (const char* comment = sf_get_string(file->handle(), SF_STR_COMMENT)) applyChannelNotes(comment, all, format.rate);
  Result<std::vector<RecordedChannel>> kept = keepChannels(all, options.channels, path);
  if (!kept) return kept.error();
  format.channels = std::move(*kept);
  if (const Status s = applyOptions(format.channels, options); !s) return s.error();
  return std::unique_ptr<RecordingReader>(new WavReader(path, std::move(file), std::move(picked), std::move(format)));
}

}  // namespace stillcut::record
