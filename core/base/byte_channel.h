// ByteChannel: the wire below a protocol, of a machine link or of a device: a socket, a serial port, or a test's
// scripted server. Bytes only; it knows no protocol. Adapters for real wires are in app/io.
// Thread: the link or driver thread alone, but for the constructor; another only after handOver(). Nothing throws; a
// wire that breaks becomes Closed and stays so until connect() is called again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"

namespace stillcut {

enum class WireState : std::uint8_t { Closed, Opening, Open };

class ByteChannel {
 public:
  virtual ~ByteChannel() = default;
  // What a person calls this wire, for error lines: "localhost:5007", "/dev/ttyUSB0".
  virtual std::string_view address() const noexcept = 0;
  // Begins to connect and returns at once; what was open is closed first.
  virtual void connect() noexcept = 0;
  virtual WireState state() noexcept = 0;  // of this moment; never blocks
  // Bytes that are there, at most into.size(); 0: none. Never blocks.
  virtual std::size_t read(std::span<char> into) noexcept = 0;
  // All or nothing; false closes the wire (a peer that does not take a few dozen bytes is gone). Never blocks.
  virtual bool write(std::string_view bytes) noexcept = 0;
  // Returns when there is something to read, the state has changed, or `atMost` has passed.
  virtual void wait(Duration atMost) noexcept = 0;
  virtual void close() noexcept = 0;  // safe when not open
  // Said on the thread that has used it so far: another one does from now on.
  virtual void handOver() noexcept {}
};

// Where a wire leads. Exactly one of host and device is given.
struct WireAddress {
  std::string host;    // name or address of a TCP peer
  int port = 0;        // 1..65535, with host
  std::string device;  // path of a serial port
  int baud = 115200;   // with device
};

// Makes the wire, unconnected; an error names what this build cannot do. Given to links and devices by app.
using WireMaker = std::function<Result<std::unique_ptr<ByteChannel>>(const WireAddress& address)>;

}  // namespace stillcut
