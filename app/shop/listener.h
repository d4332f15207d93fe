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
  // What was heard before this program began again: the start of the run, and then its newest line. For whoever tells
  // of what stands and not only of what comes.
  virtual void recall(const nlohmann::json& /*line*/) {}
  // What it waits for, and what is done when that or a second has come. Never blocks.
  virtual void addEntries(std::vector<pollfd>& entries) const = 0;
  virtual void turn() = 0;
};

}  // namespace stillcut::shop
