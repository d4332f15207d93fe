#include "core/cnc/modbus/register_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "core/config/toml_reader.h"

namespace stillcut::cnc {
namespace {

using config::TomlReader;
using config::TomlTable;

constexpr int kVersion = 1;
constexpr std::array<std::string_view, kMachineSignals> kSignals{
    "programmed_speed", "programmed_feed",   "actual_speed",  "actual_feed", "speed_override",
    "feed_override",    "operator_speed",    "operator_feed", "running",     "feed_hold",
    "at_speed",         "overrides_enabled", "heartbeat"};
constexpr std::array<std::string_view, kMachineCommands> kOrders{"speed_override", "feed_override", "control",
                                                                 "heartbeat"};

Register readRegister(const TomlTable& table, std::string_view periodKey, double period) {
  Register r;
  r.table = static_cast<RegisterTable>(table.choiceOr("table", 3, {"coil", "discrete", "input", "holding"}));
  r.address = table.integer("address", 0, 65535);
  r.isFloat = table.booleanOr("float", false);
  r.words = table.integerOr("words", r.isFloat ? 2 : 1, 1, 2);
  r.highWordFirst = table.booleanOr("high_word_first", true);
  r.isSigned = table.booleanOr("signed", false);
  r.bit = table.integerOr("bit", -1, 0, 15);
  r.scale = table.numberOr("scale", 1.0, -1e9, 1e9);
  r.offset = table.numberOr("offset", 0.0, -1e9, 1e9);
  if (r.isFloat && (r.words == 1 || r.isSigned || r.bit >= 0)) {
    table.refuse("float", message("is true beside 'words = 1', 'signed' or 'bit'"),
                 message("a float has two words and a sign of its own, and is no flag"));
  }
  if (!periodKey.empty()) r.period = Seconds(table.numberOr(periodKey, period, 5.0, 10000.0) * 1e-3);
  if (r.scale == 0.0) table.refuse("scale", message("is 0"), message("every value would be the offset"));
  const bool bits = r.table == RegisterTable::Coil || r.table == RegisterTable::Discrete;
  if (bits && r.words != 1) table.refuse("words", message("is 2"), message("a coil or discrete input is one bit"));
  if (r.address + r.words > 65536) table.refuse("address", message("leaves no room for two words"));
  return r;
}

void readBus(const TomlTable& table, BusAddress& bus) {
  const bool serial = table.has("device");
  if (serial == table.has("host")) {
    table.refuse(serial ? "host" : "",
                 serial ? message("is given beside 'device'") : message("neither 'host' nor 'device' is given"),
                 message("one of them says where the machine is"));
  }
  if (serial) {
    constexpr std::string_view kParities = "NEO";
    bus.wire.device = table.text("device");
    bus.wire.baud = table.integerOr("baud", 19200, 1200, 4'000'000);
    bus.parity = kParities[static_cast<std::size_t>(table.choiceOr("parity", 1, {"none", "even", "odd"}))];
    bus.stopBits = table.integerOr("stop_bits", 1, 1, 2);
  } else {
    bus.wire.host = table.textOr("host", "localhost");
    bus.wire.port = table.integerOr("port", 502, 1, 65535);
  }
  bus.unit = table.integerOr("unit", 1, 0, 247);
  bus.answerWithin = Seconds(table.numberOr("answer_ms", 200.0, 5.0, 5000.0) * 1e-3);
}

void readRange(const TomlTable& table, Register& r) {
  if (table.has("lowest")) r.lowest = table.number("lowest", -1e9, 1e9);
  if (table.has("highest")) r.highest = table.number("highest", -1e9, 1e9);
  if (r.lowest && r.highest && *r.lowest >= *r.highest) {
    table.refuse("lowest", message("is not below 'highest'"), message("no value would be believed"));
  }
}

// Free keys, each one of `names`.
template <std::size_t N>
void readGroup(const TomlTable& group, const std::array<std::string_view, N>& names, std::string_view periodKey,
               double period, std::array<std::optional<Register>, N>& into) {
  for (std::size_t i = 0; i < N; ++i) {
    if (group.has(names[i])) into[i] = readRegister(group.table(names[i]), periodKey, period);
  }
}

template <std::size_t N>
void require(const TomlTable& group, const std::array<std::string_view, N>& names, std::size_t which,
             const std::array<std::optional<Register>, N>& registers) {
  if (!registers[which])
    group.refuse(names[which], message("is missing"), message("without it nothing can be told or done"));
}

Result<RegisterMap> read(TomlReader in) {
  RegisterMap map;
  const TomlTable root = in.root();
  root.integer("version", kVersion, kVersion);
  map.label = root.textOr("label", "Modbus machine");
  map.watchdog = root.booleanOr("watchdog", false);
  readBus(root.table("bus"), map.bus);
  const TomlTable range = root.table("override");
  map.lowestSpeed = Ratio(range.number("lowest_speed_percent", 1.0, 100.0) * 0.01);
  map.highestSpeed = Ratio(range.number("highest_speed_percent", 100.0, 400.0) * 0.01);
  map.lowestFeed = Ratio(range.numberOr("lowest_feed_percent", 100.0, 0.0, 100.0) * 0.01);
  map.highestFeed = Ratio(range.numberOr("highest_feed_percent", 100.0, 100.0, 400.0) * 0.01);
  const TomlTable reads = root.table("read");
  const TomlTable writes = root.table("write");
  readGroup(reads, kSignals, "poll_ms", 50.0, map.read);
  for (std::size_t i = 0; i < kMachineSignals; ++i) {
    if (map.read[i]) readRange(reads.table(kSignals[i]), *map.read[i]);
  }
  readGroup(writes, kOrders, "period_ms", 50.0, map.write);
  require(reads, kSignals, static_cast<std::size_t>(MachineSignal::ProgrammedSpeed), map.read);
  require(reads, kSignals, static_cast<std::size_t>(MachineSignal::ActualSpeed), map.read);
  require(writes, kOrders, static_cast<std::size_t>(MachineCommand::SpeedOverride), map.write);
  for (std::size_t i = 0; i < kMachineCommands; ++i) {
    const auto& r = map.write[i];
    if (r && (r->table == RegisterTable::Discrete || r->table == RegisterTable::Input)) {
      writes.table(kOrders[i]).refuse("table", message("cannot be written"), message("coil or holding"));
    }
  }
  if (map.at(MachineSignal::Heartbeat) && !map.at(MachineCommand::Heartbeat)) {
    reads.refuse("heartbeat", message("is read without [write.heartbeat]"),
                 message("another Stillcut could not be told from none"));
  }
  if (map.watchdog && !map.at(MachineCommand::Heartbeat)) {
    root.refuse("watchdog", message("is true without [write.heartbeat]"), message("what would the machine watch?"));
  }
  if (Status done = in.finish(); !done) return done.error();
  return map;
}

}  // namespace

std::string_view name(MachineSignal s) {
  return kSignals[static_cast<std::size_t>(s)];
}

double Register::decode(const RegisterWords& raw) const noexcept {
  if (words == 1) {
    const double value = isSigned ? static_cast<std::int16_t>(raw[0]) : raw[0];
    return value * scale + offset;
  }
  const std::uint32_t high = highWordFirst ? raw[0] : raw[1];
  const std::uint32_t low = highWordFirst ? raw[1] : raw[0];
  const std::uint32_t both = (high << 16U) | low;
  if (isFloat) return static_cast<double>(std::bit_cast<float>(both)) * scale + offset;
  return (isSigned ? static_cast<double>(static_cast<std::int32_t>(both)) : static_cast<double>(both)) * scale + offset;
}

bool Register::flag(const RegisterWords& raw) const noexcept {
  return bit >= 0 ? ((raw[0] >> static_cast<unsigned>(bit)) & 1U) != 0 : raw[0] != 0;
}

std::optional<RegisterWords> Register::encode(double value) const noexcept {
  std::uint32_t both = 0;
  if (isFloat) {
    const auto raw = static_cast<float>((value - offset) / scale);
    if (!std::isfinite(raw)) return std::nullopt;
    both = std::bit_cast<std::uint32_t>(raw);
  } else {
    const double raw = std::round((value - offset) / scale);
    const double span = words == 1 ? 65536.0 : 4294967296.0;
    const double least = isSigned ? -span / 2.0 : 0.0;
    if (!(raw >= least && raw < least + span)) return std::nullopt;
    both = static_cast<std::uint32_t>(static_cast<std::int64_t>(raw));
  }
  const auto high = static_cast<std::uint16_t>(both >> 16U);
  const auto low = static_cast<std::uint16_t>(both);
  if (words == 1) return RegisterWords{low, 0};
  return highWordFirst ? RegisterWords{high, low} : RegisterWords{low, high};
}

Result<RegisterMap> loadRegisterMap(const std::string& path) {
  return read(TomlReader::file(path));
}

Result<RegisterMap> parseRegisterMap(std::string_view content, const std::string& name) {
  return read(TomlReader::text(content, name));
}

}  // namespace stillcut::cnc
