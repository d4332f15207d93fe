#include "app/io/one_program_link.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

namespace stillcut::app {
namespace {

// A killed program's keeper needs some 0.1 s; one whose machine does not answer goes on for longer than anybody waits.
constexpr int kLooks = 100, kLook_ms = 20;

std::string nameOf(const WireAddress& address) {
  std::string host = address.host == "localhost" || address.host == "::1" ? "127.0.0.1" : address.host;
  return address.device.empty() ? host + ":" + std::to_string(address.port) : address.device;
}

// A port has several names, and one lock.
std::string fileOf(const std::string& wire) {
  std::error_code absent;
  const std::string port = wire.starts_with('/') ? std::filesystem::canonical(wire, absent).string() : wire;
  std::string file = "stillcut-";
  for (const char c : port.empty() ? wire : port)
    file += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ? c : '-';
  return file + ".lock";
}

// One lock, held by an open file.
class Lock {
 public:
  Lock(const std::string& path, int owner) {
    file_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (file_ < 0 && errno == ENOENT) {
      file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
      if (file_ >= 0) ::fchmod(file_, 0666);  // another user's program asks as well
    }
    taken_ = file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) == 0;
    // A file system without locks refuses everybody: no other program holds it there.
    if (file_ >= 0 && !taken_ && errno != EWOULDBLOCK) ::close(std::exchange(file_, -1));
    if (taken_ && ::ftruncate(file_, 0) == 0) {
      const std::string process = std::to_string(owner);
      (void)!::pwrite(file_, process.data(), process.size(), 0);
    }
  }
  Lock(Lock&& other) noexcept : file_(std::exchange(other.file_, -1)), taken_(other.taken_) {}
  Lock& operator=(Lock&&) = delete;
  ~Lock() {
    if (file_ >= 0) ::close(file_);
  }
  bool opened() const { return file_ >= 0; }
  bool taken() const { return taken_; }
  std::string holder() const {
    char process[16] = {};
    return ::pread(file_, process, sizeof process - 1, 0) > 0 ? process : "?";
  }
  bool holderHasDied() const {
    const int process = std::atoi(holder().c_str());
    return process > 0 && ::kill(process, 0) != 0 && errno == ESRCH;
  }

 private:
  int file_ = -1;
  bool taken_ = false;
};

// Each once, whatever its names: a second lock on one file would be refused by the first.
std::vector<std::string> lockFolders() {
  std::vector<std::string> folders;
  const auto add = [&folders](const char* folder) {
    std::error_code absent;
    const auto same = [&](const std::string& f) { return std::filesystem::equivalent(f, folder, absent); };
    if (folder == nullptr || *folder == '\0' || std::any_of(folders.begin(), folders.end(), same)) return;
    folders.emplace_back(folder);
  };
  add("/run/lock");
  add(std::getenv("XDG_RUNTIME_DIR"));
  add("/tmp");
  return folders;
}

class OneProgramLink final : public cnc::CncLink {
 public:
  OneProgramLink(std::unique_ptr<cnc::CncLink> link, std::vector<std::string> wires, std::vector<std::string> folders,
                 int owner)
      : link_(std::move(link)), wires_(std::move(wires)), folders_(std::move(folders)), owner_(owner) {}

  cnc::LinkInfo describe() const override { return link_->describe(); }
  Status open() override {
    if (Status held = hold(); !held) return held;
    return link_->open();
  }
  MachineState read(Instant now) noexcept override { return link_->read(now); }
  void apply(const OverrideCommand& command, Instant now) noexcept override { link_->apply(command, now); }
  void release(Instant now) noexcept override { link_->release(now); }
  void adopt(std::optional<Ratio> speed, std::optional<Ratio> feed) noexcept override { link_->adopt(speed, feed); }
  void close() noexcept override {
    link_->close();
    held_.clear();
  }

 private:
  // A holder who has died: his keeper is bringing the machine home, and lets go soon.
  Lock lockOnce(const std::string& path) const {
    for (int look = 0;; ++look) {
      Lock lock(path, owner_);
      if (!lock.opened() || lock.taken() || look == kLooks || !lock.holderHasDied()) return lock;
      ::poll(nullptr, 0, kLook_ms);
    }
  }
  Status hold() {
    held_.clear();
    for (const std::string& wire : wires_) {
      for (const std::string& folder : folders_) {
        Lock lock = lockOnce(folder + "/" + fileOf(wire));
        if (!lock.opened()) continue;
        if (!lock.taken() && lock.holder() == std::to_string(owner_)) {
          return Error{wire, message("the run that is going on holds this machine"),
                       message("its state is on the page Operate; to try the link, end the run first")};
        }
        if (!lock.taken()) {
          return Error{wire, message("another Stillcut holds this machine (process %1)", lock.holder()),
                       message("end that one, or watch here without a machine link")};
        }
        // In every folder that there is: programs of another session or user may not have all of them.
        held_.push_back(std::move(lock));
      }
    }
    return Done{};
  }

  std::unique_ptr<cnc::CncLink> link_;
  std::vector<std::string> wires_, folders_;
  int owner_;
  std::vector<Lock> held_;
};

}  // namespace

Result<std::unique_ptr<cnc::CncLink>> makeOneProgramLink(std::string_view id, cnc::LinkRequest request,
                                                         const std::string& locks, int owner) {
  auto wires = std::make_shared<std::vector<std::string>>();
  const auto note = [wires](const WireAddress& address) {
    const std::string name = nameOf(address);
    if (std::find(wires->begin(), wires->end(), name) == wires->end()) wires->push_back(name);
  };
  if (request.wires) {
    request.wires = [note, make = std::move(request.wires)](const WireAddress& address) {
      note(address);
      return make(address);
    };
  }
  if (request.buses) {
    request.buses = [note, make = std::move(request.buses)](const cnc::BusAddress& address, const Clock& clock) {
      note(address.wire);
      return make(address, clock);
    };
  }
  auto link = cnc::makeLink(id, request);
  if (!link || wires->empty()) return link;
  auto folders = locks.empty() ? lockFolders() : std::vector<std::string>{locks};
  return std::unique_ptr<cnc::CncLink>(std::make_unique<OneProgramLink>(
      std::move(link).value(), std::move(*wires), std::move(folders), owner != 0 ? owner : ::getpid()));
}

}  // namespace stillcut::app
