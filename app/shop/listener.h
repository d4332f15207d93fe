// Listener: who hears the lines of a run as they come, beside the broker, and keeps nothing. Thread: one.
#pragma once

#include <poll.h>

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace stillcut::shop {

class Listener {
 public:
  virtual ~Listener() = default;
  virtual void hear(const nlohmann::json& line) = 0;
  // What it waits for, and what is done when that or a second has come. Never blocks.
  virtual void addEntries(std::vector<pollfd>& entries) const = 0;
  virtual void turn() = 0;
};

}  // namespace stillcut::shop
