// What goes between KeptLink, in the program, and stillcut-keeper, over a socket of whole messages: first one text of
// each, then orders one way and reports the other. Every order is a sign of life too. Both ends are of the same build
// on the same computer, so that their clocks are one. Plain values: any thread.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/cnc/cnc_link.h"
#include "core/cnc/override_memory.h"

namespace stillcut::app {

// No sign of life for so long: the program has died or hangs. As long as that of stillcut-hal.
inline constexpr Duration kKeeperPatience = std::chrono::milliseconds(60);

// The program's first.
struct KeeperBegin {
  std::string link;  // as cnc::linkTable() has it
  std::map<std::string, std::string> settings;
  std::string folder;
  Rpm programmedSpeed{};
  MetresPerSecond programmedFeed{};
  bool silentOutputs = false;  // analog outputs are opened and not written
  std::string locks;           // as makeOneProgramLink() takes it
  int owner = 0;               // process
  // Where it takes the place of a keeper that has died: what that one left standing, to be brought back.
  std::optional<cnc::SentOverrides> left;
};

// And the keeper's: the link is open, or why not.
struct KeeperOpened {
  std::string label;
  std::optional<Error> refused;
};

struct KeeperOrder {
  enum class Kind : std::uint8_t { Life, Set, Release, Adopt, Close };
  Kind kind = Kind::Life;
  std::uint64_t number = 0;                                  // of a Release, counted
  double speed = 0.0, feed = 0.0;                            // of Adopt; not a number: none
  std::array<std::byte, sizeof(OverrideCommand)> command{};  // of Set

  void carry(const OverrideCommand& c) noexcept;
  // The gate's own command, made in the program and carried here as it is. Nothing: no gate makes such a one.
  std::optional<OverrideCommand> carried() const noexcept;
};

struct KeeperReport {
  MachineState state;
  std::uint64_t released = 0;  // the number of the Release that was obeyed last
  // Of LinkInfo, what may change while it runs.
  bool machineWatchdog = false;
  Ratio lowestSpeed{1.0}, highestSpeed{1.0}, lowestFeed{1.0}, highestFeed{1.0};
  Seconds period{};

  void take(const cnc::LinkInfo& info) noexcept;
  void giveTo(cnc::LinkInfo& info) const noexcept;
};

std::string toText(const KeeperBegin& begin);
std::string toText(const KeeperOpened& opened);
// Nothing: the other end is no end of this build.
std::optional<KeeperBegin> keeperBeginFrom(const std::string& text);
std::optional<KeeperOpened> keeperOpenedFrom(const std::string& text);

inline constexpr std::size_t kLongestKeeperText = 1U << 16U;

}  // namespace stillcut::app
