// What is told to a shop: one message below the machine's topic, as resources/manual/shop.md lists them.
// Plain values: any thread.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace stillcut::shop {

// The schema of every payload. The number is raised where a field changes its meaning or goes.
inline constexpr std::string_view kShopSchema = "stillcut-shop/1";

struct ShopMessage {
  std::string topic;       // below the machine's: "state", "event/alarm"
  nlohmann::json payload;  // an object; schema, series and sequence are added where it is kept (Outbox)
  bool retained = false;   // the broker gives the newest one to whoever comes later
};

std::int64_t utcNowMs();

}  // namespace stillcut::shop
