#include "app/shop/mtconnect_adapter.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>

namespace stillcut::shop {
namespace {

using nlohmann::json;

constexpr int kMostReads = 16;                        // in one turn; what one agent says beyond that waits for the next
constexpr std::size_t kLongestWord = 4096;            // bytes; no agent says so much
constexpr const char* kHeartbeat = "* PONG 10000\n";  // ms: how often an agent asks whether we live

// An agent whose computer is gone without a word leaves its place to another within a minute.
void keepAlive(int socket) {
  const int on = 1, idle_s = 30, every_s = 10, tries = 3;
  ::setsockopt(socket, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
  ::setsockopt(socket, IPPROTO_TCP, TCP_KEEPIDLE, &idle_s, sizeof idle_s);
  ::setsockopt(socket, IPPROTO_TCP, TCP_KEEPINTVL, &every_s, sizeof every_s);
  ::setsockopt(socket, IPPROTO_TCP, TCP_KEEPCNT, &tries, sizeof tries);
}

// "2026-11-27T05:20:59.123Z"
std::string timeOf(std::int64_t utcMs) {
  const std::time_t whole = utcMs / 1000;
  std::tm utc{};
  gmtime_r(&whole, &utc);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d:%02d.%03dZ", utc.tm_year + 1900, utc.tm_mon + 1,
                utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec, static_cast<int>(utcMs % 1000));
  return text.data();
}

const json& at(const json& object, const char* key) {
  static const json kNothing;
  if (!object.is_object()) return kNothing;
  const auto found = object.find(key);
  return found != object.end() ? *found : kNothing;
}
// A bar and an end of line are the format's own.
std::string plain(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c == '|' || c < 0x20; }, ' ');
  return text;
}
std::string value(const json& v, double scale = 1.0) {
  if (v.is_string()) return plain(v.get<std::string>());
  if (!v.is_number()) return "UNAVAILABLE";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.10g", scale * v.get<double>());
  return text.data();
}
std::string upper(std::string text) {
  for (char& c : text) c = c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// LEVEL|native code|native severity|qualifier|text
std::string condition(const json& line) {
  const std::string state = value(at(line, "state"));
  const std::string text = value(at(line, "sentence"));
  if (state == "air" || state == "stable") return "NORMAL||||";
  if (state != "onset" && state != "chatter") return "UNAVAILABLE||||" + (text == "UNAVAILABLE" ? std::string() : text);
  const std::string at_hz =
      at(line, "frequency_hz").is_number() ? " at " + value(at(line, "frequency_hz")) + " Hz" : std::string();
  return (state == "onset" ? "WARNING|chatter|" : "FAULT|chatter|") + value(at(line, "energy_ratio")) + "||" + state +
         at_hz;
}

}  // namespace

MtConnectAdapter::~MtConnectAdapter() {
  for (const Client& client : clients_) ::close(client.socket);
  if (listener_ >= 0) ::close(listener_);
}

Status MtConnectAdapter::listen(const std::string& where) {
  const auto colon = where.rfind(':');
  const std::string host = colon == std::string::npos ? "127.0.0.1" : where.substr(0, colon);
  const std::string port = colon == std::string::npos ? where : where.substr(colon + 1);
  int number = -1;
  std::from_chars(port.data(), port.data() + port.size(), number);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(number));
  if (number < 0 || number > 65535 || ::inet_pton(AF_INET, host.c_str(), &place.sin_addr) != 1)
    return Error{where, message("is no place to listen on"), message("7878, or 0.0.0.0:7878")};
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  ::setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  socklen_t size = sizeof place;
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&place), size) != 0 || ::listen(listener_, 4) != 0 ||
      ::getsockname(listener_, reinterpret_cast<sockaddr*>(&place), &size) != 0)
    return Error{where, message("cannot be listened on"), foreign(std::strerror(errno))};
  port_ = ntohs(place.sin_port);
  return Done{};
}

void MtConnectAdapter::set(std::int64_t utcMs, const std::string& item, const std::string& text) {
  std::string& known = items_[item];
  if (known == text) return;
  known = text;
  const std::string line = timeOf(utcMs) + "|" + item + "|" + text + "\n";
  for (Client& client : clients_) client.out += line;
}

