// RegisterBus: a Modbus master's side as the link sees it: one request under way, polled. RtuBus speaks RTU over a wire
// of bytes; the adapter over Qt SerialBus, for TCP, is in app/io; tests have one of their own.
// Thread: the link thread alone, but for the constructor. Nothing throws.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/cnc/byte_channel.h"

namespace stillcut::cnc {

// The four tables of the Modbus data model.
enum class RegisterTable : std::uint8_t { Coil, Discrete, Input, Holding };

using RegisterWords = std::array<std::uint16_t, 2>;  // the second is unused by one-word values

inline constexpr std::size_t kMostWords = 16;  // of one question

struct BusReply {
  bool ok = false;                                // false: an exception reply, or none in time
  std::array<std::uint16_t, kMostWords> words{};  // as many as were asked for; of a coil the first
  bool unsure = false;  // not ok, but no failure: whose answer came is not known, and the question is to be asked again
};

class RegisterBus {
 public:
  virtual ~RegisterBus() = default;
  // These as of a ByteChannel; wait() ends with a reply too.
  virtual std::string_view address() const noexcept = 0;  // for error lines
  virtual void connect() noexcept = 0;                    // begins, and returns at once
  virtual WireState state() noexcept = 0;                 // Closed stays so until connect()
  virtual void wait(Duration atMost) noexcept = 0;        // until there is something new, or `atMost` has passed
  virtual void close() noexcept = 0;                      // a request under way is forgotten
  // Begin a request; only while not busy(). `count`: of words at most kMostWords, of coils 1. False: the bus broke.
  virtual bool read(RegisterTable table, int first, int count) noexcept = 0;
  // The first `count` of the words, to Coil or Holding; begins as read() does.
  virtual bool write(RegisterTable table, int first, int count, const RegisterWords& words) noexcept = 0;
  // No request may begin: one is under way, without reply nor its time over; or the line must fall silent first.
  virtual bool busy() const noexcept = 0;
  // The reply of the last request, once.
  virtual std::optional<BusReply> take() noexcept = 0;
};

struct BusAddress {
  WireAddress wire;
  int unit = 1;       // of the server
  char parity = 'E';  // serial: N, E or O
  int stopBits = 1;   // serial
  Seconds answerWithin{0.2};
};
// `clock` outlives the bus.
using BusMaker = std::function<Result<std::unique_ptr<RegisterBus>>(const BusAddress& address, const Clock& clock)>;

}  // namespace stillcut::cnc
