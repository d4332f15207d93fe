#include "core/formats/sound/riff_header.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace stillcut::record {
namespace {

constexpr std::uint64_t kUnknown = 0xFFFFFFFFU;
constexpr std::uint64_t k4GiB = std::uint64_t{1} << 32U;

std::uint32_t littleEndian32(const unsigned char* bytes) {
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U |
         static_cast<std::uint32_t>(bytes[2]) << 16U | static_cast<std::uint32_t>(bytes[3]) << 24U;
}

std::uint16_t littleEndian16(const unsigned char* bytes) {
  return static_cast<std::uint16_t>(bytes[0] | bytes[1] << 8U);
}

// Chunk "fmt ". In its extensible form the format stands further back.
void takeFormat(std::ifstream& file, RiffHeader& header) {
  constexpr std::uint16_t kExtensible = 0xFFFE;
  std::array<unsigned char, 26> body{};
  file.read(reinterpret_cast<char*>(body.data()), body.size());
  header.format = littleEndian16(body.data());
  header.channels = littleEndian16(body.data() + 2);
  header.rate = static_cast<int>(std::min<std::uint32_t>(littleEndian32(body.data() + 4), 0x7fffffff));
  header.bits = littleEndian16(body.data() + 14);
  if (header.format == kExtensible) header.format = littleEndian16(body.data() + 24);
  file.clear();
}

// `size` as the chunk has it; `fromDs64` stands for it in RF64. What is behind samples that wrapped cannot be other
// chunks: 4 GiB of them are none.
void judgeSizes(RiffHeader& header, std::uint64_t size, std::uint64_t fromDs64) {
  using Sizes = RiffHeader::Sizes;
  const bool streamed = size == kUnknown && fromDs64 == kUnknown;
  header.promised = size == kUnknown ? fromDs64 : size;
  if (streamed) {
    header.sizes = Sizes::Unknown;
  } else if (header.promised == 0 && header.held > 0) {
    header.sizes = Sizes::Unfinished;
  } else if (header.promised > header.held) {
    header.sizes = Sizes::Short;
  } else if (size != kUnknown && header.held - header.promised >= k4GiB) {
    header.sizes = Sizes::Wrapped;
    header.held = header.promised + (header.held - header.promised) / k4GiB * k4GiB;
  }
}

// Whether what stands at `at` can be a chunk: four letters, and a size that the file has room for.
bool isChunk(std::ifstream& file, std::uint64_t at, std::uint64_t fileSize) {
  std::array<unsigned char, 8> head{};
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  file.read(reinterpret_cast<char*>(head.data()), head.size());
  file.clear();
  const bool letters =
      std::all_of(head.begin(), head.begin() + 4, [](unsigned char c) { return c >= 0x20 && c < 0x7F; });
  constexpr std::uint64_t kCutAway = 1024;  // of the last chunk
  return letters && at + 8 + littleEndian32(head.data() + 4) <= fileSize + kCutAway;
}

bool holdsOnlyZeros(std::ifstream& file, std::uint64_t at) {
  std::array<char, 65536> bytes{};
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  bool zeros = true;
  while (zeros && file) {
    file.read(bytes.data(), bytes.size());
    zeros = std::all_of(bytes.begin(), bytes.begin() + file.gcount(), [](char c) { return c == 0; });
  }
  file.clear();
  return zeros;
}

// A recorder that writes the size now and then, and lost its power: samples go on behind those of the header, where
// another chunk or nothing would be. A few bytes are what some program has hung on.
void findSamplesBehind(std::ifstream& file, RiffHeader& header, std::uint64_t fileSize) {
  constexpr std::uint64_t kFew = 4096;
  constexpr std::uint16_t kWhole = 1, kFloat = 3;
  const bool plain = header.format == kWhole || header.format == kFloat;
  if (!plain || header.sizes != RiffHeader::Sizes::True || header.held < header.promised + kFew) return;
  const std::uint64_t end = header.dataAt + header.promised;
  if (isChunk(file, end, fileSize) || isChunk(file, end + 1, fileSize) || holdsOnlyZeros(file, end)) return;
  header.sizes = RiffHeader::Sizes::Behind;
}

}  // namespace

// How much there should be stands in the data chunk, or, of RF64, in the ds64 chunk before it.
Result<std::optional<RiffHeader>> readRiffHeader(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::array<unsigned char, 12> head{};
  file.read(reinterpret_cast<char*>(head.data()), 12);
  const bool rf64 = std::memcmp(head.data(), "RF64", 4) == 0;
  const bool riff = rf64 || std::memcmp(head.data(), "RIFF", 4) == 0;
  if (!file || !riff || std::memcmp(head.data() + 8, "WAVE", 4) != 0) return std::optional<RiffHeader>();
  const std::uint64_t fileSize = std::filesystem::file_size(path);
  RiffHeader header;
  std::uint64_t dataSize = kUnknown;  // from ds64
  std::uint64_t at = 12;
  constexpr int kMostChunks = 1000;
  for (int i = 0; i < kMostChunks && at + 8 <= fileSize; ++i) {
    std::array<unsigned char, 24> chunk{};
    file.seekg(static_cast<std::streamoff>(at));
    file.read(reinterpret_cast<char*>(chunk.data()), chunk.size());
    if (file.gcount() < 8) break;
    file.clear();
    const std::uint64_t size = littleEndian32(chunk.data() + 4);
    at += 8;
    if (rf64 && std::memcmp(chunk.data(), "ds64", 4) == 0) {
      dataSize = littleEndian32(chunk.data() + 16) | std::uint64_t{littleEndian32(chunk.data() + 20)} << 32U;
    }
    if (std::memcmp(chunk.data(), "fmt ", 4) == 0) {
      file.seekg(static_cast<std::streamoff>(at));
      takeFormat(file, header);
    }
    if (std::memcmp(chunk.data(), "data", 4) == 0) {
      header.dataAt = at;
      header.held = fileSize - std::min(at, fileSize);
      judgeSizes(header, size, dataSize);
      findSamplesBehind(file, header, fileSize);
      return std::optional<RiffHeader>(header);
    }
    at += size + (size & 1U);
  }
  return Error{path, message("holds no samples"), message("the data chunk is missing: a truncated file")};
}

std::optional<Message> noteOfSizes(const RiffHeader& header) {
  switch (header.sizes) {
    case RiffHeader::Sizes::True:
      return std::nullopt;
    case RiffHeader::Sizes::Unknown:
      return message("the header does not say how much follows, as of a recorder that wrote into a pipe: all is read");
    case RiffHeader::Sizes::Wrapped:
      return message(
          "the header's size is not true: it says %1 bytes, which is what 32 bits leave of %2, which are read",
          header.promised, header.held);
    case RiffHeader::Sizes::Short:
    case RiffHeader::Sizes::Behind:
    case RiffHeader::Sizes::Unfinished:
      break;
  }
  return message(
      "the header promises %1 bytes of samples, the file holds %2, which are read: its recorder did not end it",
      std::to_string(header.promised), std::to_string(header.held));
}

}  // namespace stillcut::record
