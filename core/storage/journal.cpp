#include "core/storage/journal.h"

#include <array>
#include <bit>
#include <cstring>

namespace stillcut::record {
namespace {

static_assert(std::endian::native == std::endian::little, "journals are written as memory has them");

constexpr std::uint64_t kMagic = 0x324C4E524A544353ULL;       // "SCTJRNL2"
constexpr std::uint64_t kFirstMagic = 0x314C4E524A544353ULL;  // "SCTJRNL1": without the bytes before

struct Header {
  std::uint64_t magic = kMagic;
  std::uint64_t commit = 0;
  std::uint64_t fileSize = 0;
  std::uint64_t overwrites = 0;
  std::uint64_t payload = 0;
  std::uint32_t payloadCrc = 0;
  std::uint32_t headerCrc = 0;  // of all before
  std::uint64_t sizeAfter = 0;
  std::uint64_t sizeAfterCheck = 0;  // its complement: it came after the header's checksum
};
static_assert(sizeof(Header) == 64);

// CRC-32 of IEEE 802.3, reflected.
constexpr std::array<std::uint32_t, 256> crcTable() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t c = i;
    for (int bit = 0; bit < 8; ++bit) c = (c >> 1U) ^ ((c & 1U) != 0 ? 0xEDB88320U : 0U);
    table[i] = c;
  }
  return table;
}

std::uint32_t crc32(std::span<const std::byte> bytes) {
  static constexpr std::array<std::uint32_t, 256> kTable = crcTable();
  std::uint32_t c = 0xFFFFFFFFU;
  for (const std::byte b : bytes) c = kTable[(c ^ std::to_integer<std::uint32_t>(b)) & 0xFFU] ^ (c >> 8U);
  return ~c;
}

std::span<const std::byte> guarded(const Header& header) {
  return std::as_bytes(std::span(&header, 1)).first(offsetof(Header, headerCrc));
}

template <class T>
void append(std::vector<std::byte>& out, const T& value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

}  // namespace

std::vector<std::byte> encodeJournal(const JournalContent& content) {
  std::vector<std::byte> out(sizeof(Header));
  for (const Overwrite& o : content.overwrites) {
    append(out, o.offset);
    append(out, static_cast<std::uint64_t>(o.bytes.size()));
    out.insert(out.end(), o.before.begin(), o.before.end());
    out.insert(out.end(), o.bytes.begin(), o.bytes.end());
  }
  Header header;
  header.commit = content.commit;
  header.fileSize = content.fileSize;
  header.overwrites = content.overwrites.size();
  header.payload = out.size() - sizeof(Header);
  header.payloadCrc = crc32(std::span(out).subspan(sizeof(Header)));
  header.headerCrc = crc32(guarded(header));
  header.sizeAfter = content.sizeAfter;
  header.sizeAfterCheck = ~content.sizeAfter;
  std::memcpy(out.data(), &header, sizeof header);
  return out;
}

std::optional<JournalContent> decodeJournal(std::span<const std::byte> bytes) {
  Header header;
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  bytes = bytes.subspan(sizeof header);
  const bool first = header.magic == kFirstMagic;
  if (!first && (header.magic != kMagic || header.sizeAfterCheck != ~header.sizeAfter)) return std::nullopt;
  if (header.headerCrc != crc32(guarded(header)) || header.payload > bytes.size()) {
    return std::nullopt;
  }
  bytes = bytes.first(header.payload);
  if (crc32(bytes) != header.payloadCrc) return std::nullopt;
  JournalContent content{header.commit, header.fileSize, {}, first ? header.fileSize : header.sizeAfter};
  while (!bytes.empty()) {
    std::array<std::uint64_t, 2> place{};  // offset, length
    if (bytes.size() < sizeof place) return std::nullopt;
    std::memcpy(place.data(), bytes.data(), sizeof place);
    bytes = bytes.subspan(sizeof place);
    const std::size_t copies = first ? 1 : 2;
    if (place[1] > bytes.size() / copies) return std::nullopt;
    const auto before = bytes.first((copies - 1) * place[1]);
    const auto data = bytes.subspan(before.size(), place[1]);
    content.overwrites.push_back({place[0], {data.begin(), data.end()}, {before.begin(), before.end()}});
    bytes = bytes.subspan(copies * place[1]);
  }
  if (content.overwrites.size() != header.overwrites) return std::nullopt;
  return content;
}

std::string journalPath(const std::string& session) {
  return session + ".journal";
}

}  // namespace stillcut::record
