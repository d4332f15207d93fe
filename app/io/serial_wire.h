// SerialWire: a ByteChannel over QSerialPort, polled. The port object is made by connect() and destroyed by close(), so
// that it lives on the thread that uses it; handed over it stays open, since many boards start anew when a port opens.
// Any path is taken, listed or not (a pty, a bridge). A port whose peer has gone reports errors without end until it is
// closed, so the first one closes it.
#pragma once

#include <memory>
#include <string>

#include "core/cnc/byte_channel.h"

class QSerialPort;

namespace stillcut::app {

class SerialWire final : public cnc::ByteChannel {
 public:
  // `parity`: N, E or O; a pty has none, and refuses another.
  SerialWire(std::string device, int baud, char parity = 'N', int stopBits = 1);
  ~SerialWire() override;

  std::string_view address() const noexcept override { return device_; }
  void connect() noexcept override;
  cnc::WireState state() noexcept override;
  std::size_t read(std::span<char> into) noexcept override;
  bool write(std::string_view bytes) noexcept override;
  void wait(Duration atMost) noexcept override;
  void close() noexcept override;
  void handOver() noexcept override;

 private:
  void adopt() noexcept;
  bool broken() const noexcept;

  std::string device_;
  int baud_;
  char parity_;
  int stopBits_;
  std::unique_ptr<QSerialPort> port_;
};

}  // namespace stillcut::app
