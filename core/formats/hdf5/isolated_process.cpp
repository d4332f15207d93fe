#include "core/formats/hdf5/isolated_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <span>

extern char** environ;

namespace stillcut::record {
namespace {

namespace fs = std::filesystem;

// Beside this program, where a package puts it, or where the build has made it.
std::string placeOf(const std::string& name) {
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (const fs::path& candidate :
       {here / name, here.parent_path() / "libexec/stillcut" / name, fs::path(STILLCUT_READER).parent_path() / name}) {
    if (::access(candidate.c_str(), X_OK) == 0) return candidate.string();
  }
  return {};
}

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
  const std::string program = placeOf(program_.name);
  if (program.empty()) return Error{path, program_.missing, program_.remedy};
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return Error{path, message("cannot be tried"), foreign(std::strerror(errno))};
  }
  peer_ = ends[0];
  const int started = spawn(program, inner, options, ends[1]);
  ::close(ends[1]);
  if (started != 0)
    return Error{path, message("cannot be tried: %1 does not start", program), foreign(std::strerror(started))};
  return Done{};
}

int IsolatedProcess::spawn(const std::string& program, const std::string& inner, std::string options, int theirs) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t how;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawnattr_init(&how);
  constexpr int kNull = STDERR_FILENO + 1;
  ::posix_spawn_file_actions_adddup2(&files, theirs, STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
  ::posix_spawn_file_actions_addclosefrom_np(&files, kNull);
  sigset_t all;
  sigset_t none;
  ::sigfillset(&all);
  ::sigemptyset(&none);
  ::posix_spawnattr_setsigdefault(&how, &all);
  ::posix_spawnattr_setsigmask(&how, &none);
  const sched_param ordinary{};
  ::posix_spawnattr_setschedparam(&how, &ordinary);
  ::posix_spawnattr_setschedpolicy(&how, SCHED_OTHER);
  ::posix_spawnattr_setflags(
      &how, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSCHEDULER | POSIX_SPAWN_SETSCHEDPARAM);
  std::array<std::string, 4> words{program, path_, inner, std::move(options)};
  std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
  const int started = ::posix_spawn(&child_, program.c_str(), &files, &how, arguments.data(), environ);
  ::posix_spawnattr_destroy(&how);
  ::posix_spawn_file_actions_destroy(&files);
  if (started != 0) child_ = -1;
  return started;
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
