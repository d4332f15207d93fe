#include "core/storage/part_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace stillcut {

// A name of its own: two programs may write the same file at once, and the last one to finish is what stays.
PartFile::PartFile(std::string path) : path_(std::move(path)), part_(path_ + ".XXXXXX") {
  const int fd = ::mkstemp(part_.data());
  if (fd >= 0) {
    ::fchmod(fd, 0644);
    file_ = ::fdopen(fd, "wb");
  }
  if (file_ == nullptr) problem_ = errno;
}

PartFile::~PartFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  std::remove(part_.c_str());
}

void PartFile::writeAt(std::uint64_t position, std::string_view bytes) {
  if (position != position_ && fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0 && problem_ == 0) {
    problem_ = errno;
  }
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size() && problem_ == 0) problem_ = errno;
  position_ = position + bytes.size();
}

Error PartFile::failure() const {
  return Error{path_, message("cannot be written"), problem_ != 0 ? foreign(std::strerror(problem_)) : Message()};
}

Status PartFile::finish() {
  if (std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0) problem_ = problem_ != 0 ? problem_ : errno;
  const bool written = std::ferror(file_) == 0 && problem_ == 0;
  const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
  if (problem_ == 0 && !closed) problem_ = errno;
  if (written && closed && std::rename(part_.c_str(), path_.c_str()) == 0) return Done{};
  if (problem_ == 0) problem_ = errno;
  std::remove(part_.c_str());
  return failure();
}

}  // namespace stillcut
