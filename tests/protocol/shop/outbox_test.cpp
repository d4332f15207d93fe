// What is kept for the shop until its broker has it.
#include "app/shop/outbox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>

#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using record::TempFolder;

std::vector<std::uint64_t> sequences(const Outbox& box, std::uint64_t after = 0) {
  std::vector<std::uint64_t> all;
  for (const Outbox::Kept& kept : box.after(after, 1'000'000)) all.push_back(kept.sequence);
  return all;
}
void addOne(Outbox& box, const std::string& topic = "features", int value = 1) {
  box.begin();
  box.add({topic, {{"value", value}}, topic == "state"});
  ASSERT_TRUE(box.commit().ok());
}

TEST(Outbox, KeepsOrderAndNumbersOverARestart) {
  const TempFolder folder;
  std::int64_t series = 0;
  {
    auto box = Outbox::open(folder / "box");
    ASSERT_TRUE(box.ok()) << box.error().line();
    series = (*box)->series();
    for (int k = 0; k < 5; ++k) addOne(**box, k == 2 ? "state" : "features", k);
    ASSERT_TRUE((*box)->forget({1, 2, 3, 4, 5}).ok());
    (*box)->begin();
    (*box)->setNote("cursor", "7 100");
    ASSERT_TRUE((*box)->commit().ok());
  }
  auto box = Outbox::open(folder / "box");
  ASSERT_TRUE(box.ok());
  EXPECT_EQ((*box)->series(), series);
  EXPECT_EQ((*box)->note("cursor"), "7 100");
  EXPECT_EQ((*box)->waiting(), 0U);
  addOne(**box, "state", 6);
  const auto kept = (*box)->after(0, 10);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].sequence, 6U);  // a number is never given twice
  EXPECT_TRUE(kept[0].retained);
  const auto payload = nlohmann::json::parse(kept[0].payload);
  EXPECT_EQ(payload["schema"], "stillcut-shop/1");
  EXPECT_EQ(payload["sequence"], 6);
  EXPECT_EQ(payload["series"], series);
  EXPECT_EQ(payload["value"], 6);
}

TEST(Outbox, WhatWasNotCommittedNeverWas) {
  const TempFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    auto box = Outbox::open(folder / "box");
    addOne(**box);
    (*box)->begin();
    (*box)->add({"features", nlohmann::json::object()});
    (*box)->setNote("cursor", "further");
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  auto box = Outbox::open(folder / "box");
  ASSERT_TRUE(box.ok()) << box.error().line();
  EXPECT_THAT(sequences(**box), ::testing::ElementsAre(1U));
  EXPECT_EQ((*box)->note("cursor"), "");
}

TEST(Outbox, TakesALineOfARunOnce) {
  const TempFolder folder;
  auto box = Outbox::open(folder / "box");
  ASSERT_TRUE(box.ok());
  (*box)->begin();
  EXPECT_TRUE((*box)->takeLine(1000, 1));
  EXPECT_TRUE((*box)->takeLine(1000, 2));
  EXPECT_TRUE((*box)->takeLine(2000, 1));
  EXPECT_FALSE((*box)->takeLine(1000, 1));  // the journal is read from its beginning again
  EXPECT_FALSE((*box)->takeLine(1000, 2));
  EXPECT_TRUE((*box)->takeLine(1000, 4));
  EXPECT_TRUE((*box)->commit().ok());
}

TEST(Outbox, WhenItIsFullTheOldestFeaturesGoAndAreCounted) {
  const TempFolder folder;
  auto box = Outbox::open(folder / "box", 1500);
  ASSERT_TRUE(box.ok());
  (*box)->begin();
  for (int k = 0; k < 1501; ++k) (*box)->add({k == 0 ? "event/alarm" : "features", nlohmann::json::object()});
  ASSERT_TRUE((*box)->commit().ok());
  const auto left = sequences(**box);
  ASSERT_EQ(left.size(), 501U);
  EXPECT_EQ(left[0], 1U);  // the alarm stays
  EXPECT_EQ(left[1], 1002U);
  EXPECT_EQ((*box)->note("dropped"), "1000");
}

TEST(Outbox, OneProgramHasIt) {
  const TempFolder folder;
  auto box = Outbox::open(folder / "box");
  ASSERT_TRUE(box.ok());
  const auto second = Outbox::open(folder / "box");
  ASSERT_FALSE(second.ok());
  EXPECT_THAT(second.error().line(), ::testing::HasSubstr("another stillcut-shop has it"));
}

TEST(Outbox, SaysWhereItCannotBe) {
  EXPECT_FALSE(Outbox::open("/nowhere/at/all/box").ok());
  const TempFolder folder;
  EXPECT_FALSE(Outbox::open(folder.file("box", "this is a text and no database, long enough to be looked at")).ok());
}

}  // namespace
}  // namespace stillcut::shop
