// Journal: the overwrites of one commit in a file beside the session, so that a crash in the midst of them can be
// completed. One commit at a time; a journal that is torn itself is as good as none, because then the session has not
// been touched yet.
//   header (64 bytes)  magic, commit number, size of the session, number of overwrites, bytes that follow, their CRC-32
//   then each          offset, length, bytes
// All numbers little-endian, 64 bits, but for the checksums.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stillcut::record {

struct Overwrite {
  std::uint64_t offset = 0;
  std::vector<std::byte> bytes;
};

struct JournalContent {
  std::uint64_t commit = 0;
  std::uint64_t fileSize = 0;         // of the session, with all that the overwrites refer to
  std::vector<Overwrite> overwrites;  // in the order in which they are made
};

std::vector<std::byte> encodeJournal(const JournalContent& content);
// Nothing: empty, torn, or no journal.
std::optional<JournalContent> decodeJournal(std::span<const std::byte> bytes);

// "cut.h5" -> "cut.h5.journal"
std::string journalPath(const std::string& session);

}  // namespace stillcut::record
