// TopicSender: the messages as JSON below one topic (resources/manual/shop.md), each exactly once as long as this
// program and the broker's session live (MQTT's quality of service 2), and in order. After a kill, or with a broker
// that forgot the session, the last few may come twice, with the same series and sequence.
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "app/shop/sender.h"

namespace stillcut::shop {

class TopicSender final : public Sender, private MqttClient::Owner {
 public:
  // `root`: SITE/AREA/MACHINE/stillcut. `version`: of this program, told by the topic online.
  TopicSender(const BrokerOptions& options, std::string root, std::string version, const Outbox& outbox);

  Status begin() override;
  Status turn(std::int64_t nowMs) override;
  std::vector<std::uint64_t> takeDelivered() override { return std::exchange(delivered_, {}); }
  pollfd entry() const override { return client_.entry(); }
  void end() override;
  std::string takeProblem() override { return client_.takeProblem(); }
  bool connected() const override { return client_.connected() && !clearing_; }

  static constexpr std::size_t kWindow = 20;  // on their way at once; brokers take as many

 private:
  struct OnItsWay {
    int number;
    std::uint64_t sequence;
  };
  void connecting() override;
  void connected(bool kept) override;
  void disconnected() override {}
  void delivered(int number) override;
  void received(std::string_view /*topic*/, std::string_view /*payload*/) override {}
  std::string online(bool yes) const;
  void send();

  MqttClient client_;
  std::string root_, version_;
  const Outbox& outbox_;
  std::deque<OnItsWay> onTheirWay_;
  std::vector<std::uint64_t> delivered_;
  std::uint64_t newest_ = 0;  // sent, or on its way
  // A session that a process before this one has left is cleared first: its numbers would be taken for ours.
  bool clearing_ = true, cleared_ = false;
  std::optional<int> farewell_;  // number of the last message, until the broker has it
  bool anew_ = false;            // the broker has forgotten ours: what is under way has to go once more, in a new one
};

}  // namespace stillcut::shop
