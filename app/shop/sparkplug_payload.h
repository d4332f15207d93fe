// The payload of Sparkplug B (Eclipse Sparkplug 3.0, sparkplug_b.proto) as bytes: the few fields of it that an edge
// node writes, and the one request that it reads. Any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stillcut::shop::sparkplug {

// Numbers are the specification's.
enum class DataType : std::uint32_t { UInt64 = 8, Double = 10, Boolean = 11, String = 12 };

struct Metric {
  std::string name;  // empty: by its alias alone
  std::uint64_t alias = 0;
  bool hasAlias = false;
  DataType type = DataType::Double;
  std::int64_t utcMs = 0;
  bool historical = false;
  std::variant<std::monostate, std::uint64_t, double, bool, std::string> value;  // monostate: null
};

struct Payload {
  std::int64_t utcMs = 0;
  int sequence = -1;  // 0 to 255; -1: none, as in a death certificate
  std::vector<Metric> metrics;
};

std::string encode(const Payload& payload);

// Whether a command asks for a new birth certificate: "Node Control/Rebirth" is true. Whatever else it holds, and
// whatever is no payload at all, is passed over.
bool asksForRebirth(std::string_view bytes);

inline constexpr const char* kRebirth = "Node Control/Rebirth";

}  // namespace stillcut::shop::sparkplug
