// The real LinuxCNC: a headless mill from the shared material, started as an ordinary user and ended with the test.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stillcut::cnc::testing {

class LinuxCncPeer {
 public:
  enum class Overrides : std::uint8_t { Rsh, Component };
  // Starts the machine and waits until it answers. ok() false: why() says what is absent.
  // Component: with stillcut-hal and packaging/linuxcnc/stillcut.hal.
  explicit LinuxCncPeer(Overrides overrides = Overrides::Rsh);
  ~LinuxCncPeer();
  LinuxCncPeer(const LinuxCncPeer&) = delete;
  LinuxCncPeer& operator=(const LinuxCncPeer&) = delete;

  static constexpr int kPort = 5007, kHalPort = 5006, kComponentPort = 5008, kStatusPort = 5009;

  bool ok() const { return why_.empty(); }
  const std::string& why() const { return why_; }
  void start();
  // Asks it to end, as a person would, and kills it where it has not after 10 s. What it left behind is cleaned up.
  void end();

  // A file of the machine's folder.
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  // A program of one's own, into the machine's folder.
  void write(const std::string& program, const std::string& text) const;
  // A long cut at S5000 F600 that begins with `word`; its name.
  std::string locking(const std::string& word) const;
  // Machine on and homed, `program` of its folder running from the beginning, overrides at 100 %.
  void run(const std::string& program);
  // The process of that name ("stillcut-hal", "linuxcncrsh") that the machine has started; -1: none.
  pid_t process(const std::string& name) const;
  // Requests to linuxcncrsh as another client sends them; the replies.
  static std::string talk(const std::vector<std::string>& requests);

 private:
  void addComponent();
  std::vector<pid_t> ours() const;
  void leaveNothing() const;
  static void removeDeadMemory();
  pid_t spawn(const std::vector<std::string>& words, const char* log) const;

  std::filesystem::path folder_;
  std::string why_;
  pid_t machine_ = -1, hal_ = -1;
};

}  // namespace stillcut::cnc::testing
