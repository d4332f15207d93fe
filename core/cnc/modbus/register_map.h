// RegisterMap: which register of a spindle drive or PLC gateway means what. A TOML file; resources/machines has a
// documented example.
//   version = 1
//   label = "Drive 7"
//   watchdog = true                  the machine itself restores 100 % when the heartbeat stops
//   [bus]      host, port  or  device, baud, parity, stop_bits;  unit, answer_ms
//   [override] lowest_speed_percent, highest_speed_percent, lowest_feed_percent, highest_feed_percent
//   [read.actual_speed]   table, address, words, float, high_word_first, signed, bit, scale, offset, lowest, highest,
//   poll_ms [write.speed_override] the same without lowest, highest and poll_ms; [write.heartbeat] with period_ms
// value = raw * scale + offset, in rev/min, mm/min or percent; a flag is a bit, or raw != 0. A value that is read and
// lies outside of lowest to highest is not believed. Thread: set-up; values afterwards.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/cnc/modbus/register_bus.h"

namespace stillcut::cnc {

enum class MachineSignal : std::uint8_t {
  ProgrammedSpeed,  // rev/min; required
  ProgrammedFeed,   // mm/min
  ActualSpeed,      // rev/min; required
  ActualFeed,       // mm/min
  SpeedOverride,    // %, in force
  FeedOverride,     // %, in force
  OperatorSpeed,    // %, the operator's own knob
  OperatorFeed,     // %
  Running,          // program runs
  FeedHold,
  AtSpeed,
  OverridesEnabled,
  Heartbeat,  // as it stands there, whoever wrote it
};
inline constexpr std::size_t kMachineSignals = 13;
std::string_view name(MachineSignal s);  // as the file has it: "actual_speed"

enum class MachineCommand : std::uint8_t {
  SpeedOverride,  // %; required
  FeedOverride,   // %
  Control,        // flag: 1 while we are in command
  Heartbeat,      // counts while we are in command
};
inline constexpr std::size_t kMachineCommands = 4;

struct Register {
  RegisterTable table = RegisterTable::Holding;
  int address = 0;       // 0..65535, as on the wire (not 40001-based)
  int words = 1;         // 1 or 2
  bool isFloat = false;  // IEEE 754, of two words
  bool highWordFirst = true;
  bool isSigned = false;
  int bit = -1;  // flags in a word: 0..15
  double scale = 1.0, offset = 0.0;
  std::optional<double> lowest{}, highest{};  // of a value that can be; none: as far as its kind reaches
  Seconds period{0.05};                       // between two polls, or two heartbeats

  double decode(const RegisterWords& raw) const noexcept;
  bool flag(const RegisterWords& raw) const noexcept;
  // Nearest raw value; nothing when it does not fit.
  std::optional<RegisterWords> encode(double value) const noexcept;
};

struct RegisterMap {
  std::string label;
  bool watchdog = false;
  BusAddress bus;
  Ratio lowestSpeed{1.0}, highestSpeed{1.0}, lowestFeed{1.0}, highestFeed{1.0};
  std::array<std::optional<Register>, kMachineSignals> read;
  std::array<std::optional<Register>, kMachineCommands> write;

  const std::optional<Register>& at(MachineSignal s) const { return read[static_cast<std::size_t>(s)]; }
  const std::optional<Register>& at(MachineCommand o) const { return write[static_cast<std::size_t>(o)]; }
};

Result<RegisterMap> loadRegisterMap(const std::string& path);
// The same from text; `name` stands for the file.
Result<RegisterMap> parseRegisterMap(std::string_view content, const std::string& name);

}  // namespace stillcut::cnc
