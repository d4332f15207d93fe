#include "core/storage/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace stillcut {
namespace {

bool writeAll(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(fd, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(n));
  }
  return ::fsync(fd) == 0;
}

}  // namespace

Status writeFileAtomically(const std::filesystem::path& path, std::string_view content) {
  const auto fail = [&](int code) {
    return Error{path.string(), message("cannot be written"), foreign(std::strerror(code))};
  };
  std::string temporary = path.string() + ".XXXXXX";
  const int fd = ::mkstemp(temporary.data());
  if (fd < 0) return fail(errno);
  ::fchmod(fd, 0644);
  const bool written = writeAll(fd, content);
  const int writeError = errno;
  ::close(fd);
  if (written && ::rename(temporary.c_str(), path.c_str()) == 0) return Done{};
  const int code = written ? errno : writeError;
  ::unlink(temporary.c_str());
  return fail(code);
}

}  // namespace stillcut
