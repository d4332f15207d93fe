// A sender beside GRBL, as CNCjs is one: it signs clients in over HTTP, speaks socket.io over a web socket, asks its
// controller every 250 ms and passes on what has changed. `tick` is its timer.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "core/cnc/grbl/grbl_status.h"
#include "tests/support/grbl/fake_grbl.h"

namespace stillcut::cnc::testing {

class FakeSender final : public Peer {
 public:
  explicit FakeSender(FakeGrbl& grbl) : grbl_(grbl) {}
  bool portOpen = true;
  bool users = false;  // it wants a name
  int asked = 0;       // "?" that clients have written
  std::string sent;    // lines that clients have written
  std::size_t flood = 0;

  void connected() override {
    heard_.clear();
    socket_ = joined_ = false;
  }
  void take(std::string_view bytes, Instant now, const Answer& answer) override {
    heard_ += bytes;
    if (!socket_) return http(answer);
    while (heard_.size() >= 6) {
      const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(heard_[i]); };
      std::size_t size = byte(1) & 0x7FU, head = 2;
      if (size == 126) size = byte(2) * 256U + byte(3), head = 4;
      if (heard_.size() < head + 4 + size) return;
      std::string text = heard_.substr(head + 4, size);
      for (std::size_t i = 0; i < size; ++i) text[i] = static_cast<char>(text[i] ^ heard_[head + i % 4]);
      heard_.erase(0, head + 4 + size);
      packet(text, now, answer);
    }
  }
  // Its timer, every 250 ms; what it has to say to whoever has joined.
  void tick(Instant now, const std::function<void(std::string)>& say) {
    nlohmann::json state = {
        {"status", status_},
        {"parserstate", {{"feedrate", "1200"}, {"spindle", "8800"}, {"modal", {{"units", "G21"}}}}}};
    if (joined_ && state != told_) say(frame("42" + nlohmann::json::array({"controller:state", "Grbl", state}).dump()));
    told_ = state;
    grbl_.take("?", now, [&](const std::string& line, double) { learn(line); });
  }
  static std::string frame(const std::string& text) {
    std::string head = "\x81";
    if (text.size() < 126) return head + static_cast<char>(text.size()) + text;
    return head + static_cast<char>(126) + static_cast<char>(text.size() >> 8U) +
           static_cast<char>(text.size() & 255U) + text;
  }

 private:
  static std::string ok(const std::string& body) {
    return "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
           "\r\n\r\n" + body;
  }
  void http(const Answer& answer) {
    if (heard_.find("\r\n\r\n") == std::string::npos) return;
    if (heard_.starts_with("POST /api/signin")) {
      const bool named = heard_.find("\"name\":\"anna\"") != std::string::npos;
      answer(users && !named ? "HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n" : ok(R"({"token":"a.b.c"})"),
             0.0);
    } else if (heard_.find("token=a.b.c") == std::string::npos) {
      answer("HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\n\r\n", 0.0);
    } else if (heard_.starts_with("GET /api/controllers")) {
      answer(ok(portOpen ? R"([{"port":"/dev/ttyUSB3","ready":true}])" : "[]"), 0.0);
    } else {
      socket_ = true;
      answer("HTTP/1.1 101 Switching Protocols\r\n\r\n" + frame(R"(0{"sid":"x"})") + frame("40"), 0.0);
    }
    heard_.clear();
  }
  void packet(const std::string& text, Instant now, const Answer& answer) {
    if (text == "2") answer(frame("3"), 0.0);
    if (!text.starts_with("42")) return;
    const auto event = nlohmann::json::parse(text.substr(2));
    const std::string name = event[0];
    if (event[1] != "/dev/ttyUSB3") return;
    if (name == "open") {
      joined_ = true;
      if (flood > 0) {  // the program that is loaded: everybody gets it
        std::string big = "\x81\x7F";
        for (int i = 7; i >= 0; --i) big += static_cast<char>((flood >> (8U * static_cast<unsigned>(i))) & 255U);
        answer(big + std::string(flood, 'G'), 0.0);
      }
      answer(frame(R"(42["serialport:open",{"port":"/dev/ttyUSB3","inuse":true}])"), 0.0);
    } else if (name == "write" && event[2] == "?") {
      ++asked;
      grbl_.take("?", now, [&](const std::string& line, double delay) {
        learn(line);
        answer(frame("42" + nlohmann::json::array({"serialport:read", line.substr(0, line.size() - 2)}).dump()), delay);
      });
    } else if (name == "command") {
      const int value = event[3];
      const int step = value == 0 ? 0 : value == 10 ? 1 : value == -10 ? 2 : value == 1 ? 3 : 4;
      const char byte = static_cast<char>((event[2] == "feedOverride" ? 0x90 : 0x99) + step);
      grbl_.take({&byte, 1}, now, [](const std::string&, double) {});
    } else {
      sent += event.dump() + "\n";
    }
  }
  void learn(const std::string& line) {
    GrblReport r;
    GrblWords w;
    if (readGrblLine(line.substr(0, line.size() - 2), r, w) != GrblLine::Report) return;
    status_["activeState"] = line.substr(1, line.find('|') - 1);
    status_["feedrate"] = *r.feed;
    status_["spindle"] = *r.speed;
    status_["mpos"] = {{"x", std::to_string(++moves_)}};  // the tool moves
    if (r.feedOverride) status_["ov"] = {*r.feedOverride, 100, *r.speedOverride};
  }

  FakeGrbl& grbl_;
  bool socket_ = false, joined_ = false;
  std::string heard_;
  nlohmann::json status_ = nlohmann::json::object(), told_;
  int moves_ = 0;
};

}  // namespace stillcut::cnc::testing
