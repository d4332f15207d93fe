// Who is at the other end of a TCP connection within this computer. The kernel's list names the user of every socket,
// and a socket that its program has closed already belongs to root there: only one that is still held counts.
// Thread: any.
#pragma once

#include <netinet/in.h>
#include <sys/types.h>

#include <optional>
#include <string>

namespace stillcut::hal {

// The user whose program has `peer` as its own end of a connection to `here`: one port may belong to several
// connections, of several users, to different ends. Nothing: no program of this computer holds such an end, so that it
// is of another one, or has hung up, or came by IPv6. `table` is the kernel's.
std::optional<uid_t> localUser(const sockaddr_in& peer, const sockaddr_in& here,
                               const std::string& table = "/proc/net/tcp");

// `peer` is within this computer by its address alone.
bool isLoopback(const sockaddr_in& peer) noexcept;

}  // namespace stillcut::hal
