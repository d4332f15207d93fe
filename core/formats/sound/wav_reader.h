// WavReader: sound files through libsndfile (WAV, RF64, FLAC, AIFF ... of any PCM or float format), and writeWav.
// Whole numbers come as fractions of full scale, floats as they are; the unit is full scale unless --scale is given.
// Thread: its owner's; not real-time.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/formats/recording_reader.h"

namespace stillcut::record {

Result<std::unique_ptr<RecordingReader>> openWav(const std::string& path, const ReadOptions& options);

// Whether libsndfile knows the file, and by more than a guess.
bool isRareSound(const std::string& path);

enum class SoundFormat { Wav, Flac };

struct SoundOptions {
  SoundFormat format = SoundFormat::Wav;
  std::string comment;  // kept in the file; empty: none
};

// Writes 32-bit float WAV, which becomes RF64 by itself above 4 GiB, or FLAC with 24 bits, block by block. Until
// finish() the samples are in "PATH.part"; a writer that is destroyed without finish() leaves nothing behind.
class WavWriter {
 public:
  static Result<std::unique_ptr<WavWriter>> create(const std::string& path, int channels, Hertz rate,
                                                   const SoundOptions& options = {});
  ~WavWriter();
  WavWriter(const WavWriter&) = delete;
  WavWriter& operator=(const WavWriter&) = delete;

  // `scale` per channel turns device units into what is stored; empty: stored as they are.
  Status write(const SampleBlock& block, std::span<const double> scale = {});
  Status finish();

 private:
  struct Impl;
  explicit WavWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace stillcut::record
