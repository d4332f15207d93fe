// PlotSender: every state of the run as one UDP datagram of JSON, its numbers alone, as PlotJuggler's UDP server takes
// them. Nobody has to listen. Thread: one.
#pragma once

#include <netinet/in.h>

#include <string>

#include "app/shop/listener.h"
#include "core/base/result.h"

namespace stillcut::shop {

class PlotSender final : public Listener {
 public:
  PlotSender() = default;
  ~PlotSender() override;
  PlotSender(const PlotSender&) = delete;
  PlotSender& operator=(const PlotSender&) = delete;

  Status open(const std::string& where);  // "127.0.0.1:9870"

  void hear(const nlohmann::json& line) override;
  void addEntries(std::vector<pollfd>& /*entries*/) const override {}
  void turn() override {}

 private:
  int socket_ = -1;
  sockaddr_in to_{};
};

}  // namespace stillcut::shop
