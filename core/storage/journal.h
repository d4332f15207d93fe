// Journal: the overwrites of one commit in a file beside the session, so that a crash in the midst of them can be
// completed. One commit at a time; a journal that is torn itself is as good as none, because then the session has not
// been touched yet.
//   header (64 bytes)  magic, commit number, size of the session, number of overwrites, bytes that follow, their
//                      CRC-32, size of the session afterwards
//   then each          offset, length, the bytes as they were, the bytes as they shall be
// A journal fits a file only where every byte it speaks of is as it was or as it shall be. The first format,
// "SCTJRNL1", had neither the size afterwards nor the bytes as they were; it is still read.
// All numbers little-endian, 64 bits, but for the checksums. Pure: any thread.
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
  std::vector<std::byte> before{};  // as many; empty: not known
};

struct JournalContent {
  std::uint64_t commit = 0;
  std::uint64_t fileSize = 0;         // of the session, with all that the overwrites refer to
  std::vector<Overwrite> overwrites;  // in the order in which they are made
  std::uint64_t sizeAfter = 0;        // of the session, when they are made
};

// Each overwrite with the bytes before.
std::vector<std::byte> encodeJournal(const JournalContent& content);
// Nothing: empty, torn, or no journal.
std::optional<JournalContent> decodeJournal(std::span<const std::byte> bytes);

// "cut.h5" -> "cut.h5.journal"
std::string journalPath(const std::string& session);

}  // namespace stillcut::record
