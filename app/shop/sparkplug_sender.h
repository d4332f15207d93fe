// SparkplugSender: the same messages as an edge node of Sparkplug B tells them: a birth certificate with all metrics
// and their aliases, data by alias, a death certificate as the will, a new birth on request. Sparkplug's data are sent
// without acknowledgement (quality of service 0), so a plain message behind each batch, which is acknowledged, says
// that the batch arrived: nothing is lost, and after a cut line the newest batch comes again, marked as historical.
// Thread: one.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <utility>

#include "app/shop/sender.h"
#include "app/shop/sparkplug_payload.h"

namespace stillcut::shop {

class SparkplugSender final : public Sender, private MqttClient::Owner {
 public:
  // `node`: GROUP/NODE. `root`: below it "told" is the plain message.
  static Result<std::unique_ptr<SparkplugSender>> make(const BrokerOptions& options, const std::string& node,
                                                       std::string root, Outbox& outbox);

  Status begin() override { return client_.renew(true); }
  Status turn(std::int64_t nowMs) override;
  std::vector<std::uint64_t> takeDelivered() override { return std::exchange(delivered_, {}); }
  pollfd entry() const override { return client_.entry(); }
  void end() override;
  std::string takeProblem() override { return client_.takeProblem(); }
  bool connected() const override { return client_.connected(); }

  static constexpr int kBatch = 20;

 private:
  SparkplugSender(const BrokerOptions& options, std::string group, std::string node, std::string root, Outbox& outbox);
  void connecting() override;
  void connected(bool kept) override;
  void disconnected() override;
  void delivered(int number) override;
  void received(std::string_view topic, std::string_view payload) override;

  std::string topic(const char* type) const;
  std::string death() const;
  void bear();
  void sendBatch();
  void recall();
  sparkplug::Metric metricOf(std::size_t row, const nlohmann::json& message, const std::string& payload) const;
  sparkplug::Payload dataOf(const Outbox::Kept& kept);

  MqttClient client_;
  std::string group_, node_, root_;
  Outbox& outbox_;
  std::map<std::string, sparkplug::Metric> known_;  // newest value of each metric, for the next birth
  std::vector<std::uint64_t> batch_, delivered_;
  std::optional<int> barrier_;  // behind the batch that is under way
  std::uint64_t newest_ = 0;    // delivered, or under way
  // bdSeq of this connection's will and birth. It counts on over restarts: the will of a process that was killed may
  // come after the birth of the next one, and must not be taken for its death.
  std::uint64_t births_ = 0;
  Status kept_ = Done{};  // whether the outbox could note it
  int sequence_ = 0;
  std::int64_t bornUtcMs_ = 0;
  bool bear_ = false;
};

}  // namespace stillcut::shop
