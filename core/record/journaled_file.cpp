#include "core/record/journaled_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace stillcut::record {
namespace {

constexpr off_t kJournalReserve = 256L << 10U;  // taken while there is room, so that a full disk can still be committed
constexpr std::uint64_t kLongestJournal = 1ULL << 30U;

std::uint64_t sizeOf(int file) {
  struct stat info {};
  return fstat(file, &info) == 0 ? static_cast<std::uint64_t>(info.st_size) : 0;
}

bool readAll(int file, std::uint64_t offset, std::span<std::byte> out) {
  while (!out.empty()) {
    const ssize_t got = pread(file, out.data(), out.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) {
      std::fill(out.begin(), out.end(), std::byte{0});
      return true;
    }
    offset += static_cast<std::uint64_t>(got);
    out = out.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

// What a dead writer has left, where it fits the file.
std::optional<JournalContent> journalOf(int journal, std::uint64_t fileSize) {
  const std::uint64_t size = sizeOf(journal);
  if (size > kLongestJournal) return std::nullopt;
  std::vector<std::byte> bytes(size);
  if (!readAll(journal, 0, bytes)) return std::nullopt;
  std::optional<JournalContent> content = decodeJournal(bytes);
  // Shorter than when the journal was made: the two do not belong together.
  if (content && content->fileSize > fileSize) return std::nullopt;
  return content;
}

void syncFolder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return;
  (void)fsync(fd);
  ::close(fd);
}

}  // namespace

Result<std::unique_ptr<JournaledFile>> JournaledFile::open(const std::string& path, Access access, Disk& disk) {
  std::unique_ptr<JournaledFile> file(new JournaledFile(path, disk));
  constexpr mode_t kMode = 0666;
  const int flags = access == Access::Create ? O_RDWR | O_CREAT | O_TRUNC : access == Access::Write ? O_RDWR : O_RDONLY;
  file->file_ = ::open(path.c_str(), flags | O_CLOEXEC, kMode);
  if (file->file_ < 0) return Error{path, "cannot be opened", std::strerror(errno)};
  file->size_ = file->committed_ = sizeOf(file->file_);
  if (access == Access::Write) {
    if (const Status s = file->beginJournal(path); !s) return s.error();
  }
  if (access == Access::Read) {
    const int journal = ::open(journalPath(path).c_str(), O_RDONLY | O_CLOEXEC);
    if (journal >= 0) {
      if (auto left = journalOf(journal, file->size_)) file->pending_ = std::move(*left);
      ::close(journal);
    }
  }
  return file;
}

JournaledFile::~JournaledFile() {
  if (file_ >= 0) ::close(file_);
  if (journalFile_ >= 0) ::close(journalFile_);
}

Status JournaledFile::beginJournal(const std::string& session) {
  constexpr mode_t kMode = 0666;
  journal_ = journalPath(session);
  journalFile_ = ::open(journal_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode);
  if (journalFile_ < 0) return Error{journal_, "cannot be written", std::strerror(errno)};
  if (flock(journalFile_, LOCK_EX | LOCK_NB) != 0) return Error{session, "is being written already", ""};
  if (ftruncate(journalFile_, 0) != 0) return Error{journal_, "cannot be written", std::strerror(errno)};
  (void)posix_fallocate(journalFile_, 0, kJournalReserve);
  if (!disk_.sync(file_) || fsync(journalFile_) != 0) return Error{session, "cannot be written", std::strerror(errno)};
  syncFolder(session);
  committed_ = size_;
  return Done{};
}

bool JournaledFile::failed(const char* doing) {
  error_ = path_ + ": " + doing + " failed (" + std::strerror(errno) + ")";
  return false;
}

bool JournaledFile::read(std::uint64_t offset, std::span<std::byte> out) const {
  if (!readAll(file_, offset, out)) return false;
  for (const Overwrite& o : pending_.overwrites) {
    const std::uint64_t from = std::max(offset, o.offset);
    const std::uint64_t to = std::min(offset + out.size(), o.offset + o.bytes.size());
    if (from >= to) continue;
    std::copy_n(o.bytes.begin() + static_cast<std::ptrdiff_t>(from - o.offset), to - from,
                out.begin() + static_cast<std::ptrdiff_t>(from - offset));
  }
  return true;
}

bool JournaledFile::write(std::uint64_t offset, std::span<const std::byte> bytes, bool growsOnly) {
  if (abandoned_) return true;
  size_ = std::max(size_, offset + bytes.size());
  if (journalFile_ >= 0 && !growsOnly && offset < committed_) {
    pending_.overwrites.push_back({offset, {bytes.begin(), bytes.end()}});
    return true;
  }
  return disk_.write(file_, offset, bytes) || failed("writing");
}

void JournaledFile::truncate(std::uint64_t size) {
  if (!abandoned_) size_ = size;
}

Status JournaledFile::commit(bool toDisk) {
  if (abandoned_) return Done{};
  ++pending_.commit;
  pending_.fileSize = sizeOf(file_);
  if (toDisk && !disk_.sync(file_)) return failed("writing to disk"), Error{"", error_, ""};
  if (!pending_.overwrites.empty() && journalFile_ >= 0) {
    const std::vector<std::byte> journal = encodeJournal(pending_);
    if (!disk_.write(journalFile_, 0, journal) || (toDisk && !disk_.sync(journalFile_))) {
      return failed("writing the journal"), Error{"", error_, ""};
    }
  }
  return apply(toDisk);
}

// From here on a reader of the journal would do the same.
Status JournaledFile::apply(bool toDisk) {
  for (const Overwrite& o : pending_.overwrites) {
    if (!disk_.write(file_, o.offset, o.bytes)) return failed("writing"), Error{"", error_, ""};
  }
  const bool changed = !pending_.overwrites.empty();
  pending_.overwrites.clear();
  if (sizeOf(file_) != size_ && ftruncate(file_, static_cast<off_t>(size_)) != 0) {
    return failed("setting the length"), Error{"", error_, ""};
  }
  committed_ = size_;
  if (changed && toDisk && !disk_.sync(file_)) return failed("writing to disk"), Error{"", error_, ""};
  return Done{};
}

void JournaledFile::abandon() {
  abandoned_ = true;
  pending_.overwrites.clear();
  size_ = committed_;
}

void JournaledFile::removeJournal() {
  if (journalFile_ < 0) return;
  std::remove(journal_.c_str());
  ::close(std::exchange(journalFile_, -1));
}

Result<Recovery> recoverFromJournal(const std::string& path) {
  const std::string name = journalPath(path);
  std::error_code unknown;
  if (!std::filesystem::exists(name, unknown)) return Recovery::NothingToDo;
  const int journal = ::open(name.c_str(), O_RDWR | O_CLOEXEC);
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  const auto left = [&](Result<Recovery> outcome) {
    if (journal >= 0) ::close(journal);
    if (file >= 0) ::close(file);
    return outcome;
  };
  if (journal < 0 || file < 0) return left(Recovery::NotWritable);
  if (flock(journal, LOCK_EX | LOCK_NB) != 0) return left(Recovery::WriterAlive);
  if (const auto content = journalOf(journal, sizeOf(file))) {
    for (const Overwrite& o : content->overwrites) {
      if (!systemDisk().write(file, o.offset, o.bytes)) {
        return left(Error{path, "could not be repaired", std::strerror(errno)});
      }
    }
    if (fdatasync(file) != 0) return left(Error{path, "could not be repaired", std::strerror(errno)});
  }
  return left(Recovery::Recovered);
}

}  // namespace stillcut::record
