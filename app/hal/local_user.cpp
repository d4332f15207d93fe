#include "app/hal/local_user.h"

#include <arpa/inet.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

namespace stillcut::hal {

namespace {

// As the kernel's list has it.
std::string inList(const sockaddr_in& end) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%08X:%04X", static_cast<unsigned>(end.sin_addr.s_addr),
                static_cast<unsigned>(ntohs(end.sin_port)));
  return text.data();
}

}  // namespace

std::optional<uid_t> localUser(const sockaddr_in& peer, const sockaddr_in& here, const std::string& table) {
  constexpr const char* kEstablished = "01";
  const std::string theirs = inList(peer);
  const std::string ours = inList(here);
  std::ifstream list(table);
  list.ignore(std::numeric_limits<std::streamsize>::max(), '\n');  // the heading
  for (std::string line; std::getline(list, line);) {
    std::istringstream words(line);
    std::string number, own, other, state, queues, timer, retries;
    uid_t user = 0;
    if (!(words >> number >> own >> other >> state >> queues >> timer >> retries >> user)) continue;
    if (own == theirs && other == ours && state == kEstablished) return user;
  }
  return std::nullopt;
}

bool isLoopback(const sockaddr_in& peer) noexcept {
  constexpr std::uint32_t kLoopback = 127;
  return ntohl(peer.sin_addr.s_addr) >> 24U == kLoopback;
}

}  // namespace stillcut::hal
