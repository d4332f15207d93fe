#include "tests/component/cli/program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "tests/support/temp_folder.h"

extern char** environ;

namespace stillcut::cli_test {
namespace {

constexpr int kPatience = 240'000;  // [ms], far beyond any of these runs: only a program that hangs meets it

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Exit code of `pid`, which is killed when it does not end in time.
int await(pid_t pid) {
  // Not through <sys/pidfd.h>: glibc 2.36 declares it as a C++ function.
  const auto handle = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  pollfd waiting{handle, POLLIN, 0};
  if (handle < 0 || poll(&waiting, 1, kPatience) != 1) kill(pid, SIGKILL);
  if (handle >= 0) close(handle);
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

std::string spelled(const std::vector<std::string>& arguments) {
  std::string line = "stillcut-cli";
  for (const std::string& a : arguments) line += " " + a;
  return line;
}

Outcome runCli(const std::string& where, const std::vector<std::string>& arguments) {
  const record::TempFolder streams;
  const std::string out = streams / "out";
  const std::string err = streams / "err";
  std::vector<char*> argv{const_cast<char*>(STILLCUT_CLI)};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, where.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT, 0600);
  pid_t pid = 0;
  const int started = posix_spawn(&pid, STILLCUT_CLI, &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (started != 0) return {};
  const int exitCode = await(pid);
  return {exitCode, contentOf(out), contentOf(err)};
}

}  // namespace stillcut::cli_test
