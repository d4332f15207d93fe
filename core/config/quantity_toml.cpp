#include "core/config/quantity_toml.h"

namespace stillcut::config {

SensorQuantity readQuantity(const TomlTable& table) {
  const std::string word = table.text("quantity");
  if (const auto known = sensorQuantityFromName(word)) return *known;
  table.refuse("quantity", message("is unknown: '%1'", word),
               message("choices: acceleration, velocity, displacement, sound, force, current, speed"));
  return {};
}

}  // namespace stillcut::config
