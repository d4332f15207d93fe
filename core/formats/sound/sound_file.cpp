#include "core/formats/sound/sound_file.h"

#include <algorithm>
#include <fstream>

namespace stillcut::record {

// The samples alone, from the first byte behind the header.
struct SoundFile::Bytes {
  std::ifstream file;
  std::uint64_t from = 0;
  sf_count_t size = 0;
  sf_count_t at = 0;

  static sf_count_t length(void* self) { return static_cast<Bytes*>(self)->size; }
  static sf_count_t tell(void* self) { return static_cast<Bytes*>(self)->at; }
  static sf_count_t seek(sf_count_t offset, int whence, void* self) {
    Bytes& bytes = *static_cast<Bytes*>(self);
    const sf_count_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? bytes.at : bytes.size;
    bytes.at = std::clamp<sf_count_t>(base + offset, 0, bytes.size);
    bytes.file.clear();
    bytes.file.seekg(static_cast<std::streamoff>(bytes.from + static_cast<std::uint64_t>(bytes.at)));
    return bytes.at;
  }
  static sf_count_t read(void* to, sf_count_t count, void* self) {
    Bytes& bytes = *static_cast<Bytes*>(self);
    bytes.file.read(static_cast<char*>(to), std::min(count, bytes.size - bytes.at));
    bytes.at += bytes.file.gcount();
    return bytes.file.gcount();
  }
  static sf_count_t write(const void*, sf_count_t, void*) { return 0; }
};

namespace {

// Of plain samples; 0: others are not read without a true header.
int plainFormat(const RiffHeader& header) {
  constexpr std::uint16_t kWhole = 1, kFloat = 3;
  if (header.format == kFloat) return header.bits == 32 ? SF_FORMAT_FLOAT : header.bits == 64 ? SF_FORMAT_DOUBLE : 0;
  if (header.format != kWhole) return 0;
  switch (header.bits) {
    case 8:
      return SF_FORMAT_PCM_U8;
    case 16:
      return SF_FORMAT_PCM_16;
    case 24:
      return SF_FORMAT_PCM_24;
    case 32:
      return SF_FORMAT_PCM_32;
    default:
      return 0;
  }
}

// Of a stream too: libsndfile reads none in RF64.
bool isUntold(const RiffHeader& header) {
  return header.sizes == RiffHeader::Sizes::Unfinished || header.sizes == RiffHeader::Sizes::Wrapped ||
         header.sizes == RiffHeader::Sizes::Unknown || header.sizes == RiffHeader::Sizes::Behind;
}

}  // namespace

SoundFile::SoundFile(const std::string& path, const RiffHeader* header) {
  if (header != nullptr && isUntold(*header) && plainFormat(*header) != 0 && header->channels > 0) {
    openBytes(path, *header);
    return;
  }
  handle_ = sf_open(path.c_str(), SFM_READ, &info_);
}

SoundFile::~SoundFile() {
  if (handle_ != nullptr) sf_close(handle_);
}

void SoundFile::openBytes(const std::string& path, const RiffHeader& header) {
  bytes_ = std::make_unique<Bytes>();
  bytes_->file.open(path, std::ios::binary);
  bytes_->from = header.dataAt;
  const std::uint64_t frame = static_cast<std::uint64_t>(header.channels) * header.bits / 8;
  bytes_->size = static_cast<sf_count_t>(header.held / frame * frame);
  Bytes::seek(0, SEEK_SET, bytes_.get());
  info_.samplerate = header.rate;
  info_.channels = header.channels;
  info_.format = SF_FORMAT_RAW | plainFormat(header) | SF_ENDIAN_LITTLE;
  SF_VIRTUAL_IO io{Bytes::length, Bytes::seek, Bytes::read, Bytes::write, Bytes::tell};
  handle_ = sf_open_virtual(&io, SFM_READ, &info_, bytes_.get());
  if (handle_ != nullptr) info_.format = SF_FORMAT_WAV | plainFormat(header);
}

}  // namespace stillcut::record
