// A server that speaks iiod's text protocol (libiio 0.24): one accelerometer of three axes, 24 bits in 32, whose frame
// n holds 3 n + c on axis c; or a device with the elements it is given. Its buffer is refilled as fast as it is asked
// for, or at its rate.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace stillcut::testing {

// A channel of the buffer: `value` of frame n is sent in its low bytes, as they are.
struct IioElement {
  std::string id = "accel_x", format = "le:s24/32>>0";
  int bytes = 4;  // all repetitions together
  std::function<std::uint64_t(int frame)> value{};
  std::string offset{};  // empty: it has none
  bool big = false;      // the highest byte first
};

class FakeIiod {
 public:
  FakeIiod() {
    socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(kPort);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    good_ = ::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 && ::listen(socket_, 8) == 0;
    if (good_) threads_.emplace_back([this] { accept(); });
  }
  ~FakeIiod() {
    stopped_ = true;
    ::shutdown(socket_, SHUT_RDWR);
    for (const int c : clients_) ::shutdown(c, SHUT_RDWR);
    for (std::thread& t : threads_) t.join();
    ::close(socket_);
  }
  FakeIiod(const FakeIiod&) = delete;
  FakeIiod& operator=(const FakeIiod&) = delete;
  bool good() const { return good_; }

  std::atomic<double> rate{25600.0};
  std::atomic<bool> paced{false};      // by a crystal of its rate
  std::atomic<bool> triggered{false};  // streams only with its trigger "timer" set
  std::atomic<bool> hasTrigger{false};
  std::atomic<int> hangUpAfter{-1};  // buffers; then the streaming connection is cut, once
  // Set before anyone connects.
  std::vector<IioElement> elements = {
      {"accel_x", "le:s24/32>>0", 4, [](int n) { return static_cast<std::uint64_t>(3 * n); }},
      {"accel_y", "le:s24/32>>0", 4, [](int n) { return static_cast<std::uint64_t>(3 * n + 1); }},
      {"accel_z", "le:s24/32>>0", 4, [](int n) { return static_cast<std::uint64_t>(3 * n + 2); }}};

 private:
  static constexpr int kPort = 30431;

  void accept() {
    while (!stopped_) {
      const int client = ::accept(socket_, nullptr, nullptr);
      if (client < 0) return;
      clients_.push_back(client);
      threads_.emplace_back([this, client] { serve(client); });
    }
  }

  static bool readLine(int client, std::string& line) {
    line.clear();
    for (char c = 0; ::recv(client, &c, 1, 0) == 1;) {
      if (c == '\n') {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        return true;
      }
      line += c;
    }
    return false;
  }
  static void send(int client, const std::string& bytes) { ::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  static void sendText(int client, const std::string& text) {
    send(client, std::to_string(text.size()) + "\n" + text + "\n");
  }

  std::string description() const {
    std::string xml =
        "<?xml version=\"1.0\" encoding=\"utf-8\"?><!DOCTYPE context [<!ELEMENT context (device | context-attribute)*>"
        "<!ELEMENT context-attribute EMPTY><!ELEMENT device (channel | attribute | debug-attribute | "
        "buffer-attribute)*>"
        "<!ELEMENT channel (scan-element?, attribute*)><!ELEMENT attribute EMPTY><!ELEMENT scan-element EMPTY>"
        "<!ELEMENT debug-attribute EMPTY><!ELEMENT buffer-attribute EMPTY><!ATTLIST context name CDATA #REQUIRED "
        "description CDATA #IMPLIED><!ATTLIST context-attribute name CDATA #REQUIRED value CDATA #REQUIRED><!ATTLIST "
        "device id CDATA #REQUIRED name CDATA #IMPLIED><!ATTLIST channel id CDATA #REQUIRED type (input|output) "
        "#REQUIRED name CDATA #IMPLIED><!ATTLIST scan-element index CDATA #REQUIRED format CDATA #REQUIRED scale CDATA "
        "#IMPLIED><!ATTLIST attribute name CDATA #REQUIRED filename CDATA #IMPLIED><!ATTLIST debug-attribute name "
        "CDATA "
        "#REQUIRED><!ATTLIST buffer-attribute name CDATA #REQUIRED>]><context name=\"network\" description=\"test\">"
        "<device id=\"iio:device0\" name=\"adxl\">";
    int index = 0;
    for (const IioElement& e : elements) {
      const std::string format =
          e.format.substr(0, e.format.find('>')) + "&gt;&gt;" + e.format.substr(e.format.rfind('>') + 1);
      xml += "<channel id=\"" + e.id + "\" type=\"input\"><scan-element index=\"" + std::to_string(index++) +
             "\" format=\"" + format + "\" scale=\"0.001000\" />" +
             (e.offset.empty() ? "" : "<attribute name=\"offset\" filename=\"in_offset\" />") + "</channel>";
    }
    return xml +
           "<attribute name=\"sampling_frequency\" /><attribute name=\"sampling_frequency_available\" />"
           "</device><device id=\"trigger0\" name=\"timer\"><attribute name=\"sampling_frequency\" /></device>"
           "<device id=\"iio:device1\" name=\"temperature\"></device></context>";
  }

  // Wakes when so many frames have been sampled since the first.
  class Crystal {
   public:
    Crystal() : timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC)) {}
    ~Crystal() { ::close(timer_); }
    Crystal(const Crystal&) = delete;
    Crystal& operator=(const Crystal&) = delete;
    void await(int count, double rate) {
      if (begin_.tv_sec == 0) ::clock_gettime(CLOCK_MONOTONIC, &begin_);
      const auto at = static_cast<std::int64_t>(count / rate * 1e9) + begin_.tv_nsec;
      const itimerspec due{{}, {begin_.tv_sec + at / 1'000'000'000, at % 1'000'000'000}};
      ::timerfd_settime(timer_, TFD_TIMER_ABSTIME, &due, nullptr);
      std::uint64_t ticks = 0;
      while (::read(timer_, &ticks, sizeof ticks) < 0 && errno == EINTR) {
      }
    }

