// TcpWire: a ByteChannel over a TCP socket that never blocks. The name is looked up once, when the wire is made, so
// that nothing on the link thread waits for a name server.
// Plain sockets and not QTcpSocket: the link thread has no event loop, and the command line must work without Qt.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/cnc/byte_channel.h"

namespace stillcut::app {

class TcpWire final : public cnc::ByteChannel {
 public:
  // Looks the host up; may block, may fail with one line.
  static Result<std::unique_ptr<cnc::ByteChannel>> make(const std::string& host, int port);
  ~TcpWire() override;
  TcpWire(const TcpWire&) = delete;
  TcpWire& operator=(const TcpWire&) = delete;

  std::string_view address() const noexcept override { return name_; }
  void connect() noexcept override;
  cnc::WireState state() noexcept override;
  std::size_t read(std::span<char> into) noexcept override;
  bool write(std::string_view bytes) noexcept override;
  void wait(Duration atMost) noexcept override;
  void close() noexcept override;

 private:
  // One address the name stands for, as bind and connect take it.
  struct Place {
    int family = 0;
    std::vector<unsigned char> address;
  };
  TcpWire(std::string name, std::vector<Place> places) : name_(std::move(name)), places_(std::move(places)) {}
  int poll(short events, int milliseconds) const noexcept;

  std::string name_;
  std::vector<Place> places_;
  std::size_t next_ = 0;  // the place to try next
  int socket_ = -1;
  cnc::WireState state_ = cnc::WireState::Closed;
};

}  // namespace stillcut::app
