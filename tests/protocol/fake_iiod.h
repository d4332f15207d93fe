// A server that speaks iiod's text protocol (libiio 0.24): one accelerometer of three axes, 24 bits in 32, whose frame
// n holds 3 n + c on axis c. Its buffer is refilled as fast as it is asked for.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace stillcut::testing {

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
  std::atomic<bool> triggered{false};  // streams only with its trigger "timer" set
  std::atomic<bool> hasTrigger{false};
  std::atomic<int> hangUpAfter{-1};  // buffers; then the streaming connection is cut, once

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

  static std::string description() {
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
    const char* axes[] = {"accel_x", "accel_y", "accel_z"};
    for (int c = 0; c < 3; ++c) {
      xml += std::string("<channel id=\"") + axes[c] + "\" type=\"input\"><scan-element index=\"" + std::to_string(c) +
             "\" format=\"le:s24/32&gt;&gt;0\" scale=\"0.001000\" /></channel>";
    }
    return xml +
           "<attribute name=\"sampling_frequency\" /><attribute name=\"sampling_frequency_available\" />"
           "</device><device id=\"trigger0\" name=\"timer\"><attribute name=\"sampling_frequency\" /></device>"
           "<device id=\"iio:device1\" name=\"temperature\"></device></context>";
  }

  void serve(int client) {
    std::string line;
    int frame = 0;
    int buffers = 0;
    unsigned mask = 7;
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
        int channels = 0;
        for (unsigned m = mask; m != 0; m >>= 1) channels += static_cast<int>(m & 1U);
        char head[64];
        std::snprintf(head, sizeof head, "%d\n%08x\n", bytes, mask);
        std::string data = head;
        for (int f = 0; f < bytes / (4 * channels); ++f, ++frame) {
          for (int c = 0; c < 3; ++c) {
            if ((mask >> c & 1U) == 0) continue;
            const auto value = static_cast<unsigned>(3 * frame + c);
            for (int b = 0; b < 4; ++b) data += static_cast<char>(value >> (8 * b));
          }
        }
        send(client, data);
      } else if (line.starts_with("READ") && line.find("available") != std::string::npos) {
        sendText(client, "12800 25600");
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
