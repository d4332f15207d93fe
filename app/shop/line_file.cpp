#include "app/shop/line_file.h"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <utility>

namespace stillcut::shop {
namespace {

std::uint64_t inodeOf(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? static_cast<std::uint64_t>(status.st_ino) : 0;
}
std::int64_t sizeOf(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 ? static_cast<std::int64_t>(status.st_size) : 0;
}
// What the file begins with, of what was read of it. The same inode may be of another file by now, or of the same one
// begun anew, as `>` does; the first line of a run says when it began.
constexpr std::int64_t kHead = 256;  // bytes
std::string headOf(int file, std::int64_t offset) {
  std::array<char, kHead> bytes{};
  const ssize_t n = ::pread(file, bytes.data(), static_cast<std::size_t>(std::min(offset, kHead)), 0);
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
  for (ssize_t k = 0; k < n; ++k)
    hash = (hash ^ static_cast<unsigned char>(bytes[static_cast<std::size_t>(k)])) * 1099511628211ULL;
  return std::to_string(hash);
}
bool earlier(const timespec& a, const timespec& b) {
  return a.tv_sec != b.tv_sec ? a.tv_sec < b.tv_sec : a.tv_nsec < b.tv_nsec;
}
std::filesystem::path folderOf(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder;
}

}  // namespace

LineFile::LineFile(std::string path, const std::string& cursor) : path_(std::move(path)), standardInput_(path_ == "-") {
  if (standardInput_) {
    file_ = STDIN_FILENO;
    ::fcntl(file_, F_SETFL, ::fcntl(file_, F_GETFL) | O_NONBLOCK);
    return;
  }
  watch_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (watch_ >= 0) ::inotify_add_watch(watch_, folderOf(path_).c_str(), IN_MODIFY | IN_CREATE | IN_MOVED_TO);
  std::istringstream words(cursor);
  std::uint64_t inode = 0;
  std::int64_t offset = 0;
  std::string head;
  if (words >> inode >> offset >> head) goesOn_ = openOld(inode, offset, head);
}

LineFile::~LineFile() {
  if (!standardInput_ && file_ >= 0) ::close(file_);
  if (watch_ >= 0) ::close(watch_);
}

int LineFile::descriptor() const {
  return standardInput_ ? (over_ ? -1 : file_) : watch_;
}

// The file that the cursor speaks of, under whatever name it lies in the folder now.
bool LineFile::openOld(std::uint64_t inode, std::int64_t offset, const std::string& head) {
  std::string found = inodeOf(path_) == inode ? path_ : std::string();
  std::error_code ignored;
  for (auto entry = std::filesystem::directory_iterator(folderOf(path_), ignored);
       found.empty() && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    if (inodeOf(entry->path().string()) == inode) found = entry->path().string();
  }
  if (found.empty()) return false;
  const int file = ::open(found.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  if (offset > sizeOf(file) || headOf(file, offset) != head) {
    ::close(file);
    return false;
  }
  file_ = file;
  inode_ = inode;
  offset_ = offset;
  return true;
}

// Of the files that have had our name, the first that was written after the one that is open; "": there is none.
std::string LineFile::rotatedAfter() const {
  struct stat ours {};
  if (file_ < 0 || ::fstat(file_, &ours) != 0) return {};
  const std::string name = std::filesystem::path(path_).filename().string();
  std::string first;
  timespec firstTime{};
  std::error_code ignored;
  for (auto entry = std::filesystem::directory_iterator(folderOf(path_), ignored);
       entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    const std::string other = entry->path().filename().string();
    const bool hadOurName = other.size() > name.size() + 1 && other.starts_with(name) &&
                            (other[name.size()] == '.' || other[name.size()] == '-');
    const std::string end = entry->path().extension().string();
    if (!hadOurName || end == ".gz" || end == ".xz" || end == ".bz2" || end == ".zst") continue;
    struct stat status {};
    if (::stat(entry->path().c_str(), &status) != 0 || !S_ISREG(status.st_mode) || status.st_ino == ours.st_ino)
      continue;
    if (!earlier(ours.st_mtim, status.st_mtim) || (!first.empty() && !earlier(status.st_mtim, firstTime))) continue;
    first = entry->path().string();
    firstTime = status.st_mtim;
  }
  return first;
}

bool LineFile::openNew() {
  if (const std::uint64_t now = inodeOf(path_); now == 0 || (file_ >= 0 && now == inode_)) return false;
  const std::string between = rotatedAfter();
  const std::string& next = between.empty() ? path_ : between;
  const std::uint64_t inode = inodeOf(next);
  const int file = ::open(next.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  if (file_ >= 0) ::close(file_);
  file_ = file;
  inode_ = inode;
  offset_ = headAt_ = 0;
  buffer_.clear();
  searched_ = 0;
  skipping_ = false;
  return true;
}

// False: nothing more is there now.
bool LineFile::fill() {
  if (file_ < 0) return false;
  if (!standardInput_ && sizeOf(file_) < offset_ + static_cast<std::int64_t>(buffer_.size())) {
    offset_ = headAt_ = 0;  // cut short and begun anew, as `>` does
    buffer_.clear();
    searched_ = 0;
  }
  char bytes[65536];
  const ssize_t n = standardInput_ ? ::read(file_, bytes, sizeof bytes)
                                   : ::pread(file_, bytes, sizeof bytes,
                                             static_cast<off_t>(offset_ + static_cast<std::int64_t>(buffer_.size())));
  if (n == 0 && standardInput_) {
    over_ = true;
    if (!buffer_.empty()) buffer_.push_back('\n');
    return !buffer_.empty();
  }
  if (n <= 0) return false;
  buffer_.append(bytes, static_cast<std::size_t>(n));
  return true;
}

std::string LineFile::cursor() {
  if (standardInput_) return {};
  if (headAt_ < kHead) {
    headAt_ = offset_;
    head_ = headOf(file_, offset_);
  }
  return std::to_string(inode_) + " " + std::to_string(offset_) + " " + head_;
}

void LineFile::takeLines(std::vector<SourceLine>& lines, std::size_t atMost) {
  std::size_t begin = 0;
  while (lines.size() < atMost) {
    const std::size_t end = buffer_.find('\n', std::max(begin, searched_));
    if (end == std::string::npos) {
      searched_ = buffer_.size();
      break;
    }
    offset_ += static_cast<std::int64_t>(end + 1 - begin);
    if (!std::exchange(skipping_, false) && end > begin)
      lines.push_back({buffer_.substr(begin, end - begin), cursor()});
    begin = end + 1;
    searched_ = begin;
  }
  buffer_.erase(0, begin);
  searched_ -= std::min(begin, searched_);
  if (buffer_.size() > kLongestLine && searched_ == buffer_.size()) {
    offset_ += static_cast<std::int64_t>(buffer_.size());
    buffer_.clear();
    searched_ = 0;
    skipping_ = true;
  }
}

Result<std::vector<SourceLine>> LineFile::read(std::size_t atMost) {
  if (watch_ >= 0) {
    char events[4096];
    while (::read(watch_, events, sizeof events) > 0) {
    }
  }
  std::vector<SourceLine> lines;
  takeLines(lines, atMost);
  while (lines.size() < atMost) {
    if (!fill() && !(!standardInput_ && openNew())) break;
    takeLines(lines, atMost);
  }
  idle_ = lines.empty();
  return lines;
}

}  // namespace stillcut::shop
