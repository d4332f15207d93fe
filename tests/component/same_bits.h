// Whether two results are the same, bit by bit: doubles by their bit pattern, so that -0 is not 0 and every NaN is only
// itself. Each struct is taken apart by structured bindings: a field added later does not compile until it is compared.
#pragma once

#include <array>
#include <bit>
#include <chrono>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>

#include "core/model/step_record.h"

namespace stillcut::test {

template <class T>
requires std::integral<T> || std::is_enum_v<T>
bool same(T a, T b) {
  return a == b;
}
inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same(Instant a, Instant b) {
  return a == b;
}
inline bool same(Duration a, Duration b) {
  return a == b;
}
template <class Quantity>
requires std::same_as<decltype(Quantity::value), double>
bool same(Quantity a, Quantity b) {
  return same(a.value, b.value);
}
template <std::size_t N>
bool same(const std::array<double, N>& a, const std::array<double, N>& b) {
  for (std::size_t i = 0; i < N; ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

inline bool same(const Reason& a, const Reason& b) {
  const auto& [code, n] = a;
  return same(code, b.code) && same(n, b.n);
}
inline bool same(const Verdict& a, const Verdict& b) {
  const auto& [time, sequence, state, phase, kind, valid, warning, reason, frequency, sd, severity, spindle, since,
               feed, indicators] = a;
  return same(time, b.time) && same(sequence, b.blockSequence) && same(state, b.state) && same(phase, b.phase) &&
         same(kind, b.kind) && same(valid, b.valid) && same(warning, b.earlyWarning) && same(reason, b.reason) &&
         same(frequency, b.frequency) && same(sd, b.frequencySd) && same(severity, b.severity) &&
         same(spindle, b.spindle) && same(since, b.sinceOnset) && same(feed, b.feedSinceOnset) &&
         same(indicators, b.indicators);
}
inline bool same(const OverrideRequest& a, const OverrideRequest& b) {
  const auto& [time, kind, claimsSpeed, claimsFeed, speed, feed, reason] = a;
  return same(time, b.time) && same(kind, b.kind) && same(claimsSpeed, b.claimsSpeed) &&
         same(claimsFeed, b.claimsFeed) && same(speed, b.speed) && same(feed, b.feed) && same(reason, b.reason);
}
inline bool same(const CommandRecord& a, const CommandRecord& b) {
  const auto& [time, sequence, kind, speed, feed, lease, reason, engagement] = a;
  return same(time, b.time) && same(sequence, b.sequence) && same(kind, b.kind) && same(speed, b.speed) &&
         same(feed, b.feed) && same(lease, b.lease) && same(reason, b.reason) && same(engagement, b.engagement);
}
inline bool same(const Event& a, const Event& b) {
  const auto& [time, number, level, reason] = a;
  return same(time, b.time) && same(number, b.number) && same(level, b.level) && same(reason, b.reason);
}

// Empty: the same. Otherwise what differs first.
inline std::string difference(const StepOutput& a, const StepOutput& b) {
  const auto& [verdictCount, inCharge, verdicts, request, hasCommand, command, authority, eventCount, events] = a;
  if (!same(verdictCount, b.verdictCount)) return "number of verdicts";
  for (int i = 0; i < verdictCount; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!same(verdicts[at], b.verdicts[at])) return "verdict " + std::to_string(i);
  }
  if (!same(inCharge, b.inCharge)) return "detector in charge";
  if (!same(request, b.request)) return "request";
  if (!same(hasCommand, b.hasCommand)) return "whether there is a command";
  if (hasCommand && !same(command, b.command)) return "command";
  if (!same(authority, b.authority)) return "authority";
  if (!same(eventCount, b.eventCount)) return "number of events";
  for (int i = 0; i < eventCount; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!same(events[at], b.events[at])) return "event " + std::to_string(i);
  }
  return {};
}

}  // namespace stillcut::test
