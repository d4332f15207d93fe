// LineServer: a few TCP clients, lines in, lines out. One more than there is room for is turned away, unless one of
// those has said nothing for a while: its cable may have been pulled. Of this computer's programs only those of one
// user are heard, and root's; the others are hung up on at once and take nobody's place. Another computer has no users
// that could be told apart: it is heard where the server listens on a network at all.
// Thread: one. Nothing throws after listen(); memory is bounded.
#pragma once

#include <netinet/in.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cnc/line_splitter.h"

namespace stillcut::hal {

class LineServer {
 public:
  static constexpr std::size_t kClients = 4;
  static constexpr Duration kSilence = std::chrono::seconds(1);
  struct Handlers {
    // A line of a client; gives the answer, empty: none. No two clients ever have the same number.
    std::function<std::string_view(int client, std::string_view line)> take;
    std::function<void(int client)> gone;
  };

  // `owner`: whose programs are heard.
  explicit LineServer(const Clock& clock, uid_t owner = ::geteuid()) : clock_(clock), owner_(owner) {}
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  // `address`: dotted, "127.0.0.1" for this machine alone. Port 0: any that is free.
  Status listen(const std::string& address, int port);
  int port() const noexcept;
  // Waits at most `atMost` for something to happen, then hands it on.
  void serve(Duration atMost, const Handlers& handlers) noexcept;

 private:
  struct Client {
    int socket = -1, number = 0;
    Instant heard{};
    cnc::LineSplitter splitter;
  };

  bool admits(const sockaddr_in& peer, const sockaddr_in& here) const noexcept;
  void accept(const Handlers& handlers) noexcept;
  void hear(Client& client, const Handlers& handlers) noexcept;
  static void drop(Client& client, const Handlers& handlers) noexcept;

  const Clock& clock_;
  uid_t owner_;
  int listener_ = -1, lastNumber_ = 0;
  std::array<Client, kClients> clients_;
};

}  // namespace stillcut::hal
