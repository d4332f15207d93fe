#include "core/cnc/sender/sender_wire.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace stillcut::cnc {
namespace {

using nlohmann::json;

constexpr Duration kPingEvery = std::chrono::seconds(10);
// The sender asks every 250 ms: its report is younger than a step once so much has passed.
constexpr Duration kOlderThanStep = std::chrono::milliseconds(350);
constexpr Duration kQueryEvery = std::chrono::milliseconds(100);  // after a step
constexpr Duration kQuietFor = std::chrono::milliseconds(350);    // then it is asked, too
constexpr std::size_t kMostHeld = 16 * 1024;                      // of a response, and of what waits to be read
constexpr int kReadsAtOnce = 64;                                  // of 1024 bytes
constexpr std::string_view kPath = "/socket.io/?EIO=3&transport=websocket&token=";

std::string post(const SenderSettings& s) {
  json body = json::object();
  if (!s.name.empty()) body = {{"name", s.name}, {"password", s.password}};
  const std::string text = body.dump(-1, ' ', true, json::error_handler_t::replace);
  return "POST /api/signin HTTP/1.1\r\nHost: " + s.host +
         "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(text.size()) +
         "\r\nConnection: close\r\n\r\n" + text;
}

// The body, once all of it is there.
std::optional<std::string> bodyOf(const std::string& response, bool ended) {
  const std::size_t head = response.find("\r\n\r\n");
  if (head == std::string::npos) return std::nullopt;
  std::string names = response.substr(0, head);
  std::transform(names.begin(), names.end(), names.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c + 32 : c); });
  const std::size_t place = names.find("content-length:");
  std::string body = response.substr(head + 4);
  if (place == std::string::npos) return ended ? std::optional(body) : std::nullopt;
  std::size_t size = 0;
  for (std::size_t i = place + 15; i < names.size() && (names[i] == ' ' || (names[i] >= '0' && names[i] <= '9')); ++i) {
    if (names[i] != ' ') size = std::min<std::size_t>(10 * size + static_cast<std::size_t>(names[i] - '0'), 1U << 20U);
  }
  return body.size() >= size ? std::optional(body) : std::nullopt;
}

std::string textOf(const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  if (found->is_string()) return found->get<std::string>();
  return found->is_number() ? found->dump() : std::string();
}

}  // namespace

SenderWire::SenderWire(SenderSettings settings, std::unique_ptr<ByteChannel> wire, const Clock& clock)
    : settings_(std::move(settings)), wire_(std::move(wire)), clock_(clock) {}

void SenderWire::connect() noexcept {
  close();
  guarded([this] { request(Phase::SigningIn); });
}

void SenderWire::request(Phase phase) {
  phase_ = phase;
  requested_ = false;
  response_.clear();
  wire_->connect();
}

void SenderWire::close() noexcept {
  wire_->close();
  phase_ = Phase::Closed;
  frames_.clear();
  response_.clear();
  lines_.clear();
  words_.clear();
  overrides_.clear();
  wanted_ = false;
}

WireState SenderWire::state() noexcept {
  step();
  if (phase_ == Phase::Closed) return WireState::Closed;
  return phase_ == Phase::Joined ? WireState::Open : WireState::Opening;
}

