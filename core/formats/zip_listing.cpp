#include "core/formats/zip_listing.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace stillcut::record {
namespace {

constexpr std::uint64_t kMostDeflated = 1100;  // times; zlib's own limit is 1032
constexpr std::size_t kMostEntries = 4096;
constexpr std::size_t kDirectoryBytes = 46;  // of an entry, without its name
constexpr std::size_t kLocalBytes = 30;      // before an entry's bytes, without its name
constexpr std::size_t kEndBytes = 22;

std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i > 0; --i) value = value << 8U | static_cast<unsigned char>(bytes[at + i - 1]);
  return value;
}

Error damaged(const std::string& path) {
  return Error{path, message("the ZIP archive is damaged"), message("a truncated or damaged file")};
}

std::string take(std::ifstream& file, std::uint64_t from, std::uint64_t count) {
  std::string bytes(static_cast<std::size_t>(count), '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(from));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

// The archive's directory as bytes.
Result<std::string> directoryOf(std::ifstream& file, std::uint64_t size, const std::string& path) {
  constexpr std::uint64_t kLongestComment = 0xffff;
  const std::uint64_t from = size - std::min(size, kEndBytes + kLongestComment);
  const std::string tail = take(file, from, size - from);
  const std::size_t end = tail.rfind("PK\x05\x06");
  if (end == std::string::npos || tail.size() - end < kEndBytes) return damaged(path);
  const std::uint64_t bytes = number(tail, end + 12, 4);
  const std::uint64_t at = number(tail, end + 16, 4);
  if (bytes == 0xffffffffU || at == 0xffffffffU)
    return Error{path, message("is a ZIP archive above 4 GiB"), message("unpack it, and open what is in it")};
  constexpr std::uint64_t kLongest = std::uint64_t{16} << 20U;
  if (at > size || bytes > size - at || bytes > kLongest) return damaged(path);
  return take(file, at, bytes);
}

// Where the bytes of an entry begin is known from what stands before them alone.
Status placeEntry(std::ifstream& file, std::uint64_t size, ZipEntry& entry) {
  const std::string local = take(file, entry.part.from, kLocalBytes);
  if (local.size() < kLocalBytes || !local.starts_with("PK\x03\x04")) return damaged(entry.part.path);
  entry.part.from += kLocalBytes + number(local, 26, 2) + number(local, 28, 2);
  const FilePart& part = entry.part;
  const std::uint64_t most = part.deflated ? part.packed * kMostDeflated : part.packed;
  if (part.from > size || part.packed > size - part.from || part.size > most) return damaged(part.path);
  return Done{};
}

}  // namespace

Result<std::vector<ZipEntry>> listZip(const std::string& path) {
  std::error_code problem;
  const std::uint64_t size = std::filesystem::file_size(path, problem);
  std::ifstream file(path, std::ios::binary);
  if (!file || problem) return Error{path, message("cannot be opened")};
  const Result<std::string> directory = directoryOf(file, size, path);
  if (!directory) return directory.error();
  std::vector<ZipEntry> entries;
  const std::string_view all = *directory;
  for (std::size_t at = 0; at + kDirectoryBytes <= all.size();) {
    const std::string_view one = all.substr(at);
    if (!one.starts_with("PK\x01\x02") || entries.size() == kMostEntries) return damaged(path);
    const auto name = static_cast<std::size_t>(number(one, 28, 2));
    const auto rest = static_cast<std::size_t>(number(one, 30, 2) + number(one, 32, 2));
    if (kDirectoryBytes + name + rest > one.size()) return damaged(path);
    ZipEntry entry;
    entry.name = one.substr(kDirectoryBytes, name);
    const std::uint64_t method = number(one, 10, 2);
    constexpr std::uint64_t kEncrypted = 1, kStored = 0, kDeflated = 8;
    entry.part = {path, number(one, 42, 4), number(one, 20, 4), number(one, 24, 4), method == kDeflated};
    at += kDirectoryBytes + name + rest;
    if ((number(one, 8, 2) & kEncrypted) != 0 || (method != kStored && method != kDeflated)) continue;
    if (const Status s = placeEntry(file, size, entry); !s) return s.error();
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace stillcut::record
