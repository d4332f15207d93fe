#include "app/shop/topic_sender.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

namespace stillcut::shop {
namespace {

// The quality of service of everything, `online` and the will too: a broker keeps the order only among messages of one
// quality. A farewell of a lower one overtook what was told before it; and where one of a lower quality lies between
// the others for a slow subscriber, its acknowledgement lets mosquitto 2.0.11 send a message before 30 older ones.
constexpr int kExactlyOnce = 2;

}  // namespace

TopicSender::TopicSender(const BrokerOptions& options, std::string root, std::string version, const Outbox& outbox)
    : client_(options, *this), root_(std::move(root)), version_(std::move(version)), outbox_(outbox) {}

Status TopicSender::begin() {
  return client_.renew(true);
}

void TopicSender::connecting() {
  if (!clearing_) client_.setWill(root_ + "/online", online(false), kExactlyOnce, true);
}

void TopicSender::connected(bool kept) {
  if (clearing_) {
    cleared_ = true;
    return;
  }
  client_.publish(root_ + "/online", online(true), kExactlyOnce, true);
  if (!kept && !onTheirWay_.empty()) anew_ = true;
}

void TopicSender::delivered(int number) {
  if (farewell_ == number) farewell_.reset();
  if (anew_) return;  // the broker has forgotten the session: what it now acknowledges it may never have had
  const auto found =
      std::find_if(onTheirWay_.begin(), onTheirWay_.end(), [number](const OnItsWay& m) { return m.number == number; });
  if (found == onTheirWay_.end()) return;
  delivered_.push_back(found->sequence);
  onTheirWay_.erase(found);
}

Status TopicSender::turn(std::int64_t nowMs) {
  client_.turn(nowMs);
  if (std::exchange(cleared_, false)) {
    client_.close();
    clearing_ = false;
    return client_.renew(false);
  }
  if (std::exchange(anew_, false)) {
    // The broker has forgotten what was under way: all of it once more.
    newest_ = onTheirWay_.front().sequence - 1;
    onTheirWay_.clear();
    return client_.renew(false);
  }
  if (connected()) send();
  return Done{};
}

void TopicSender::send() {
  while (onTheirWay_.size() < kWindow) {
    const auto next = outbox_.after(newest_, static_cast<int>(kWindow - onTheirWay_.size()));
    if (next.empty()) return;
    for (const Outbox::Kept& m : next) {
      const auto number = client_.publish(root_ + "/" + m.topic, m.payload, kExactlyOnce, m.retained);
      if (!number) return;
      onTheirWay_.push_back({*number, m.sequence});
      newest_ = m.sequence;
    }
  }
}

std::string TopicSender::online(bool yes) const {
  const nlohmann::json payload{{"schema", kShopSchema},
                               {"online", yes},
                               {"utc_ms", utcNowMs()},
                               {"version", version_},
                               {"series", outbox_.series()},
                               {"waiting", outbox_.waiting()},
                               {"dropped", std::strtoull(outbox_.note("dropped").c_str(), nullptr, 10)}};
  return payload.dump();
}

void TopicSender::end() {
  if (!connected()) return;
  farewell_ = client_.publish(root_ + "/online", online(false), kExactlyOnce, true);
  // A line that ends before the broker has it is for the broker a program that died: its will says the same.
  if (client_.work([this] { return !farewell_; })) client_.close();
}

}  // namespace stillcut::shop
