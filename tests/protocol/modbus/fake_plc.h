// A machine of registers and the bus to it, on virtual time: what a Modbus link meets beyond the bytes.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/cnc/modbus/register_bus.h"
#include "core/cnc/modbus/register_map.h"
#include "tests/support/virtual_clock.h"

namespace stillcut::cnc::testing {

// Registers with a PLC behind them that multiplies, follows, and restores 100 % when the heartbeat stops.
struct FakePlc {
  std::map<std::pair<RegisterTable, int>, std::uint16_t> words;
  bool refuses = false;  // exception replies
  bool lies = false;     // acknowledges and does nothing
  bool running = true;
  bool silent = false;        // no reply at all
  int refused = -1;           // a write to this register gets an exception
  int refusesFrom = 1 << 16;  // a read of so many words gets an exception, but for the two of the actual speed
  int lostReply = -1;         // this register is written, and the reply is lost
  bool gone = false;          // no connection
  bool cut = false;           // the connection ends now; another may be made
  int garbled = 0;            // so many of the next replies are none
  bool watched = true;        // it restores 100 % by itself
  Duration latency = std::chrono::milliseconds(1);
  int operatorKnob = 100;
  int writes = 0;
  Instant lastBeat{};

  std::uint16_t& holding(int address) { return words[{RegisterTable::Holding, address}]; }
  double factor() { return holding(100) == 0 ? 1.0 : holding(100) / 1000.0; }
  void run(Instant now) {
    if (watched && now - lastBeat > std::chrono::milliseconds(200)) holding(100) = holding(101) = 1000;
    holding(0) = 8000;
    holding(1) = 600;
    holding(2) = static_cast<std::uint16_t>(operatorKnob);
    holding(3) = static_cast<std::uint16_t>(std::lround(operatorKnob * factor()));
    const auto speed = static_cast<std::uint32_t>(std::lround(80000.0 * operatorKnob / 100.0 * factor()));
    words[{RegisterTable::Input, 10}] = static_cast<std::uint16_t>(speed >> 16U);
    words[{RegisterTable::Input, 11}] = static_cast<std::uint16_t>(speed);
    words[{RegisterTable::Input, 0}] = running ? 1U << 4U : 0;
  }
};

class FakeBus final : public RegisterBus {
 public:
  FakeBus(test::VirtualClock& clock, FakePlc& plc) : clock_(clock), plc_(plc) {}
  std::string_view address() const noexcept override { return "plc:502 unit 1"; }
  void connect() noexcept override { state_ = plc_.gone ? WireState::Closed : WireState::Open; }
  WireState state() noexcept override {
    if (std::exchange(plc_.cut, false) || plc_.gone) close();
    return state_;
  }
  bool read(RegisterTable table, int first, int count) noexcept override {
    const bool tooMany = count >= plc_.refusesFrom && !(table == RegisterTable::Input && first == 10);
    BusReply reply{!plc_.refuses && !tooMany, {}};
    for (int i = 0; i < count; ++i) reply.words[static_cast<std::size_t>(i)] = plc_.words[{table, first + i}];
    return begin(reply);
  }
  bool write(RegisterTable table, int first, int count, const RegisterWords& words) noexcept override {
    ++plc_.writes;
    if (first == plc_.refused) return begin({false, {}});
    if (!plc_.refuses && !plc_.silent && !plc_.lies) {
      for (int i = 0; i < count; ++i) plc_.words[{table, first + i}] = words[static_cast<std::size_t>(i)];
      if (first == 102) plc_.lastBeat = clock_.now();
    }
    return begin({!plc_.refuses && first != plc_.lostReply, {}});
  }
  bool busy() const noexcept override { return reply_.has_value(); }
  std::optional<BusReply> take() noexcept override {
    if (!reply_ || clock_.now() < ready_) return std::nullopt;
    return std::exchange(reply_, std::nullopt);
  }
  void wait(Duration atMost) noexcept override {
    clock_.advance(toSeconds(reply_ ? std::min(atMost, std::max(Duration::zero(), ready_ - clock_.now())) : atMost));
  }
  void close() noexcept override {
    state_ = WireState::Closed;
    reply_.reset();
  }

 private:
  bool begin(const BusReply& reply) {
    reply_ = reply;
    if (plc_.silent || (plc_.garbled > 0 && plc_.garbled-- > 0)) reply_->ok = false;
    ready_ = clock_.now() + (plc_.silent ? std::chrono::milliseconds(200) : plc_.latency);
    return true;
  }
  test::VirtualClock& clock_;
  FakePlc& plc_;
  WireState state_ = WireState::Closed;
  std::optional<BusReply> reply_;
  Instant ready_{};
};

inline RegisterMap exampleMap() {
  auto map = loadRegisterMap(STILLCUT_SOURCE_DIR "/resources/machines/modbus-example.toml");
  if (!map) throw std::runtime_error(map.error().line());
  map->watchdog = true;  // FakePlc has one
  return std::move(map).value();
}

}  // namespace stillcut::cnc::testing