void SenderWire::advance() {
  if (phase_ == Phase::Closed) return;
  const WireState under = wire_->state();
  if (under == WireState::Open && !requested_) {
    requested_ = true;
    const std::string host = " HTTP/1.1\r\nHost: " + settings_.host + "\r\n";
    if (phase_ == Phase::SigningIn) {
      wire_->write(post(settings_));
    } else if (phase_ == Phase::FindingPort) {
      wire_->write("GET /api/controllers?token=" + token_ + host + "Connection: close\r\n\r\n");
    } else {
      wire_->write("GET " + std::string(kPath) + token_ + host +
                   "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                   "Sec-WebSocket-Key: c3RpbGxjdXQgY2xpZW50IQ==\r\n\r\n");
    }
  }
  listen();
  if (phase_ != Phase::Closed && requested_ && wire_->state() == WireState::Closed) close();
}

void SenderWire::listen() {
  std::array<char, 1024> bytes;
  for (int i = 0; i < kReadsAtOnce && phase_ != Phase::Closed; ++i) {
    const std::size_t n = wire_->read(bytes);
    const bool ended = n == 0 && wire_->state() == WireState::Closed;
    if (n == 0 && !ended) break;
    if (phase_ >= Phase::Joining) {
      frames_.put({bytes.data(), n});
    } else if (requested_) {
      if (response_.size() < kMostHeld * 4) response_.append(bytes.data(), n);
      takeResponse();
    }
    if (n == 0) break;
  }
  if (phase_ >= Phase::Joining) takeMessages();
  const Instant now = clock_.now();
  if (phase_ >= Phase::Joining && now - pinged_ > kPingEvery) {
    pinged_ = now;
    say("2");
  }
  query(now);
}

void SenderWire::takeResponse() {
  if (phase_ == Phase::Upgrading) {
    const std::size_t head = response_.find("\r\n\r\n");
    if (head == std::string::npos) return;
    if (!response_.starts_with("HTTP/1.1 101")) return close();
    frames_.put(std::string_view(response_).substr(head + 4));
    response_.clear();
    phase_ = Phase::Joining;
    pinged_ = clock_.now();
    return;
  }
  const auto body = bodyOf(response_, wire_->state() == WireState::Closed);
  if (!body) return;
  const json said = json::parse(*body, nullptr, false);
  if (phase_ == Phase::SigningIn) {
    token_ = said.is_object() ? textOf(said, "token") : std::string();
    if (token_.empty() || token_.find_first_of("\r\n ") != std::string::npos) return close();
    return request(Phase::FindingPort);
  }
  port_.clear();
  for (const json& controller : said.is_array() ? said : json::array()) {
    const std::string port = controller.is_object() ? textOf(controller, "port") : std::string();
    if (port_.empty() && !port.empty() && (settings_.port.empty() || settings_.port == port)) port_ = port;
  }
  if (port_.empty()) return close();  // it has none open, and opening it is the operator's
  request(Phase::Upgrading);
}

void SenderWire::takeMessages() {
  while (phase_ >= Phase::Joining) {
    const auto message = frames_.next();
    if (!message) return;
    if (message->kind == WebSocketKind::Close) return close();
    if (message->kind == WebSocketKind::Ping) wire_->write(webSocketFrame(message->payload, ++mask_, true));
    if (message->kind == WebSocketKind::Text) takePacket(message->payload);
  }
}

void SenderWire::takePacket(std::string_view packet) {
  if (packet == "2") return say("3");  // newer servers ask
  if (packet.starts_with("40")) {
    say("42" + json::array({"open", port_, json::object()}).dump());  // it is open: this only joins
    return;
  }
  if (packet.starts_with("41") || packet.starts_with("44")) return close();
  if (!packet.starts_with("42[")) return;
  const json event = json::parse(packet.substr(2), nullptr, false);
  if (!event.is_array() || event.size() < 2 || !event[0].is_string()) return;
  const std::string name = event[0].get<std::string>();
  if (name == "serialport:open") {
    phase_ = Phase::Joined;
  } else if (name == "serialport:close") {
    close();
  } else if (name == "serialport:read" && event[1].is_string()) {
    const std::string line = event[1].get<std::string>();
    heard_ = clock_.now();
    wanted_ = false;
    if (const std::size_t ov = line.find("Ov:"); ov != std::string::npos) {
      overrides_ = line.substr(ov, line.find_first_of("|>", ov) - ov);
    }
    if (lines_.size() + line.size() < kMostHeld) lines_ += line + "\n";
  } else if (name == "controller:state" && event.size() > 2 && event[1] == "Grbl" && event[2].is_object()) {
    takeState(event[2]);
  }
}

// As the controller would have said it.
void SenderWire::takeState(const json& state) {
  const json status = state.value("status", json::object());
  const json parser = state.value("parserstate", json::object());
  if (parser.is_object() && !textOf(parser, "feedrate").empty() && !textOf(parser, "spindle").empty()) {
    const json modal = parser.value("modal", json::object());
    const std::string units = modal.is_object() ? textOf(modal, "units") : std::string();
    words_ = "[GC:" + (units.empty() ? "G21" : units) + " F" + textOf(parser, "feedrate") + " S" +
             textOf(parser, "spindle") + "]\n";
  }
  const Instant now = clock_.now();
  if (!status.is_object()) return;
  const json ov = status.value("ov", json::array());
  std::string overrides;
  const auto isNumber = [](const json& value) { return value.is_number(); };
  if (ov.is_array() && ov.size() == 3 && std::all_of(ov.begin(), ov.end(), isNumber))
    overrides = "Ov:" + ov[0].dump() + "," + ov[1].dump() + "," + ov[2].dump();
  // What it knew before is older than a step that was just sent; what is new to us is not.
  if (overrides == overrides_ && now - stepped_ < kOlderThanStep) return;
  heard_ = now;
  wanted_ = false;
  overrides_ = overrides;
  const std::string line =
      "<" + textOf(status, "activeState") + "|FS:" + textOf(status, "feedrate") + "," + textOf(status, "spindle");
  if (lines_.size() + line.size() < kMostHeld) lines_ += line + (overrides.empty() ? "" : "|" + overrides) + ">\n";
}

void SenderWire::say(std::string_view packet) {
  if (!wire_->write(webSocketFrame(packet, mask_ = mask_ * 1664525U + 1013904223U))) close();
}

void SenderWire::command(std::string_view name, int value) {
  stepped_ = clock_.now();
  say("42" + json::array({"command", port_, name, value}).dump());
}

void SenderWire::query(Instant now) {
  if (!wanted_ || phase_ != Phase::Joined) return;
  const bool afterStep = now - stepped_ < 4 * kOlderThanStep && (queried_ < stepped_ || now - queried_ >= kQueryEvery);
  if (!afterStep && (now - heard_ < kQuietFor || now - queried_ < kQuietFor)) return;
  queried_ = now;
  say("42" + json::array({"write", port_, "?"}).dump());
}

bool SenderWire::write(std::string_view bytes) noexcept {
  step();
  if (phase_ != Phase::Joined) return false;
  guarded([&] { pass(bytes); });
  return phase_ == Phase::Joined;
}

void SenderWire::pass(std::string_view bytes) {
  static constexpr std::array<int, 5> kSteps{0, 10, -10, 1, -1};
  if (bytes.find("$G") != std::string_view::npos && !words_.empty()) lines_ += words_;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte == '?') wanted_ = true;
    if (byte >= 0x90 && byte <= 0x94) command("feedOverride", kSteps[byte - 0x90U]);
    if (byte >= 0x99 && byte <= 0x9D) command("spindleOverride", kSteps[byte - 0x99U]);
  }
  query(clock_.now());
}

std::size_t SenderWire::read(std::span<char> into) noexcept {
  step();
  const std::size_t n = std::min(into.size(), lines_.size());
  std::copy_n(lines_.begin(), n, into.begin());
  lines_.erase(0, n);
  return n;
}

void SenderWire::wait(Duration atMost) noexcept {
  if (lines_.empty()) wire_->wait(atMost);
  step();
}

}  // namespace stillcut::cnc
