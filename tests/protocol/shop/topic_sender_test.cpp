// The sender and what a broker may say at the wrong moment.
#include "app/shop/topic_sender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/bounded_wait.h"
#include "tests/support/shop/scripted_broker.h"
#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using cnc::testing::within;
using record::TempFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ScriptedBroker;

constexpr Seconds kPatience{20.0};

class ATopicSender : public ::testing::Test {
 protected:
  void SetUp() override {
    auto opened = Outbox::open(folder_ / "box");
    ASSERT_TRUE(opened.ok());
    outbox_ = std::move(*opened);
    BrokerOptions options;
    options.host = "127.0.0.1";
    options.port = broker_.port();
    options.clientId = "mill3";
    sender_ = std::make_unique<TopicSender>(options, "w/h/mill3/stillcut", "1", *outbox_);
    ASSERT_TRUE(sender_->begin().ok());
  }
  void tell(const char* topic) {
    outbox_->begin();
    outbox_->add({topic, {{"t", 1.0}}, false});
    ASSERT_TRUE(outbox_->commit().ok());
  }
  // Turns the sender, whose clock goes on by a second each time, until the broker has heard such a packet, with `about`
  // in it.
  ScriptedBroker::Packet next(ScriptedBroker::Type type, std::string_view about = "") {
    ScriptedBroker::Packet found;
    EXPECT_TRUE(within(kPatience,
                       [&] {
                         EXPECT_TRUE(sender_->turn(nowMs_ += 1000).ok());
                         for (const auto& packet : broker_.heard()) {
                           // One quality of service for all, or a broker may hand one out before the other.
                           EXPECT_TRUE(packet.type != ScriptedBroker::Publish || packet.quality() == 2);
                           const bool wanted = packet.type == type && packet.body.find(about) != std::string::npos;
                           if (found.type == 0 && wanted) found = packet;
                         }
                         return found.type != 0;
                       }))
        << "packet of type " << type;
    return found;
  }
  // Past the connection that clears an old session, to the one that stays.
  void connect() {
    next(ScriptedBroker::Connect);
    broker_.welcome(false);
    next(ScriptedBroker::Disconnect);
    next(ScriptedBroker::Connect);
    broker_.welcome(false);
  }
  TempFolder folder_;
  ScriptedBroker broker_;
  std::unique_ptr<Outbox> outbox_;
  std::unique_ptr<TopicSender> sender_;
  std::int64_t nowMs_ = 0;
};

// It acknowledges the end of a handshake whose beginning it has forgotten with the session.
TEST_F(ATopicSender, DoesNotBelieveABrokerThatHasForgottenTheSession) {
  connect();
  tell("event/alarm");
  const auto published = next(ScriptedBroker::Publish, "w/h/mill3/stillcut/event/alarm");
  broker_.say(0x50, published.number());
  next(ScriptedBroker::PubRel);
  broker_.hangUp();
  next(ScriptedBroker::Connect);
  // In one breath, as a broker that is in a hurry does.
  broker_.welcome(false);
  broker_.say(0x70, published.number());
  next(ScriptedBroker::Connect);
  broker_.welcome(false);
  const auto again = next(ScriptedBroker::Publish, "w/h/mill3/stillcut/event/alarm");
  EXPECT_EQ(broker_.connections(), 4);
  EXPECT_THAT(sender_->takeDelivered(), IsEmpty());
  broker_.say(0x50, again.number());
  next(ScriptedBroker::PubRel);
  broker_.say(0x70, again.number());
  std::vector<std::uint64_t> delivered;
  EXPECT_TRUE(within(kPatience, [&] {
    EXPECT_TRUE(sender_->turn(nowMs_ += 1000).ok());
    return !(delivered = sender_->takeDelivered()).empty();
  }));
  EXPECT_THAT(delivered, ElementsAre(1));
}

// Something else has that port, or the broker hangs: waiting for its first word costs nothing.
TEST_F(ATopicSender, WaitsForABrokerThatTakesTheConnectionAndSaysNothing) {
  next(ScriptedBroker::Connect);
  EXPECT_TRUE(sender_->turn(nowMs_).ok());
  EXPECT_GE(sender_->entry().fd, 0);
  EXPECT_EQ(sender_->entry().events, POLLIN);
}

TEST_F(ATopicSender, SaysWhyTheBrokerRefuses) {
  next(ScriptedBroker::Connect);
  broker_.say(0x20, {'\0', '\5'});
  std::string problem;
  EXPECT_TRUE(within(kPatience, [&] {
    EXPECT_TRUE(sender_->turn(nowMs_).ok());
    return !(problem = sender_->takeProblem()).empty();
  }));
  EXPECT_THAT(problem, HasSubstr("not authorised"));
}

}  // namespace
}  // namespace stillcut::shop
