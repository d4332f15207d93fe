// GRBL through the program that streams to it, on virtual time: both overrides act and go home, and nothing is said
// that could disturb the stream.
#include <gtest/gtest.h>

#include <memory>

#include "core/cnc/grbl/grbl_link.h"
#include "core/cnc/sender/sender_wire.h"
#include "tests/protocol/commands.h"
#include "tests/protocol/sender/fake_sender.h"

namespace stillcut::cnc {
namespace {

using namespace testing;

struct Bench {
  explicit Bench(const SenderSettings& settings = {}) {
    auto made = std::make_unique<ScriptedWire>(clock, faults, sender);
    wire = made.get();
    GrblSettings grblSettings;
    grblSettings.wire = {.host = "mill", .port = 8000, .device = {}};
    grblSettings.sender = true;
    for (int i = 0; i < 12; ++i) sender.tick(clock.now(), [](const std::string&) {});  // it has run for a while
    link =
        std::make_unique<GrblLink>(grblSettings, std::make_unique<SenderWire>(settings, std::move(made), clock), clock);
  }
  ~Bench() { link.reset(); }
  MachineState run(double seconds) {
    MachineState m;
    for (const Instant end = clock.now() + toDuration(Seconds(seconds)); clock.now() < end;) {
      if (clock.now() >= nextTick) {
        nextTick = clock.now() + std::chrono::milliseconds(250);
        sender.tick(clock.now(), [&](std::string text) { wire->say(std::move(text)); });
      }
      m = link->read(clock.now());
      clock.advance(Seconds(0.005));
    }
    return m;
  }
  test::VirtualClock clock{instantFromNs(10'000'000'000)};
  Instant nextTick{};
  WireFaults faults;
  FakeGrbl grbl;
  FakeSender sender{grbl};
  ScriptedWire* wire = nullptr;
  CommandMaker gate;
  std::unique_ptr<GrblLink> link;
};

TEST(Sender, BothOverridesActThroughItAndGoHome) {
  Bench b;
  MachineState m = b.run(2.0);
  ASSERT_TRUE(m.valid && m.programRunning);
  EXPECT_EQ(m.programmedSpeed.value, 8800.0);
  EXPECT_NEAR(toMmPerMin(m.programmedFeed), 1200.0, 1e-6);
  b.link->apply(b.gate.set(88.0), b.clock.now());
  m = b.run(4.0);
  EXPECT_EQ(b.grbl.spindle, 88);
  EXPECT_EQ(b.grbl.feed, 88);
  EXPECT_NEAR(m.speedOverride.value, 0.88, 1e-9);
  EXPECT_EQ(m.operatorSpeed.value, 1.0);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
  EXPECT_EQ(b.sender.sent, "") << "an ok that the stream would count";
}

// Its operator's own buttons are a hand.
TEST(Sender, TheOperatorsButtonsInItAreAHandAndStay) {
  Bench b;
  b.run(2.0);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(3.0);
  ASSERT_EQ(b.grbl.spindle, 90);
  b.run(2.0);
  b.grbl.feed = 70;
  const MachineState m = b.run(3.0);
  EXPECT_NEAR(m.operatorFeed.value, 0.7, 1e-9);
  b.link->release(b.clock.now());
  EXPECT_EQ(b.grbl.feed, 70);
  EXPECT_EQ(b.grbl.spindle, 100);
}

// Every answer to a "?" of ours stands in the operator's console.
TEST(Sender, WhatTheSenderReportsIsNotAskedForAgain) {
  Bench b;
  b.run(3.0);
  b.sender.asked = 0;
  EXPECT_TRUE(b.run(10.0).valid);
  EXPECT_LE(b.sender.asked, 3);
}

TEST(Sender, ItIsSignedInWhereThereAreUsersAndNoPortIsOpened) {
  Bench named({.host = "mill", .port = "", .name = "anna", .password = "secret"});
  named.sender.users = true;
  EXPECT_TRUE(named.run(2.0).valid);
  Bench unnamed;
  unnamed.sender.users = true;
  EXPECT_FALSE(unnamed.run(2.0).valid);
  Bench idle;
  idle.sender.portOpen = false;
  const Status opened = idle.link->open();
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.error().line(),
            "mill:5007: cannot be opened (is the sender running there, and connected to its machine?)");
}

TEST(Sender, AProgramThatItHandsToEverybodyIsPassedOver) {
  Bench b;
  b.sender.flood = 700'000;
  EXPECT_TRUE(b.run(3.0).valid);
}

TEST(Sender, PiecesHangsAndHangUpsEndAtHome) {
  Bench b;
  b.faults.split(3);
  b.run(2.0);
  b.link->apply(b.gate.set(90.0), b.clock.now());
  b.run(3.0);
  ASSERT_EQ(b.grbl.spindle, 90);
  b.wire->hangUp();
  EXPECT_FALSE(b.run(0.2).linkUp);
  b.link->release(b.clock.now());
  EXPECT_TRUE(b.run(5.0).valid);
  EXPECT_EQ(b.grbl.spindle, 100);
  EXPECT_EQ(b.grbl.feed, 100);
}

}  // namespace
}  // namespace stillcut::cnc
