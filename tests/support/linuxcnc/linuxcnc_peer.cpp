#include "tests/support/linuxcnc/linuxcnc_peer.h"

#include <fcntl.h>
#include <grp.h>
#include <sys/shm.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "app/io/tcp_wire.h"
#include "tests/support/bounded_wait.h"

namespace stillcut::cnc::testing {
namespace fs = std::filesystem;
namespace {

constexpr uid_t kNobody = 65534;  // LinuxCNC refuses root
constexpr Duration kStep = std::chrono::milliseconds(20);

bool onPath(const char* program) {
  for (const char* folder : {"/usr/bin/", "/usr/local/bin/"}) {
    if (::access((std::string(folder) + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::unique_ptr<ByteChannel> wireTo(int port) {
  return std::move(app::TcpWire::make("127.0.0.1", port)).value();
}

bool answers(int port, int tries) {
  const auto wire = wireTo(port);
  for (int i = 0; i < tries; ++i) {
    if (wire->state() == WireState::Closed) wire->connect();
    if (wire->state() == WireState::Open) return true;
    wire->wait(kStep);
  }
  return false;
}

}  // namespace

LinuxCncPeer::LinuxCncPeer(Overrides overrides) {
  const fs::path shared = fs::path(STILLCUT_SHARED_DIR) / "peers/linuxcnc";
  if (!fs::exists(shared)) {
    why_ = "the shared LinuxCNC mill is not here";
  } else if (!onPath("linuxcnc") || !onPath("linuxcncrsh") || !onPath("halrmt")) {
    why_ = "LinuxCNC is not installed (package linuxcnc-uspace)";
  } else if (answers(kPort, 1)) {
    why_ = "port 5007 is taken: another LinuxCNC is running";
  }
  if (!ok()) return;
  std::string name = (fs::temp_directory_path() / "stillcut-linuxcnc-XXXXXX").string();
  folder_ = ::mkdtemp(name.data());
  for (const auto& entry : fs::directory_iterator(shared)) fs::copy(entry.path(), folder_ / entry.path().filename());
  if (overrides == Overrides::Component) addComponent();
  if (::getuid() == 0) {
    if (::chown(folder_.c_str(), kNobody, kNobody) != 0) why_ = "the mill's folder cannot be handed over";
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (::chown(entry.path().c_str(), kNobody, kNobody) != 0) why_ = "the mill's files cannot be handed over";
    }
  }
  if (ok()) start();
}

void LinuxCncPeer::addComponent() {
#ifdef STILLCUT_HAL_PROGRAM
  fs::copy(STILLCUT_HAL_PROGRAM, folder_ / "stillcut-hal");
  for (const char* file : {"stillcut.hal", "stillcut-status"})
    fs::copy(STILLCUT_SOURCE_DIR "/packaging/linuxcnc/" + std::string(file), folder_ / file);
  std::ifstream in(folder_ / "sim.ini");
  std::string ini((std::istreambuf_iterator<char>(in)), {});
  const std::string last = "HALFILE = chatter-extra.hal\n";
  const std::size_t place = ini.find(last);
  if (place == std::string::npos) {
    why_ = "the shared mill's sim.ini is another";
    return;
  }
  ini.insert(place + last.size(), "HALFILE = stillcut.hal\n");
  fs::remove(folder_ / "sim.ini");
  std::ofstream(folder_ / "sim.ini") << ini;
#else
  why_ = "stillcut-hal is not built (package linuxcnc-uspace-dev)";
#endif
}

pid_t LinuxCncPeer::process(const std::string& wanted) const {
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator("/proc", gone)) {
    std::ifstream comm(entry.path() / "comm");
    std::string name;
    if (!std::getline(comm, name) || name != wanted) continue;
    const auto pid = static_cast<pid_t>(std::stol(entry.path().filename().string()));
    if (::getsid(pid) == machine_) return pid;  // ours, and nobody else's
  }
  return -1;
}

LinuxCncPeer::~LinuxCncPeer() {
  end();
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

pid_t LinuxCncPeer::spawn(const std::vector<std::string>& words, const char* log) const {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::setsid();
  const std::string path = (folder_ / log).string();
  if (::getuid() == 0 && (::setgroups(0, nullptr) != 0 || ::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)) ::_exit(1);
  if (::chdir(folder_.c_str()) != 0) ::_exit(1);
  const int out = ::open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0644);
  ::dup2(out, 1);
  ::dup2(out, 2);
  ::setenv("HOME", folder_.c_str(), 1);
  ::setenv("USER", "nobody", 1);
  ::setenv("PATH", (folder_.string() + ":" + std::getenv("PATH")).c_str(), 1);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& w : words) arguments.push_back(const_cast<char*>(w.c_str()));
  arguments.push_back(nullptr);
  ::execvp(arguments[0], arguments.data());
  ::_exit(127);
}

void LinuxCncPeer::start() {
  removeDeadMemory();
  machine_ = spawn({"linuxcnc", "-r", "sim.ini"}, "machine.log");
  if (!answers(kPort, 1500)) {
    why_ = "LinuxCNC does not start here (machine.log)";
    return;
  }
  hal_ = spawn({"halrmt", "--", "-ini", "sim.ini"}, "halrmt.log");
  if (!answers(kHalPort, 500)) why_ = "halrmt does not start here";
}

void LinuxCncPeer::end() {
  if (hal_ > 0) {
    ::kill(hal_, SIGKILL);
    ::waitpid(hal_, nullptr, 0);
    hal_ = -1;
  }
  if (machine_ <= 0) return;
  // The whole group: its script then cleans up after the servers that have gone.
  ::kill(-machine_, SIGTERM);
  const bool byItself = within(Seconds(10.0), [&] { return ::waitpid(machine_, nullptr, WNOHANG) == machine_; });
  if (!byItself) {
    ::kill(-machine_, SIGKILL);
    ::waitpid(machine_, nullptr, 0);
  }
  machine_ = -1;
  leaveNothing();
}

// What was started here, and nothing else, works in our folder: rtapi_app has a session of its own.
std::vector<pid_t> LinuxCncPeer::ours() const {
  std::vector<pid_t> all;
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator("/proc", gone)) {
    std::error_code unreadable;
    const fs::path at = fs::read_symlink(entry.path() / "cwd", unreadable);
    if (!unreadable && at == folder_) all.push_back(static_cast<pid_t>(std::stol(entry.path().filename().string())));
  }
  return all;
}

// As LinuxCNC's own script does it, where that was killed before it could.
void LinuxCncPeer::leaveNothing() const {
  for (const int signal : {SIGTERM, SIGKILL}) {
    for (const pid_t pid : ours()) ::kill(pid, signal);
    if (within(Seconds(3.0), [&] { return ours().empty(); })) break;
  }
  removeDeadMemory();
  if (!answers(kPort, 1)) {
    std::error_code ignored;
    fs::remove("/tmp/linuxcnc.lock", ignored);
  }
}

// A machine that begins in the memory of one that died takes its old serial numbers for answers and its components for
// its own, and does not come up. Memory that nobody is attached to belongs to no machine that lives.
void LinuxCncPeer::removeDeadMemory() {
  // Those of linuxcnc.nml; motion's; HAL's, and what its simulator knows itself by (hal_priv.h, uspace_rtapi_app.cc).
  constexpr std::array<long, 8> kKeys{1001, 1002, 1003, 1004, 1005, 100, 0x48414C32, 0x48484C34};
  std::ifstream segments("/proc/sysvipc/shm");
  std::string line;
  std::getline(segments, line);  // the heading
  while (std::getline(segments, line)) {
    long key = 0, id = 0, mode = 0, size = 0, creator = 0, last = 0, attached = 0;
    std::istringstream(line) >> key >> id >> mode >> size >> creator >> last >> attached;
    const bool known = std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
    if (known && attached == 0) ::shmctl(static_cast<int>(id), IPC_RMID, nullptr);
  }
}

std::string LinuxCncPeer::talk(const std::vector<std::string>& requests) {
  const auto wire = wireTo(kPort);
  std::string all;
  const auto hear = [&] {
    std::string reply;
    std::array<char, 512> bytes;
    for (int i = 0; i < 25 && reply.find('\n') == std::string::npos; ++i) {
      wire->wait(kStep);
      while (const std::size_t n = wire->read(bytes)) reply.append(bytes.data(), n);
    }
    all += reply;
  };
  for (int i = 0; i < 50 && wire->state() != WireState::Open; ++i) {
    if (wire->state() == WireState::Closed) wire->connect();
    wire->wait(kStep);
  }
  std::vector<std::string> lines{"hello EMC tester 1.0", "set echo off", "set verbose on"};
  lines.insert(lines.end(), requests.begin(), requests.end());
  for (const std::string& line : lines) {
    if (!wire->write(line + "\r\n")) break;
    hear();
  }
  return all;
}

void LinuxCncPeer::write(const std::string& program, const std::string& text) const {
  std::ofstream(folder_ / program) << text;
}

std::string LinuxCncPeer::locking(const std::string& word) const {
  write("locking.ngc", "G21 G90 G94 G17\n" + word + "\nS5000 M3\nG0 X-900\nG1 X900 F600\nM48\nM5\nM2\n");
  return "locking.ngc";
}

// Each step has its effect some time after its ACK, so the sequence is repeated until the program is seen running.
void LinuxCncPeer::run(const std::string& program) {
  const std::vector<std::string> take{"set enable EMCTOO", "set set_wait received", "set estop off", "set machine on"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), take.begin(), take.end());
    return talk(more);
  };
  with({"set abort"});
  for (int i = 0; i < 20; ++i) {
    if (talk({"get joint_homed 0"}).find("YES") != std::string::npos) break;
    with({"set mode manual", "set home -1"});
  }
  for (int i = 0; i < 20; ++i) {
    with({"set mode auto", "set feed_override 100", "set spindle_override 0 100",
          "set open " + (folder_ / program).string(), "set run"});
    // Looked at for half a second: "set run" twice would begin the program anew.
    const std::vector<std::string> look(10, "get program_status");
    if (talk(look).find("RUNNING") != std::string::npos) break;
  }
  talk({"set enable EMCTOO", "set enable off"});
}

}  // namespace stillcut::cnc::testing
