// Sender: brings what the outbox keeps to the broker, in order, and takes out what the broker has. Thread: one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/shop/mqtt_client.h"
#include "app/shop/outbox.h"

namespace stillcut::shop {

class Sender {
 public:
  virtual ~Sender() = default;
  virtual Status begin() = 0;
  // What can go goes. Does not block, but once: where the first connection after a start clears the session that a
  // process before left at the broker, it waits up to two seconds for that connection to end (MqttClient::close()).
  virtual Status turn(std::int64_t nowMs) = 0;
  // Sequences that the broker has, since the last call; they may leave the outbox.
  virtual std::vector<std::uint64_t> takeDelivered() = 0;
  virtual pollfd entry() const = 0;
  // Tells that this program ends in order, and ends the connection.
  virtual void end() = 0;
  virtual std::string takeProblem() = 0;
  virtual bool connected() const = 0;
};

}  // namespace stillcut::shop
