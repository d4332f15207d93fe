#include "core/record/convert_recording.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/record/open_recording.h"
#include "core/record/wav_reader.h"

namespace stillcut::record {
namespace {

constexpr int kBlockFrames = 4096;

// A text file that is removed again unless it is finished.
class CsvFile {
 public:
  explicit CsvFile(std::string path) : path_(std::move(path)), part_(path_ + ".part") {
    file_ = std::fopen(part_.c_str(), "wb");
  }
  ~CsvFile() {
    if (file_ != nullptr) std::fclose(file_);
    std::remove(part_.c_str());
  }
  CsvFile(const CsvFile&) = delete;
  CsvFile& operator=(const CsvFile&) = delete;

  bool opened() const { return file_ != nullptr; }
  void header(const RecordingFormat& format) {
    std::fputs("Time (s)", file_);
    for (const RecordedChannel& channel : format.channels) {
      std::string name = channel.info.name;
      std::replace(name.begin(), name.end(), ',', ' ');
      // A number that nobody has calibrated gets no unit.
      const bool calibrated = channel.quantityKnown || channel.info.scale != 1.0;
      const std::string unit = calibrated ? " (" + std::string(siUnit(channel.info.quantity)) + ")" : "";
      std::fprintf(file_, ",%s%s", name.c_str(), unit.c_str());
    }
    std::fputc('\n', file_);
  }
  void block(const SampleBlock& block, const std::vector<double>& scale) {
    for (int f = 0; f < block.frames; ++f) {
      std::fprintf(file_, "%.9f", sinceEpoch(block.firstSample).value + f / block.rate.value);
      for (int c = 0; c < block.channels; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        std::fprintf(file_, ",%.9g", block.channel(c)[static_cast<std::size_t>(f)] * scale[channel]);
      }
      std::fputc('\n', file_);
    }
  }
  bool finish() {
    const bool written = std::ferror(file_) == 0;
    const bool closed = std::fclose(file_) == 0;
    file_ = nullptr;
    return written && closed && std::rename(part_.c_str(), path_.c_str()) == 0;
  }

 private:
  std::string path_;
  std::string part_;
  std::FILE* file_ = nullptr;
};

// Calls `take` for every block; its first error ends it.
template <class Take>
Status forEachBlock(RecordingReader& reader, Take take) {
  SampleBlock block;
  const int frames = std::max(kBlockFrames, reader.format().blockFrames);
  block.allocate(static_cast<int>(reader.format().channels.size()), frames);
  while (true) {
    const Result<bool> more = reader.read(block);
    if (!more) return more.error();
    if (!*more) return Done{};
    if (const Status s = take(block); !s) return s.error();
  }
}

Status writeGap(WavWriter& wav, const SampleBlock& after) {
  // A gap longer than this is no gap but a pause; a WAV of mostly zeros helps nobody.
  constexpr double kLongestGap = 60.0;
  const double seconds = static_cast<double>(after.lostFrames) / after.rate.value;
  if (seconds > kLongestGap) return Error{"", "a gap of " + std::to_string(seconds) + " s", "convert to CSV instead"};
  SampleBlock zeros;
  zeros.allocate(after.channels, kBlockFrames);
  for (std::uint64_t left = after.lostFrames; left > 0;) {
    zeros.frames = static_cast<int>(std::min<std::uint64_t>(left, kBlockFrames));
    if (const Status s = wav.write(zeros); !s) return s.error();
    left -= static_cast<std::uint64_t>(zeros.frames);
  }
  return Done{};
}

Status toWav(RecordingReader& reader, const std::string& to, const std::vector<double>& scale) {
  Result<std::unique_ptr<WavWriter>> wav = WavWriter::create(to, static_cast<int>(scale.size()), reader.format().rate);
  if (!wav) return wav.error();
  const Status copied = forEachBlock(reader, [&](const SampleBlock& block) -> Status {
    if (block.has(kBlockGap)) {
      if (const Status s = writeGap(**wav, block); !s) return Error{to, s.error().what, s.error().why};
    }
    return (*wav)->write(block, scale);
  });
  if (!copied) return copied.error();
  return (*wav)->finish();
}

Status toCsv(RecordingReader& reader, const std::string& to, const std::vector<double>& scale) {
  CsvFile csv(to);
  if (!csv.opened()) return Error{to, "cannot be written", ""};
  csv.header(reader.format());
  const Status copied = forEachBlock(reader, [&](const SampleBlock& block) -> Status {
    csv.block(block, scale);
    return Done{};
  });
  if (!copied) return copied.error();
  if (!csv.finish()) return Error{to, "cannot be written", ""};
  return Done{};
}

}  // namespace

Status convertRecording(const std::string& from, const std::string& to, const ReadOptions& options) {
  const std::filesystem::path suffix = std::filesystem::path(to).extension();
  if (suffix != ".wav" && suffix != ".csv") return Error{to, "cannot be written", "the suffix must be .wav or .csv"};
  const Result<std::unique_ptr<RecordingReader>> reader = openRecording(from, options);
  if (!reader) return reader.error();
  RecordingReader& source = *reader.value();
  std::vector<double> scale;
  for (const RecordedChannel& channel : source.format().channels) scale.push_back(channel.info.scale);
  return suffix == ".wav" ? toWav(source, to, scale) : toCsv(source, to, scale);
}

}  // namespace stillcut::record
