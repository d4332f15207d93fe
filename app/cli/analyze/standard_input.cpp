#include "app/cli/analyze/standard_input.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace stillcut::app {
namespace {

Error failed(const Message& what) {
  return {message("standard input"), what, foreign(std::strerror(errno))};
}

Status writeAll(int file, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(file, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return failed(message("cannot be kept in the folder of temporary files"));
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
  return Done{};
}

}  // namespace

// The file loses its name at once and is read through its descriptor, so that it cannot be left behind.
Result<StandardInput> StandardInput::keep() {
  std::error_code problem;
  std::string name = (std::filesystem::temp_directory_path(problem) / "stillcut-XXXXXX").string();
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) return failed(message("cannot be kept in the folder of temporary files"));
  ::unlink(name.c_str());
  // By this process, since HDF5 files are read in another one.
  StandardInput kept("/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(file), file);
  std::array<char, 1 << 16> buffer{};
  std::size_t all = 0;
  for (;;) {
    const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failed(message("cannot be read"));
    if (got == 0) break;
    all += static_cast<std::size_t>(got);
    if (const Status s = writeAll(file, buffer.data(), static_cast<std::size_t>(got)); !s) return s.error();
  }
  if (all == 0) return Error{message("standard input"), message("is empty")};
  return kept;
}

StandardInput::~StandardInput() {
  if (file_ >= 0) ::close(file_);
}

StandardInput::StandardInput(StandardInput&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

}  // namespace stillcut::app
