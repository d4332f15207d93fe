#include "core/formats/hdf5/isolated_reader.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <span>
#include <utility>

#include "core/formats/hdf5/isolated_messages.h"

extern char** environ;

namespace stillcut::record {
namespace {

namespace fs = std::filesystem;
using apart::MessageType;

// Beside this program, where a package puts it, or where the build has made it.
std::string readerProgram() {
  std::error_code none;
  const fs::path here = fs::read_symlink("/proc/self/exe", none).parent_path();
  for (const fs::path& candidate :
       {here / "stillcut-reader", here.parent_path() / "libexec/stillcut/stillcut-reader", fs::path(STILLCUT_READER)}) {
    if (::access(candidate.c_str(), X_OK) == 0) return candidate.string();
  }
  return {};
}

// Owns the process and this end of its socket.
class Apart {
 public:
  Apart() = default;
  ~Apart() {
    if (peer_ >= 0) ::close(peer_);
    if (child_ > 0) {
      ::kill(child_, SIGKILL);
      while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
  }
  Apart(const Apart&) = delete;
  Apart& operator=(const Apart&) = delete;

  Status start(const std::string& path, const std::string& inner, const ReadOptions& options) {
    const std::string program = readerProgram();
    if (program.empty())
      return Error{path, message("cannot be tried"), message("the program stillcut-reader is missing beside this one")};
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      return Error{path, message("cannot be tried"), foreign(std::strerror(errno))};
    }
    peer_ = ends[0];
    const int started = spawn(program, path, inner, apart::toJson(options), ends[1]);
    ::close(ends[1]);
    if (started != 0)
      return Error{path, message("cannot be tried: %1 does not start", program), foreign(std::strerror(started))};
    return Done{};
  }
  int peer() const { return peer_; }

 private:
  int spawn(const std::string& program, const std::string& path, const std::string& inner, std::string options,
            int theirs) {
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
    std::array<std::string, 4> words{program, path, inner, std::move(options)};
    std::array<char*, 5> arguments{words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    const int started = ::posix_spawn(&child_, program.c_str(), &files, &how, arguments.data(), environ);
    ::posix_spawnattr_destroy(&how);
    ::posix_spawn_file_actions_destroy(&files);
    if (started != 0) child_ = -1;
    return started;
  }

  int peer_ = -1;
  pid_t child_ = -1;
};

Error died(const std::string& path) {
  return Error{path, message("the HDF5 library cannot read it"), message("a damaged file")};
}

Result<std::pair<MessageType, std::string>> hear(int peer, const std::string& path) {
  apart::MessageHeader head;
  if (!apart::receive(peer, std::as_writable_bytes(std::span(&head, 1)))) return died(path);
  std::string bytes(head.bytes, '\0');
  if (!apart::receive(peer, std::as_writable_bytes(std::span(bytes)))) return died(path);
  return std::pair(head.word, std::move(bytes));
}

class IsolatedReader final : public RecordingReader {
 public:
  IsolatedReader(std::string path, std::unique_ptr<Apart> apart, RecordingFormat format)
      : path_(std::move(path)), apart_(std::move(apart)), format_(std::move(format)) {}

  const RecordingFormat& format() const override { return format_; }

  Result<bool> read(SampleBlock& block) override {
    if (ended_) return false;
    const std::int32_t capacity = block.capacityFrames;
    if (!apart::send(apart_->peer(), std::as_bytes(std::span(&capacity, 1)))) return died(path_);
    const auto heard = hear(apart_->peer(), path_);
    if (!heard) return heard.error();
    const auto& [word, bytes] = *heard;
    if (word == MessageType::Refused) return apart::errorFrom(bytes);
    ended_ = word == MessageType::End;
    if (ended_) return false;
    return take(block, bytes) ? Result<bool>(true) : died(path_);
  }

 private:
  bool take(SampleBlock& block, const std::string& bytes) const {
    apart::BlockHead head;
    if (bytes.size() < sizeof head) return false;
    std::memcpy(&head, bytes.data(), sizeof head);
    const auto frames = static_cast<std::size_t>(head.frames);
    if (head.frames < 1 || head.frames > block.capacityFrames ||
        bytes.size() != sizeof head + frames * format_.channels.size() * sizeof(float)) {
      return false;
    }
    block.sequence = head.sequence;
    block.lostFrames = head.lostFrames;
    block.firstSample = instantFromNs(head.firstSample_ns);
    block.frames = head.frames;
    block.flags = head.flags;
    block.rate = format_.rate;
    const char* from = bytes.data() + sizeof head;
    for (int c = 0; c < block.channels; ++c, from += frames * sizeof(float)) {
      std::memcpy(block.channel(c).data(), from, frames * sizeof(float));
    }
    return true;
  }

  std::string path_;
  std::unique_ptr<Apart> apart_;
  RecordingFormat format_;
  bool ended_ = false;
};

}  // namespace

Result<std::unique_ptr<RecordingReader>> openIsolated(const std::string& path, const std::string& inner,
                                                      const ReadOptions& options) {
  auto process = std::make_unique<Apart>();
  if (const Status started = process->start(path, inner, options); !started) return started.error();
  const auto heard = hear(process->peer(), path);
  if (!heard) return heard.error();
  const auto& [word, bytes] = *heard;
  if (word == MessageType::Session) return std::unique_ptr<RecordingReader>();
  if (word == MessageType::Refused) return apart::errorFrom(bytes);
  return std::unique_ptr<RecordingReader>(new IsolatedReader(path, std::move(process), apart::formatFrom(bytes)));
}

}  // namespace stillcut::record
