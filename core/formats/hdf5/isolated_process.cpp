#include "core/formats/hdf5/isolated_process.h"

#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <span>

#include "core/base/program_place.h"
#include "core/base/start_program.h"

namespace stillcut::record {
namespace {

namespace fs = std::filesystem;

Status checkRegular(const std::string& path) {
  std::error_code problem;
  const fs::file_status status = fs::status(path, problem);
  if (!fs::exists(status)) return Error{path, message("there is no such file")};
  if (!fs::is_regular_file(status)) return Error{path, message("is not a regular file")};
  return Done{};
}

}  // namespace

IsolatedProcess::~IsolatedProcess() {
  if (peer_ >= 0) ::close(peer_);
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

Status IsolatedProcess::start(const std::string& path, const std::string& inner, const std::string& options) {
  path_ = path;
  if (Status regular = checkRegular(path); !regular) return regular;
  const fs::path built = fs::path(STILLCUT_READER).parent_path() / program_.name;
  const std::string program = programPlace(program_.name, built.string());
  if (program.empty()) return Error{path, program_.missing, program_.remedy};
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return Error{path, message("cannot be tried"), foreign(std::strerror(errno))};
  }
  peer_ = ends[0];
  const int started = startProgram({{program, path_, inner, options}, ends[1]}, child_);
  ::close(ends[1]);
  if (started != 0)
    return Error{path, message("cannot be tried: %1 does not start", program), foreign(std::strerror(started))};
  return Done{};
}

Error IsolatedProcess::died() const {
  return Error{path_, program_.died, message("a damaged file")};
}

Result<std::pair<apart::MessageType, std::string>> IsolatedProcess::hear() const {
  apart::MessageHeader head;
  if (!apart::receive(peer_, std::as_writable_bytes(std::span(&head, 1)))) return died();
  if (head.bytes > apart::kLongestMessage) return died();
  std::string bytes(head.bytes, '\0');
  if (!apart::receive(peer_, std::as_writable_bytes(std::span(bytes)))) return died();
  return std::pair(head.word, std::move(bytes));
}

}  // namespace stillcut::record
