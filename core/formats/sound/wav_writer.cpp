#include <sndfile.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include "core/formats/sound/wav_reader.h"

namespace stillcut::record {

struct WavWriter::Impl {
  std::string path;
  std::string part;
  SNDFILE* file = nullptr;
  int channels = 0;
  bool finished = false;
  std::vector<float> interleaved;
};

Result<std::unique_ptr<WavWriter>> WavWriter::create(const std::string& path, int channels, Hertz rate,
                                                     const SoundOptions& options) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->part = path + ".part";
  impl->channels = channels;
  SF_INFO info{};
  info.channels = channels;
  info.samplerate = static_cast<int>(std::lround(rate.value));
  const bool flac = options.format == SoundFormat::Flac;
  info.format = flac ? SF_FORMAT_FLAC | SF_FORMAT_PCM_24 : SF_FORMAT_RF64 | SF_FORMAT_FLOAT;
  if (flac && channels > 8) return Error{path, message("cannot be written"), message("FLAC holds at most 8 channels")};
  impl->file = sf_open(impl->part.c_str(), SFM_WRITE, &info);
  if (impl->file == nullptr) return Error{path, message("cannot be written"), foreign(sf_strerror(nullptr))};
  // RF64 while it is written; a plain WAV at the end if it is short enough to be one.
  if (!flac) sf_command(impl->file, SFC_RF64_AUTO_DOWNGRADE, nullptr, SF_TRUE);
  if (!options.comment.empty()) sf_set_string(impl->file, SF_STR_COMMENT, options.comment.c_str());
  return std::unique_ptr<WavWriter>(new WavWriter(std::move(impl)));
}

WavWriter::WavWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

WavWriter::~WavWriter() {
  if (impl_->file != nullptr) sf_close(impl_->file);
  if (!impl_->finished) std::remove(impl_->part.c_str());
}

Status WavWriter::write(const SampleBlock& block, std::span<const double> scale) {
  if (block.channels != impl_->channels) return Error{impl_->path, message("the number of channels changed")};
  const auto channels = static_cast<std::size_t>(block.channels);
  impl_->interleaved.resize(channels * static_cast<std::size_t>(block.frames));
  for (std::size_t c = 0; c < channels; ++c) {
    const std::span<const float> from = block.channel(static_cast<int>(c));
    const double factor = c < scale.size() ? scale[c] : 1.0;
    for (std::size_t f = 0; f < from.size(); ++f) {
      impl_->interleaved[f * channels + c] = static_cast<float>(from[f] * factor);
    }
  }
  if (sf_writef_float(impl_->file, impl_->interleaved.data(), block.frames) != block.frames) {
    return Error{impl_->path, message("cannot be written"), foreign(sf_strerror(impl_->file))};
  }
  return Done{};
}

Status WavWriter::finish() {
  const int problem = sf_close(std::exchange(impl_->file, nullptr));
  if (problem != 0) return Error{impl_->path, message("cannot be written"), foreign(sf_error_number(problem))};
  if (std::rename(impl_->part.c_str(), impl_->path.c_str()) != 0)
    return Error{impl_->path, message("cannot be written")};
  impl_->finished = true;
  return Done{};
}

}  // namespace stillcut::record
