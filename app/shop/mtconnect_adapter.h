// MtConnectAdapter: the run as an MTConnect adapter speaks it (SHDR lines over TCP), for an agent of the shop's own.
// Chatter is a CONDITION; packaging/shop/mtconnect/Devices.xml names every item. What agents send is a "* PING" and
// nothing else: all other words are passed over. Thread: one.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "app/shop/listener.h"
#include "core/base/result.h"

namespace stillcut::shop {

class MtConnectAdapter final : public Listener {
 public:
  MtConnectAdapter() = default;
  ~MtConnectAdapter() override;
  MtConnectAdapter(const MtConnectAdapter&) = delete;
  MtConnectAdapter& operator=(const MtConnectAdapter&) = delete;

  // "7878": for programs of this computer alone; "0.0.0.0:7878": for any.
  Status listen(const std::string& where);
  int port() const { return port_; }

  void hear(const nlohmann::json& line) override;
  void recall(const nlohmann::json& line) override { hear(line); }
  void addEntries(std::vector<pollfd>& entries) const override;
  void turn() override;

  static constexpr std::size_t kMostClients = 16;
  static constexpr std::size_t kMostWaiting = 1U << 20U;  // bytes that an agent leaves untaken before it is let go

 private:
  struct Client {
    int socket;
    std::string in, out;
  };
  void set(std::int64_t utcMs, const std::string& item, const std::string& value);
  void accept();
  void serve(Client& client);
  static void letGo(Client& client);
  void flush();

  int listener_ = -1, port_ = 0;
  std::vector<Client> clients_;
  std::map<std::string, std::string> items_;  // by name: the line as told last, without its time
  std::int64_t newestUtcMs_ = 0;
};

}  // namespace stillcut::shop
