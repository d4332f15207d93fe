#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/formats/channel_notes.h"
#include "core/formats/recording_sink.h"
#include "core/formats/sound/wav_reader.h"

namespace stillcut::record {
namespace {

class SoundSink final : public RecordingSink {
 public:
  SoundSink(std::unique_ptr<WavWriter> writer, std::vector<double> factors)
      : writer_(std::move(writer)), factors_(std::move(factors)) {}
  Status write(const SampleBlock& block) override { return writer_->write(block, factors_); }
  Status finish() override { return writer_->finish(); }

 private:
  std::unique_ptr<WavWriter> writer_;
  std::vector<double> factors_;  // to what is stored
};

// FLAC holds whole numbers between -1 and 1: full scale is the power of two that holds the largest sample, so that the
// 24 bits are used and nothing is rounded twice.
double fullScaleFor(double peak) {
  return peak > 0.0 ? std::exp2(std::floor(std::log2(peak)) + 1.0) : 1.0;
}

}  // namespace

Result<std::unique_ptr<RecordingSink>> createSoundSink(const std::string& path, const ExportPlan& plan) {
  const bool flac = std::filesystem::path(path).extension() == ".flac";
  std::vector<double> fullScale(plan.channels.size(), 1.0);
  std::vector<double> factors;
  for (std::size_t c = 0; c < plan.channels.size(); ++c) {
    if (flac) fullScale[c] = fullScaleFor(plan.peaks.at(c));
    // libsndfile writes full scale as 2^23 - 1 and reads it as 2^23.
    const double whole = flac ? 8388608.0 / 8388607.0 : 1.0;
    factors.push_back(plan.channels[c].info.scale / fullScale[c] * whole);
  }
  auto writer = WavWriter::create(path, static_cast<int>(plan.channels.size()), plan.rate,
                                  {flac ? SoundFormat::Flac : SoundFormat::Wav, channelNotes(plan, fullScale)});
  if (!writer) return writer.error();
  return std::unique_ptr<RecordingSink>(new SoundSink(std::move(*writer), std::move(factors)));
}

}  // namespace stillcut::record
