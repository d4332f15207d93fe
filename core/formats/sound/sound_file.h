// A sound file open for reading through libsndfile, as its header says or, where the header's size is not true, as the
// samples that are there. Thread: its owner's; not real-time.
#pragma once

#include <sndfile.h>

#include <memory>
#include <string>

#include "core/formats/sound/riff_header.h"

namespace stillcut::record {

class SoundFile {
 public:
  // `header`: null where the file is no WAV. Not opened: handle() is null, and sf_strerror(nullptr) says why.
  SoundFile(const std::string& path, const RiffHeader* header);
  ~SoundFile();
  SoundFile(const SoundFile&) = delete;
  SoundFile& operator=(const SoundFile&) = delete;

  SNDFILE* handle() const { return handle_; }
  const SF_INFO& info() const { return info_; }

 private:
  struct Bytes;
  void openBytes(const std::string& path, const RiffHeader& header);

  SF_INFO info_{};
  std::unique_ptr<Bytes> bytes_;  // that are read as they are; null: libsndfile reads the file by itself
  SNDFILE* handle_ = nullptr;
};

}  // namespace stillcut::record
