#include "core/cnc/linuxcnc/emc_status.h"

#include <cmath>

#include "core/base/conversions.h"
#include "core/cnc/wire_number.h"

namespace stillcut::cnc {
namespace {

constexpr double kMostPercent = 1000.0;
constexpr double kFastestSpindle = 1e6;  // rev/min
constexpr double kFastestFeed = 1e7;     // units/min

bool percent(std::string_view word, TimedValue<int>& into, Instant now) noexcept {
  const auto value = wireNumber(word);
  if (!value || *value < 0.0 || *value > kMostPercent) return false;
  into.set(static_cast<int>(std::lround(*value)), now);
  return true;
}

bool onOff(std::string_view word, TimedValue<bool>& into, Instant now) noexcept {
  if (word != "ON" && word != "OFF") return false;
  into.set(word == "ON", now);
  return true;
}

bool truth(std::string_view word, TimedValue<bool>& into, Instant now) noexcept {
  if (word != "TRUE" && word != "FALSE") return false;
  into.set(word == "TRUE", now);
  return true;
}

bool speed(std::string_view word, double perUnit, TimedValue<Rpm>& into, Instant now) noexcept {
  const auto value = wireNumber(word);
  if (!value || std::abs(*value * perUnit) > kFastestSpindle) return false;
  into.set(Rpm(std::abs(*value * perUnit)), now);  // backwards is a speed too
  return true;
}

}  // namespace

bool EmcStatus::take(std::string_view line, Instant now) noexcept {
  const std::string_view word = takeToken(line);
  if (word == "PINVAL") return takePin(line, now);
  if (word == "FEED_OVERRIDE") return percent(takeToken(line), feedOverride, now);
  if (word == "SPINDLE_OVERRIDE") {
    if (takeToken(line) != "0") return false;
    const std::string_view value = takeToken(line);
    if (!percent(value, spindleOverride, now)) return false;
    decimals = decimals || value.find('.') != std::string_view::npos;
    return true;
  }
  if (word == "PROGRAM_CODES") return takeCodes(line, now);
  if (word == "MACHINE") return onOff(takeToken(line), machineOn, now);
  if (word == "ENABLE") return onOff(takeToken(line), inControl, now);
  if (word == "PROGRAM_STATUS") {
    const std::string_view status = takeToken(line);
    if (status != "IDLE" && status != "RUNNING" && status != "PAUSED") return false;
    program.set(status == "RUNNING"  ? EmcProgram::Running
                : status == "PAUSED" ? EmcProgram::Paused
                                     : EmcProgram::Idle,
                now);
    return true;
  }
  return false;
}

// "G80 G17 ... G21 ... F600 S5000"
bool EmcStatus::takeCodes(std::string_view words, Instant now) noexcept {
  double unit = 1e-3;
  std::optional<double> f, s;
  while (true) {
    const std::string_view word = takeToken(words);
    if (word.empty()) break;
    if (word == "G20") unit = kInch;
    if (word == "G21") unit = 1e-3;
    if (word.front() == 'F') f = wireNumber(word.substr(1));
    if (word.front() == 'S') s = wireNumber(word.substr(1));
  }
  if (!f || !s || *f < 0.0 || *f > kFastestFeed || std::abs(*s) > kFastestSpindle) return false;
  feedWord.set(MetresPerSecond(*f * unit / 60.0), now);
  speedWord.set(Rpm(std::abs(*s)), now);
  return true;
}

bool EmcStatus::takePin(std::string_view words, Instant now) noexcept {
  const std::string_view pin = takeToken(words);
  const std::string_view value = takeToken(words);
  if (pin == "spindle.0.speed-in") return speed(value, 60.0, actualSpeed, now);
  if (pin == "spindle.0.speed-out") return speed(value, 1.0, commandedSpeed, now);
  if (pin == "spindle.0.at-speed") return truth(value, atSpeed, now);
  if (pin == "motion.feed-hold") return truth(value, feedHold, now);
  const auto number = wireNumber(value);
  if (!number) return false;
  if (pin == "motion.adaptive-feed" && std::abs(*number) <= 1.0) {
    adaptiveFeed.set(*number, now);
    return true;
  }
  if (pin == "motion.current-vel" && std::abs(*number) <= kFastestFeed / 60.0) {
    currentFeed.set(MetresPerSecond(std::abs(*number) * machineUnit), now);
    return true;
  }
  return false;
}

}  // namespace stillcut::cnc
