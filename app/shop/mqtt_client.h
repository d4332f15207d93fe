// MqttClient: one connection to a broker through libmosquitto, which comes back by itself. Nothing here blocks but the
// look-up of the broker's name. Callbacks come out of turn(). Thread: one.
#pragma once

#include <poll.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

struct mosquitto;

namespace stillcut::shop {

struct BrokerOptions {
  std::string host;  // empty: no broker, everything is kept
  int port = 0;      // 0: 1883, with TLS 8883
  std::string user, passwordFile;
  std::string ca, certificate, key;  // PEM; `ca` alone makes it TLS
  std::string clientId;
};

class MqttClient {
 public:
  struct Owner {
    virtual ~Owner() = default;
    // Before each attempt: the place to set the will.
    virtual void connecting() = 0;
    // `kept`: the broker still has the session of before.
    virtual void connected(bool kept) = 0;
    virtual void disconnected() = 0;
    // What publish() has numbered is the broker's.
    virtual void delivered(int number) = 0;
    virtual void received(std::string_view topic, std::string_view payload) = 0;
  };

  MqttClient(BrokerOptions options, Owner& owner);
  ~MqttClient();
  MqttClient(const MqttClient&) = delete;
  MqttClient& operator=(const MqttClient&) = delete;

  // A new connection that remembers nothing; `clean`: nor does the broker. Not from within a callback.
  Status renew(bool clean);
  bool connected() const { return connected_; }
  void setWill(const std::string& topic, std::string_view payload, int qos, bool retained);
  // Its number, nothing where it could not be taken.
  std::optional<int> publish(const std::string& topic, std::string_view payload, int qos, bool retained);
  void subscribe(const std::string& topic);
  // Goes on until `done`, for at most two seconds. False: it is not, or the connection broke.
  bool work(const std::function<bool()>& done);
  // Ends the connection in order: no will. Hands over what was published, for at most two seconds.
  void close();
  // What came and what can go. `nowMs` of a steady clock.
  void turn(std::int64_t nowMs);
  pollfd entry() const;  // fd -1: not connected
  // Why it is not connected, once for each cause; for whoever reads the log. Empty: nothing new.
  std::string takeProblem();

 private:
  Status configure();
  void lost();
  void tellUnlessTold(int rc);
  static void onConnect(mosquitto*, void* self, int code, int flags);
  static void onDisconnect(mosquitto*, void* self, int code);
  static void onPublish(mosquitto*, void* self, int number);
  static void onLog(mosquitto* client, void* self, int level, const char* line);

  BrokerOptions options_;
  Owner& owner_;
  mosquitto* client_ = nullptr;
  bool connected_ = false, begun_ = false;
  bool stands_ = false;  // the TCP connection; the broker may not have said a word yet
  std::int64_t nextTryMs_ = 0, waitMs_ = 0;
  std::string problem_, untold_;  // as told last, and since
  std::string tlsError_;          // of the newest try
  bool answered_ = false;         // some connection was accepted or refused by the broker itself
};

}  // namespace stillcut::shop
