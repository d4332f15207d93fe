#include "app/shop/mqtt_client.h"

#include <mosquitto.h>

#include <algorithm>
#include <fstream>
#include <utility>

#include "core/base/time.h"

namespace stillcut::shop {
namespace {

constexpr int kKeepAlive_s = 20;
constexpr std::int64_t kFirstWaitMs = 100, kLongestWaitMs = 15'000;
constexpr int kMostReads = 200;  // packets in one turn
constexpr int kWaitMs = 50;
constexpr Seconds kLongestWork{2.0};

MqttClient* of(void* self) {
  return static_cast<MqttClient*>(self);
}

}  // namespace

MqttClient::MqttClient(BrokerOptions options, Owner& owner) : options_(std::move(options)), owner_(owner) {
  mosquitto_lib_init();
  if (options_.port == 0) options_.port = options_.ca.empty() ? 1883 : 8883;
}

MqttClient::~MqttClient() {
  if (client_ != nullptr) mosquitto_destroy(client_);
  mosquitto_lib_cleanup();
}

Status MqttClient::renew(bool clean) {
  if (client_ != nullptr) mosquitto_destroy(client_);
  connected_ = begun_ = stands_ = false;
  nextTryMs_ = waitMs_ = 0;
  client_ = mosquitto_new(options_.clientId.c_str(), clean, this);
  return configure();
}

Status MqttClient::configure() {
  if (client_ == nullptr) return Error{options_.clientId, message("is no name for a client of the broker")};
  mosquitto_connect_with_flags_callback_set(client_, onConnect);
  mosquitto_disconnect_callback_set(client_, onDisconnect);
  mosquitto_publish_callback_set(client_, onPublish);
  mosquitto_log_callback_set(client_, onLog);
  mosquitto_message_callback_set(client_, [](mosquitto*, void* self, const mosquitto_message* m) {
    of(self)->owner_.received(m->topic,
                              {static_cast<const char*>(m->payload), static_cast<std::size_t>(m->payloadlen)});
  });
  if (!options_.user.empty()) {
    std::string password;
    if (!options_.passwordFile.empty()) {
      std::ifstream file(options_.passwordFile);
      if (!std::getline(file, password)) return Error{options_.passwordFile, message("holds no password")};
    }
    mosquitto_username_pw_set(client_, options_.user.c_str(), password.empty() ? nullptr : password.c_str());
  }
  if (options_.ca.empty()) return Done{};
  const auto given = [](const std::string& path) { return path.empty() ? nullptr : path.c_str(); };
  const int rc = mosquitto_tls_set(client_, options_.ca.c_str(), nullptr, given(options_.certificate),
                                   given(options_.key), nullptr);
  return rc == MOSQ_ERR_SUCCESS ? Status(Done{})
                                : Error{options_.ca, message("TLS cannot be set up"), foreign(mosquitto_strerror(rc))};
}

void MqttClient::onConnect(mosquitto* /*client*/, void* self, int code, int flags) {
  MqttClient& me = *of(self);
  me.answered_ = true;
  if (code != 0) {
    me.untold_ = mosquitto_connack_string(code);
    return;
  }
  me.connected_ = true;
  me.waitMs_ = 0;
  me.problem_.clear();
  me.owner_.connected((flags & 1) != 0);
}

void MqttClient::onDisconnect(mosquitto* /*client*/, void* self, int /*code*/) {
  of(self)->lost();
}

void MqttClient::onPublish(mosquitto* /*client*/, void* self, int number) {
  of(self)->owner_.delivered(number);
}

void MqttClient::lost() {
  if (std::exchange(connected_, false)) owner_.disconnected();
}

// Of TLS the library returns no more than that there was an error; OpenSSL's reason is in its log alone.
void MqttClient::onLog(mosquitto* /*client*/, void* self, int level, const char* line) {
  if (level == MOSQ_LOG_ERR && std::string_view(line).starts_with("OpenSSL Error")) of(self)->tlsError_ = line;
}

// The broker's own words for a refusal come first and say more.
void MqttClient::tellUnlessTold(int rc) {
  const std::string tls = std::exchange(tlsError_, {});
  if (!untold_.empty()) return;
  if (tls.find("certificate verify failed") != std::string::npos) {
    untold_ =
        "its certificate is vouched for by none of " + options_.ca + ", or is of another host than " + options_.host;
  } else if (!tls.empty()) {
    untold_ = "TLS: " + tls;
  } else if (rc == MOSQ_ERR_CONN_LOST && !answered_ && options_.ca.empty()) {
    untold_ = "it closes the connection before it answers; if it asks for TLS, name its authority with --ca";
  } else {
    untold_ = rc == MOSQ_ERR_ERRNO ? "no connection" : mosquitto_strerror(rc);
  }
}

void MqttClient::setWill(const std::string& topic, std::string_view payload, int qos, bool retained) {
  mosquitto_will_set(client_, topic.c_str(), static_cast<int>(payload.size()), payload.data(), qos, retained);
}

std::optional<int> MqttClient::publish(const std::string& topic, std::string_view payload, int qos, bool retained) {
  int number = 0;
  const int rc = mosquitto_publish(client_, &number, topic.c_str(), static_cast<int>(payload.size()), payload.data(),
                                   qos, retained);
  // An acknowledged message that has a number is the library's, also where the line broke under it: it goes by itself
  // when the line is back, and a second one of ours would double it.
  return rc == MOSQ_ERR_SUCCESS || (qos > 0 && number != 0) ? std::optional(number) : std::nullopt;
}

void MqttClient::subscribe(const std::string& topic) {
  mosquitto_subscribe(client_, nullptr, topic.c_str(), 0);
}

void MqttClient::turn(std::int64_t nowMs) {
  if (client_ == nullptr) return;
  if (mosquitto_socket(client_) < 0) {
    lost();
    if (nowMs < nextTryMs_) return;
    waitMs_ = std::clamp(2 * waitMs_, kFirstWaitMs, kLongestWaitMs);
    nextTryMs_ = nowMs + waitMs_;
    owner_.connecting();
    stands_ = false;
    const int rc = begun_ ? mosquitto_reconnect_async(client_)
                          : mosquitto_connect_async(client_, options_.host.c_str(), options_.port, kKeepAlive_s);
    begun_ = true;
    if (rc != MOSQ_ERR_SUCCESS) tellUnlessTold(rc);
    return;
  }
  if (!stands_) {
    pollfd writable{mosquitto_socket(client_), POLLOUT, 0};
    stands_ = ::poll(&writable, 1, 0) > 0;
  }
  // mosquitto_loop looks once and takes what is there; more than once, because one packet may hide many.
  for (int k = 0; k < kMostReads; ++k) {
    const int rc = mosquitto_loop(client_, 0, 1);
    if (rc != MOSQ_ERR_SUCCESS) {
      tellUnlessTold(rc);
      lost();
      return;
    }
    pollfd more = entry();
    if (more.fd < 0 || ::poll(&more, 1, 0) <= 0) return;
  }
}

pollfd MqttClient::entry() const {
  const int fd = client_ != nullptr ? mosquitto_socket(client_) : -1;
  // A socket that stands is always writable: asked for while the broker has not answered, it would keep poll() from
  // waiting. What has to be written before the answer goes with the next look.
  const bool write = fd >= 0 && (connected_ ? mosquitto_want_write(client_) : !stands_);
  return {fd, static_cast<short>(POLLIN | (write ? POLLOUT : 0)), 0};
}

bool MqttClient::work(const std::function<bool()>& done) {
  const SteadyClock clock;
  const Instant begun = clock.now();
  while (!done() && secondsBetween(begun, clock.now()) < kLongestWork) {
    if (mosquitto_socket(client_) < 0 || mosquitto_loop(client_, kWaitMs, 1) != MOSQ_ERR_SUCCESS) return false;
  }
  return done();
}

void MqttClient::close() {
  if (client_ == nullptr || mosquitto_socket(client_) < 0) return;
  mosquitto_disconnect(client_);
  work([this] { return mosquitto_socket(client_) < 0; });
}

std::string MqttClient::takeProblem() {
  std::string now = std::exchange(untold_, {});
  if (now.empty() || now == problem_) return {};
  problem_ = now;
  return now;
}

}  // namespace stillcut::shop
