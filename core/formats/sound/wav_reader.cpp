#include <sndfile.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "core/formats/channel_notes.h"
#include "core/formats/sound/wav_reader.h"

namespace stillcut::record {
namespace {

struct CloseSound {
  void operator()(SNDFILE* file) const { sf_close(file); }
};
using SoundFile = std::unique_ptr<SNDFILE, CloseSound>;

constexpr int kMostChannels = 64;
constexpr int kFramesPerRead = 4096;

std::uint32_t littleEndian32(const unsigned char* bytes) {
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U |
         static_cast<std::uint32_t>(bytes[2]) << 16U | static_cast<std::uint32_t>(bytes[3]) << 24U;
}

// What is wrong with the sizes that the header gives; none: nothing. libsndfile reads what is there of a file whose
// recorder was killed, lost its power or wrote into a pipe, and says nothing. How much there should be stands in the
// data chunk, or, of RF64, in the ds64 chunk before it. 0xFFFFFFFF in plain RIFF means "streamed, unknown".
Result<std::optional<Message>> checkRiffSizes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<unsigned char, 12> head{};
  file.read(reinterpret_cast<char*>(head.data()), 12);
  const bool rf64 = std::memcmp(head.data(), "RF64", 4) == 0;
  const bool riff = rf64 || std::memcmp(head.data(), "RIFF", 4) == 0;
  if (!file || !riff || std::memcmp(head.data() + 8, "WAVE", 4) != 0) return std::optional<Message>();
  const std::uint64_t fileSize = std::filesystem::file_size(path);
  constexpr std::uint64_t kUnknown = 0xFFFFFFFFU;
  std::uint64_t dataSize = kUnknown;  // from ds64
  std::uint64_t at = 12;
  constexpr int kMostChunks = 1000;
  for (int i = 0; i < kMostChunks && at + 8 <= fileSize; ++i) {
    std::array<unsigned char, 24> chunk{};
    file.seekg(static_cast<std::streamoff>(at));
    file.read(reinterpret_cast<char*>(chunk.data()), chunk.size());
    if (file.gcount() < 8) break;
    file.clear();
    std::uint64_t size = littleEndian32(chunk.data() + 4);
    at += 8;
    if (rf64 && std::memcmp(chunk.data(), "ds64", 4) == 0) {
      dataSize = littleEndian32(chunk.data() + 16) | std::uint64_t{littleEndian32(chunk.data() + 20)} << 32U;
    }
    if (std::memcmp(chunk.data(), "data", 4) == 0) {
      if (size == kUnknown) size = dataSize;
      const std::uint64_t held = fileSize - std::min(at, fileSize);
      const bool unfinished = size == 0 && held > 0;
      if ((size == kUnknown || size <= held) && !unfinished) return std::optional<Message>();
      return std::optional<Message>(message(
          "the header promises %1 bytes of samples, the file holds %2, which are read: its recorder did not end it",
          std::to_string(size), std::to_string(held)));
    }
    at += size + (size & 1U);
  }
  return Error{path, message("holds no samples"), message("the data chunk is missing: a truncated file")};
}

class WavReader final : public RecordingReader {
 public:
  WavReader(std::string path, SoundFile file, int fileChannels, std::vector<int> picked, RecordingFormat format)
      : path_(std::move(path)),
        file_(std::move(file)),
        fileChannels_(fileChannels),
        picked_(std::move(picked)),
        format_(std::move(format)),
        interleaved_(static_cast<std::size_t>(kFramesPerRead) * static_cast<std::size_t>(fileChannels)) {}

  const RecordingFormat& format() const override { return format_; }

  Result<bool> read(SampleBlock& block) override {
    const std::int64_t left = format_.frames - framesRead_;
    if (left <= 0) return false;
    const auto wanted = static_cast<int>(std::min<std::int64_t>(left, block.capacityFrames));
    block.frames = 0;
    while (block.frames < wanted) {
      const int ask = std::min(wanted - block.frames, kFramesPerRead);
      const auto got = static_cast<int>(sf_readf_float(file_.get(), interleaved_.data(), ask));
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
        return Error{path_, message("frame %1 of channel %2 is not a finite number",
                                    std::to_string(framesRead_ + block.frames), std::to_string(picked_[c]))};
      }
      block.samples[c * static_cast<std::size_t>(block.capacityFrames) + static_cast<std::size_t>(block.frames)] =
          value;
    }
    ++block.frames;
    return Done{};
  }

  std::string path_;
  SoundFile file_;
  int fileChannels_;
  std::vector<int> picked_;
  RecordingFormat format_;
  std::vector<float> interleaved_;
  std::int64_t framesRead_ = 0;
  std::uint64_t sequence_ = 0;
};

}  // namespace

Result<std::unique_ptr<RecordingReader>> openWav(const std::string& path, const ReadOptions& options) {
  const Result<std::optional<Message>> sizes = checkRiffSizes(path);
  if (!sizes) return sizes.error();
  SF_INFO info{};
  SoundFile file(sf_open(path.c_str(), SFM_READ, &info));
  if (!file) return Error{path, message("is no sound file that can be read"), foreign(sf_strerror(nullptr))};
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
  format.frames = info.frames;
  if (*sizes) format.notes.push_back(**sizes);
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
  if (const char* comment = sf_get_string(file.get(), SF_STR_COMMENT)) applyChannelNotes(comment, all, format.rate);
  Result<std::vector<RecordedChannel>> kept = keepChannels(all, options.channels, path);
  if (!kept) return kept.error();
  format.channels = std::move(*kept);
  if (const Status s = applyOptions(format.channels, options); !s) return s.error();
  return std::unique_ptr<RecordingReader>(
      new WavReader(path, std::move(file), info.channels, std::move(picked), std::move(format)));
}

}  // namespace stillcut::record
