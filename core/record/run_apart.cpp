#include "core/record/run_apart.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>

namespace stillcut::record {
namespace {

[[noreturn]] void beChild(const std::function<int()>& work, Seconds limit) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTERM, SIGINT, SIGALRM}) {
    std::signal(signal, SIG_DFL);
  }
  const rlimit noCore{0, 0};
  setrlimit(RLIMIT_CORE, &noCore);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  constexpr rlim_t kMost = rlim_t{4} << 30U;
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur > kMost) {
    memory.rlim_cur = kMost;
    setrlimit(RLIMIT_AS, &memory);
  }
#endif
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  alarm(static_cast<unsigned>(std::ceil(limit.value)));
  _exit(work());  // no destructors: what the parent has open stays its own
}

}  // namespace

std::optional<int> runApart(const std::function<int()>& work, Seconds limit) {
  const pid_t child = fork();
  if (child < 0) return 0;
  if (child == 0) beChild(work, limit);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return 0;
  }
  constexpr int kMostResult = 99;
  if (!WIFEXITED(status) || WEXITSTATUS(status) > kMostResult) return std::nullopt;
  return WEXITSTATUS(status);
}

}  // namespace stillcut::record
