// What becomes of a step's events when there are more than slots.
#include "core/model/event_slots.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace stillcut {
namespace {

Event event(EventLevel level, double which) {
  Event e;
  e.level = level;
  e.reason.n[0] = which;
  return e;
}

TEST(EventSlots, ThereIsRoomUntilThereIsNone) {
  std::array<Event, 3> slots{};
  int count = 0;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(addEvent(slots, count, event(EventLevel::Info, i)), 0);
  EXPECT_EQ(addEvent(slots, count, event(EventLevel::Info, 3)), 1);
  EXPECT_EQ(count, 3);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(slots[i].reason.n[0], static_cast<double>(i));
}

TEST(EventSlots, TheNewestOfTheLeastImportantGivesWay) {
  std::array<Event, 3> slots{};
  int count = 0;
  addEvent(slots, count, event(EventLevel::Info, 0));
  addEvent(slots, count, event(EventLevel::Warning, 1));
  addEvent(slots, count, event(EventLevel::Info, 2));
  EXPECT_EQ(addEvent(slots, count, event(EventLevel::Fault, 3)), 1);
  EXPECT_EQ(slots[0].reason.n[0], 0.0);
  EXPECT_EQ(slots[1].reason.n[0], 1.0);
  EXPECT_EQ(slots[2].reason.n[0], 3.0);
}

// Whatever comes: as many faults as there is room for are there, in their order, and each loss is counted.
TEST(EventSlots, NothingImportantIsLostForSomethingLess) {
  std::mt19937 random(3);
  for (int round = 0; round < 500; ++round) {
    std::array<Event, 4> slots{};
    int count = 0, lost = 0;
    std::array<int, 3> came{};
    const int all = 1 + static_cast<int>(random() % 12);
    for (int i = 0; i < all; ++i) {
      const auto level = static_cast<EventLevel>(random() % 3);
      ++came[static_cast<std::size_t>(level)];
      lost += addEvent(slots, count, event(level, i));
    }
    EXPECT_EQ(count + lost, all);
    std::array<int, 3> kept{};
    for (int i = 0; i < count; ++i) ++kept[static_cast<std::size_t>(slots[static_cast<std::size_t>(i)].level)];
    const int faults = std::min(came[2], 4), warnings = std::min(came[1], 4 - faults);
    EXPECT_EQ(kept[2], faults);
    EXPECT_EQ(kept[1], warnings);
    EXPECT_EQ(kept[0], std::min(came[0], 4 - faults - warnings));
    for (int i = 1; i < count; ++i) {
      EXPECT_LT(slots[static_cast<std::size_t>(i) - 1].reason.n[0], slots[static_cast<std::size_t>(i)].reason.n[0]);
    }
  }
}

}  // namespace
}  // namespace stillcut
