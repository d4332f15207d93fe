#include "app/shop/plot_sender.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

namespace stillcut::shop {
namespace {

using nlohmann::json;

json numbersOf(const json& object) {
  json numbers = json::object();
  for (const auto& [key, value] : object.items()) {
    if (value.is_number() || value.is_boolean()) numbers[key] = value;
    if (value.is_object()) numbers[key] = numbersOf(value);
  }
  return numbers;
}

}  // namespace

PlotSender::~PlotSender() {
  if (socket_ >= 0) ::close(socket_);
}

Status PlotSender::open(const std::string& where) {
  const auto colon = where.rfind(':');
  int port = -1;
  if (colon != std::string::npos) std::from_chars(where.data() + colon + 1, where.data() + where.size(), port);
  to_.sin_family = AF_INET;
  to_.sin_port = htons(static_cast<std::uint16_t>(port));
  if (port < 1 || port > 65535 || ::inet_pton(AF_INET, where.substr(0, colon).c_str(), &to_.sin_addr) != 1)
    return Error{where, message("is no address"), message("for example 127.0.0.1:9870")};
  socket_ = ::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  return Done{};
}

void PlotSender::hear(const json& line) {
  if (line["type"] != "change" && line["type"] != "status") return;
  json numbers = numbersOf(line);
  constexpr std::array<const char*, 4> kStates{"air", "stable", "onset", "chatter"};
  const std::string state = line.contains("state") && line["state"].is_string() ? line["state"].get<std::string>() : "";
  numbers["state_number"] = -1;  // not judged
  for (std::size_t k = 0; k < kStates.size(); ++k) {
    if (state == kStates[k]) numbers["state_number"] = k;
  }
  const double utcMs = numbers.contains("utc_ms") ? numbers["utc_ms"].get<double>() : 0.0;
  const std::string text = json{{"timestamp", 1e-3 * utcMs}, {"stillcut", numbers}}.dump();
  ::sendto(socket_, text.data(), text.size(), MSG_DONTWAIT, reinterpret_cast<const sockaddr*>(&to_), sizeof to_);
}

}  // namespace stillcut::shop
