#include "core/storage/journaled_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <utility>

namespace stillcut::record {
namespace {

constexpr off_t kJournalReserve = 256L << 10U;  // taken while there is room, so that a full disk can still be committed
constexpr std::uint64_t kLongestJournal = 1ULL << 30U;

std::uint64_t sizeOf(int file) {
  struct stat info {};
  return fstat(file, &info) == 0 ? static_cast<std::uint64_t>(info.st_size) : 0;
}

// Shares and file systems of their own kind answer flock() so.
bool lacksLocks(int cause) {
  return cause == ENOLCK || cause == ENOSYS || cause == EOPNOTSUPP || cause == EINVAL;
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

std::optional<JournalContent> journalOf(int journal) {
  const std::uint64_t size = sizeOf(journal);
  if (size > kLongestJournal) return std::nullopt;
  std::vector<std::byte> bytes(size);
  if (!readAll(journal, 0, bytes)) return std::nullopt;
  return decodeJournal(bytes);
}

// The file begins with HDF5's own marks. Part of every commit: a file that another program has closed, cleared or
// replaced since does not have them any more.
constexpr std::uint64_t kHead = 48;

bool markedAsOpen(int file) {
  constexpr std::size_t kVersion = 8, kFlags = 11;
  constexpr std::byte kFirstWithFlags{3}, kWriting{1};
  std::array<std::byte, kFlags + 1> head{};
  return readAll(file, 0, head) && head[kVersion] >= kFirstWithFlags && (head[kFlags] & kWriting) != std::byte{0};
}

// A commit begun on this very file: whatever moment it was broken off at, each byte is as it was before or as it shall
// be. Anything else was written by somebody else, later, or is another file.
bool belongsTo(const JournalContent& content, int file) {
  if (std::min(content.fileSize, content.sizeAfter) > sizeOf(file)) return false;
  return std::all_of(content.overwrites.begin(), content.overwrites.end(), [file](const Overwrite& o) {
    if (o.before.empty()) return markedAsOpen(file);  // of the first format
    std::vector<std::byte> now(o.bytes.size());
    if (!readAll(file, o.offset, now)) return false;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (now[i] != o.before[i] && now[i] != o.bytes[i]) return false;
    }
    return true;
  });
}

// Each place once, as it is in the file and as the last of its overwrites leaves it.
std::vector<Overwrite> merged(std::span<const Overwrite> overwrites, int file) {
  std::vector<std::array<std::uint64_t, 2>> places{{0, kHead}};
  for (const Overwrite& o : overwrites) places.push_back({o.offset, o.offset + o.bytes.size()});
  std::sort(places.begin(), places.end());
  std::vector<Overwrite> all;
  for (const auto& [from, to] : places) {
    if (all.empty() || from > all.back().offset + all.back().bytes.size()) {
      all.push_back({from, {}, {}});
    }
    const std::uint64_t end = std::max(all.back().offset + all.back().bytes.size(), to);
    all.back().bytes.resize(end - all.back().offset);
  }
  for (Overwrite& o : all) {
    o.before.resize(o.bytes.size());
    if (!readAll(file, o.offset, o.before)) return {};
    o.bytes = o.before;
  }
  for (const Overwrite& o : overwrites) {
    Overwrite& place = *std::prev(std::upper_bound(all.begin(), all.end(), o.offset,
                                                   [](std::uint64_t at, const Overwrite& p) { return at < p.offset; }));
    std::copy(o.bytes.begin(), o.bytes.end(),
              place.bytes.begin() + static_cast<std::ptrdiff_t>(o.offset - place.offset));
  }
  return all;
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
  if (file->file_ < 0) return Error{path, message("cannot be opened"), foreign(std::strerror(errno))};
  file->size_ = file->committed_ = file->written_ = sizeOf(file->file_);
  if (access == Access::Write) {
    if (const Status s = file->beginJournal(path); !s) return s.error();
  }
  if (access == Access::Read) {
    const int journal = ::open(journalPath(path).c_str(), O_RDONLY | O_CLOEXEC);
    if (journal >= 0) {
      auto left = journalOf(journal);
      if (left && belongsTo(*left, file->file_)) file->pending_ = std::move(*left);
      ::close(journal);
    }
  }
  return file;
}

JournaledFile::~JournaledFile() {
  if (file_ >= 0) ::close(file_);
  if (journalFile_ >= 0) ::close(journalFile_);
}

Status JournaledFile::beginJournal(const std::string& session, JournalOf which) {
  constexpr mode_t kMode = 0666;
  journal_ = journalPath(session);
  journalFile_ = ::open(journal_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
  const bool made = journalFile_ >= 0;
  if (!made && errno == EEXIST) {
    if (which == JournalOf::NewFile) return Error{session, message("is being written already")};
    journalFile_ = ::open(journal_.c_str(), O_RDWR | O_CLOEXEC);
  }
  if (journalFile_ < 0) return Error{journal_, message("cannot be written"), foreign(std::strerror(errno))};
  if (flock(journalFile_, LOCK_EX | LOCK_NB) != 0) return refuseJournal(session, made);
  if (ftruncate(journalFile_, 0) != 0) return refuseJournal(session, made);
  (void)posix_fallocate(journalFile_, 0, kJournalReserve);
  if (!disk_.sync(file_) || fsync(journalFile_) != 0) return refuseJournal(session, made);
  syncFolder(session);
  path_ = session;
  committed_ = size_;
  return Done{};
}

// For the reason in errno.
Status JournaledFile::refuseJournal(const std::string& session, bool made) {
  const int cause = errno;
  if (made) std::remove(journal_.c_str());
  ::close(std::exchange(journalFile_, -1));
  if (cause == EWOULDBLOCK) return Error{session, message("is being written already")};
  if (lacksLocks(cause)) {
    return Error{session, message("this folder has no file locks, without which a recording is not safe (%1)",
                                  foreign(std::strerror(cause)))};
  }
  return Error{session, message("cannot be written"), foreign(std::strerror(cause))};
}

bool JournaledFile::failed(const char* doing) {
  error_ = message("%1: %2 failed (%3)", path_, doing, foreign(std::strerror(errno)));
  return false;
}

bool JournaledFile::failedCutShort() {
  error_ = message("%1 was cut short by another program", path_);
  return false;
}

bool JournaledFile::cutShort() const {
  return sizeOf(file_) < written_;
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
  // A write behind the end would fill with zeros what somebody has taken away.
  if (cutShort()) return failedCutShort();
  if (!disk_.write(file_, offset, bytes)) return failed("writing");
  written_ = std::max(written_, offset + bytes.size());
  return true;
}

void JournaledFile::truncate(std::uint64_t size) {
  if (!abandoned_) size_ = size;
}

Status JournaledFile::commit(bool toDisk) {
  if (abandoned_) return Done{};
  if (cutShort()) return failedCutShort(), Error{{}, error_};
  ++pending_.commit;
  pending_.fileSize = sizeOf(file_);
  if (toDisk && !disk_.sync(file_)) return failed("writing to disk"), Error{{}, error_};
  if (!pending_.overwrites.empty() && journalFile_ >= 0) {
    pending_.sizeAfter = size_;
    pending_.overwrites = merged(pending_.overwrites, file_);
    if (pending_.overwrites.empty()) return failed("reading"), Error{{}, error_};
    const std::vector<std::byte> journal = encodeJournal(pending_);
    if (!disk_.write(journalFile_, 0, journal) || (toDisk && !disk_.sync(journalFile_))) {
      return failed("writing the journal"), Error{{}, error_};
    }
  }
  return apply(toDisk);
}

// From here on a reader of the journal would do the same.
Status JournaledFile::apply(bool toDisk) {
  for (const Overwrite& o : pending_.overwrites) {
    if (!disk_.write(file_, o.offset, o.bytes)) return failed("writing"), Error{{}, error_};
  }
  const bool changed = !pending_.overwrites.empty();
  pending_.overwrites.clear();
  if (sizeOf(file_) != size_ && ftruncate(file_, static_cast<off_t>(size_)) != 0) {
    return failed("setting the length"), Error{{}, error_};
  }
  committed_ = written_ = size_;
  if (changed && toDisk && !disk_.sync(file_)) return failed("writing to disk"), Error{{}, error_};
  return Done{};
}

void JournaledFile::abandon() {
  abandoned_ = true;
  pending_.overwrites.clear();
  size_ = committed_;
}

bool JournaledFile::isAt(const std::string& path) const {
  struct stat mine {};
  struct stat there {};
  return fstat(file_, &mine) == 0 && stat(path.c_str(), &there) == 0 && mine.st_dev == there.st_dev &&
         mine.st_ino == there.st_ino;
}

void JournaledFile::removeJournal() {
  if (journalFile_ < 0) return;
  std::remove(journal_.c_str());
  ::close(std::exchange(journalFile_, -1));
}

Result<Recovery> recoverFromJournal(const std::string& path, const std::function<Status()>& whole) {
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
  if (flock(journal, LOCK_EX | LOCK_NB) != 0) {
    return left(lacksLocks(errno) ? Recovery::NotWritable : Recovery::WriterAlive);
  }
  if (const auto content = journalOf(journal)) {
    if (!belongsTo(*content, file)) return left(Recovery::AnothersJournal);
    if (const Status usable = whole(); !usable) return left(usable.error());
    for (const Overwrite& o : content->overwrites) {
      if (!systemDisk().write(file, o.offset, o.bytes)) {
        return left(Error{path, message("could not be repaired"), foreign(std::strerror(errno))});
      }
    }
    if (fdatasync(file) != 0) return left(Error{path, message("could not be repaired"), foreign(std::strerror(errno))});
  }
  return left(Recovery::Recovered);
}

}  // namespace stillcut::record