   private:
    int timer_;
    timespec begin_{};
  };

  void serve(int client) {
    Crystal crystal;
    std::string line;
    int frame = 0;
    int buffers = 0;
    unsigned mask = 1;
    while (!stopped_ && readLine(client, line)) {
      if (line.starts_with("VERSION")) {
        send(client, "0.24.c4498c2\n");
      } else if (line.starts_with("PRINT")) {
        sendText(client, description());
      } else if (line.starts_with("READBUF")) {
        if (buffers++ == hangUpAfter) {
          hangUpAfter = -1;
          break;
        }
        const int bytes = std::atoi(line.substr(line.rfind(' ')).c_str());
        int frameBytes = 0;
        for (std::size_t c = 0; c < elements.size(); ++c) frameBytes += (mask >> c & 1U) != 0 ? elements[c].bytes : 0;
        if (paced) crystal.await(frame + bytes / frameBytes, rate);
        char head[64];
        std::snprintf(head, sizeof head, "%d\n%08x\n", bytes, mask);
        std::string data = head;
        for (int f = 0; f < bytes / frameBytes; ++f, ++frame) {
          for (std::size_t c = 0; c < elements.size(); ++c) {
            const IioElement& e = elements[c];
            const int size = (mask >> c & 1U) != 0 ? e.bytes : 0;
            const std::uint64_t value = e.value(frame);
            for (int b = 0; b < size; ++b) data += static_cast<char>(value >> (8 * (e.big ? size - 1 - b : b)));
          }
        }
        send(client, data);
      } else if (line.starts_with("READ") && line.find("available") != std::string::npos) {
        sendText(client, "12800 25600");
      } else if (line.starts_with("READ") && line.find("offset") != std::string::npos) {
        sendText(client, elements.front().offset);
      } else if (line.starts_with("READ ")) {
        sendText(client, std::to_string(rate.load()));
      } else if (line.starts_with("WRITE")) {
        std::string value(static_cast<std::size_t>(std::atoi(line.substr(line.rfind(' ')).c_str())), '\0');
        ::recv(client, value.data(), value.size(), MSG_WAITALL);
        const double wanted = std::atof(value.c_str());
        if (wanted == 12800.0 || wanted == 25600.0) rate = wanted;
        send(client, std::to_string(value.size()) + "\n");
      } else if (line.starts_with("SETTRIG")) {
        hasTrigger = line.ends_with(" trigger0");
        send(client, "0\n");
      } else if (line.starts_with("OPEN") && triggered && !hasTrigger) {
        send(client, "-22\n");
      } else if (line.starts_with("OPEN")) {
        mask = static_cast<unsigned>(std::strtoul(line.substr(line.rfind(' ')).c_str(), nullptr, 16));
        send(client, "0\n");
      } else if (line.starts_with("EXIT")) {
        break;
      } else {
        const bool harmless = line.starts_with("TIMEOUT") || line.starts_with("CLOSE") || line.starts_with("SET ");
        send(client, harmless ? "0\n" : "-22\n");  // EINVAL: not known here
      }
    }
    ::shutdown(client, SHUT_RDWR);
  }

  int socket_ = -1;
  bool good_ = false;
  std::atomic<bool> stopped_{false};
  std::vector<int> clients_;
  std::vector<std::thread> threads_;
};

}  // namespace stillcut::testing
