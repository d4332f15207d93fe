// SenderWire: a wire to a GRBL controller through the program that streams to it, as a second client of its socket:
// CNCjs (socket.io 2 over a web socket). To GrblLink it is a controller's own wire. Override bytes become the sender's
// commands, which are GRBL's; "?" is asked through the sender only while it matters (after a step, and when nothing was
// heard for a while), since its answer appears in the sender's console; else the sender's own reports are passed on,
// which come every 250 ms while something changes. "$G" is never sent, since its "ok" would be counted for a line of
// the program: the sender knows the words. It joins a port that the sender has open, and never opens or closes one.
// Thread: as ByteChannel. Nothing throws; memory is bounded.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "core/cnc/byte_channel.h"
#include "core/cnc/sender/web_socket.h"

namespace stillcut::cnc {

struct SenderSettings {
  std::string host = "localhost";
  std::string port;            // the serial port in the sender; empty: the first that it has open
  std::string name, password;  // where the sender has users
};

class SenderWire final : public ByteChannel {
 public:
  // `wire`: to the sender's web server. `clock` outlives it.
  SenderWire(SenderSettings settings, std::unique_ptr<ByteChannel> wire, const Clock& clock);

  std::string_view address() const noexcept override { return wire_->address(); }
  void connect() noexcept override;
  WireState state() noexcept override;
  std::size_t read(std::span<char> into) noexcept override;
  bool write(std::string_view bytes) noexcept override;
  void wait(Duration atMost) noexcept override;
  void close() noexcept override;

 private:
  enum class Phase : std::uint8_t { Closed, SigningIn, FindingPort, Upgrading, Joining, Joined };

  // Does `work`; what it throws (memory that is not there) closes the wire.
  template <class Work>
  void guarded(Work&& work) noexcept {
    try {
      work();
    } catch (...) {
      close();
    }
  }
  void step() noexcept {
    guarded([this] { advance(); });
  }
  void advance();
  void pass(std::string_view bytes);
  void listen();
  void request(Phase phase);
  void takeResponse();
  void takeMessages();
  void takePacket(std::string_view packet);
  void takeState(const nlohmann::json& state);
  void say(std::string_view packet);
  void command(std::string_view name, int value);
  void query(Instant now);

  SenderSettings settings_;
  std::unique_ptr<ByteChannel> wire_;
  const Clock& clock_;
  Phase phase_ = Phase::Closed;
  bool requested_ = false;  // this phase's request is out
  std::string response_, token_, port_;
  WebSocketReader frames_;
  std::string lines_;      // to be read
  std::string overrides_;  // as told last: "Ov:100,100,100"
  std::string words_;      // the parser state, as "$G" would tell it
  Instant pinged_{}, stepped_{}, heard_{}, queried_{};
  bool wanted_ = false;  // a report, by whoever reads here
  std::uint32_t mask_ = 0x5C3A9D71;
};

}  // namespace stillcut::cnc