void MtConnectAdapter::hear(const json& line) {
  const std::string type = value(at(line, "type"));
  const std::int64_t utcMs = at(line, "utc_ms").is_number() ? at(line, "utc_ms").get<std::int64_t>() : 0;
  newestUtcMs_ = std::max(newestUtcMs_, utcMs);
  if (type == "start") {
    set(utcMs, "avail", "AVAILABLE");
    set(utcMs, "tool", value(at(line, "tool")));
    set(utcMs, "job", value(at(line, "job")));
  } else if (type == "change" || type == "status") {
    const json& machine = at(line, "machine");
    set(utcMs, "avail", "AVAILABLE");
    set(utcMs, "chatter", condition(line));
    set(utcMs, "cut_state", upper(value(at(line, "state"))));
    set(utcMs, "mode", upper(value(at(line, "mode"))));
    set(utcMs, "chatter_frequency", value(at(line, "frequency_hz")));
    set(utcMs, "spindle_speed",
        value(at(machine, "actual_rpm").is_number() ? at(machine, "actual_rpm") : at(line, "speed_rpm")));
    set(utcMs, "spindle_programmed", value(at(machine, "programmed_rpm")));
    set(utcMs, "spindle_override", value(at(machine, "speed_override_percent")));
    set(utcMs, "feed", value(at(machine, "actual_feed_mm_min"), 1.0 / 60.0));  // mm/s
    set(utcMs, "feed_override", value(at(machine, "feed_override_percent")));
  } else if (type == "stopped" || type == "end") {
    for (auto& [item, known] : std::map(items_)) {
      if (item != "tool" && item != "job") set(utcMs, item, item == "chatter" ? "UNAVAILABLE||||" : "UNAVAILABLE");
    }
  }
  flush();
}

void MtConnectAdapter::addEntries(std::vector<pollfd>& entries) const {
  if (listener_ >= 0) entries.push_back({listener_, POLLIN, 0});
  for (const Client& client : clients_)
    entries.push_back({client.socket, static_cast<short>(POLLIN | (client.out.empty() ? 0 : POLLOUT)), 0});
}

void MtConnectAdapter::accept() {
  for (int s = 0; (s = ::accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)) >= 0;) {
    if (clients_.size() >= kMostClients) {
      ::close(s);
      continue;
    }
    keepAlive(s);
    // Everything that is known now, so that an agent that comes later is as good.
    Client client{s, {}, {}};
    for (const auto& [item, text] : items_) client.out += timeOf(newestUtcMs_) + "|" + item + "|" + text + "\n";
    clients_.push_back(std::move(client));
  }
}

void MtConnectAdapter::letGo(Client& client) {
  ::close(client.socket);
  client.socket = -1;
}

void MtConnectAdapter::serve(Client& client) {
  std::array<char, 512> bytes{};
  for (int reads = 0; reads < kMostReads; ++reads) {
    const ssize_t n = ::recv(client.socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (n < 0) return;
    if (n == 0) return letGo(client);
    client.in.append(bytes.data(), static_cast<std::size_t>(n));
    for (std::size_t end = 0; (end = client.in.find('\n')) != std::string::npos; client.in.erase(0, end + 1)) {
      if (client.in.starts_with("* PING")) client.out += kHeartbeat;
    }
    if (client.in.size() > kLongestWord) return letGo(client);
  }
}

void MtConnectAdapter::flush() {
  for (Client& client : clients_) {
    while (client.socket >= 0 && !client.out.empty()) {
      const ssize_t n = ::send(client.socket, client.out.data(), client.out.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (n <= 0) {
        if ((n < 0 && errno != EAGAIN) || client.out.size() > kMostWaiting) letGo(client);
        break;
      }
      client.out.erase(0, static_cast<std::size_t>(n));
    }
  }
  std::erase_if(clients_, [](const Client& client) { return client.socket < 0; });
}

void MtConnectAdapter::turn() {
  if (listener_ >= 0) accept();
  for (Client& client : clients_) serve(client);
  flush();
}

}  // namespace stillcut::shop
