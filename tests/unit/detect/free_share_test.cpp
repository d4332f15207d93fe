// Full chatter by what stands off the orders alone: when a look counts, how an alarm begins, lasts and ends.
#include "core/detect/share_test.h"

#include <gtest/gtest.h>

namespace stillcut::detect {
namespace {

struct Looks {
  ShareTest test;
  SeriesLook look;
  Looks() {
    look.certainty = 0.99;
    look.teethHeard = look.whole = true;
    look.lines = 20;
    look.free.offset = 0.2;
    look.free.line = Hertz(1316.0);
  }
  void see(double share, int times = 1) {
    look.free.share = look.joint = share;
    for (int i = 0; i < times; ++i) {
      ++look.count;
      test.see(look);
    }
  }
};

TEST(ShareTest, TwoLooksOnEndAboveTheLimitAreFullChatter) {
  Looks l;
  l.see(0.5);
  EXPECT_FALSE(l.test.full());
  l.test.see(l.look);  // the same look once more says nothing new
  EXPECT_FALSE(l.test.full());
  l.see(0.5);
  EXPECT_TRUE(l.test.full());
  EXPECT_EQ(l.test.line(), Hertz(1316.0));
}

TEST(ShareTest, NoCalmBeforeItRaisesTheLimit) {
  Looks l;
  l.see(0.3, 1000);
  EXPECT_FALSE(l.test.full());
  l.see(0.36, 2);
  EXPECT_TRUE(l.test.full());
}

TEST(ShareTest, LastsToHalfOfTheLimitAndThroughLooksThatTellNothing) {
  Looks l;
  l.see(0.5, 2);
  l.see(0.2, 10);
  EXPECT_TRUE(l.test.lasts());
  l.look.certainty = 0.3;
  l.see(0.0, 7);
  EXPECT_TRUE(l.test.lasts());
  l.look.certainty = 0.99;
  l.see(0.1, 2);
  EXPECT_FALSE(l.test.lasts());
}

TEST(ShareTest, LooksThatReachBackBeforeTheVibrationWentBeginNothing) {
  Looks l;
  l.see(0.9, 3);
  l.test.skipStale();
  EXPECT_FALSE(l.test.lasts());
  l.test.see(l.look);  // the same look once more
  l.see(0.9, 4);       // a window is four looks long
  EXPECT_FALSE(l.test.full());
  l.see(0.1, 8);
  EXPECT_FALSE(l.test.full());
  l.see(0.9, 2);
  EXPECT_TRUE(l.test.full());
}

TEST(ShareTest, WhatCannotBeToldBeginsNothing) {
  const auto full = [](auto change) {
    Looks l;
    change(l.look);
    l.see(0.9, 4);
    return l.test.full();
  };
  EXPECT_TRUE(full([](SeriesLook&) {}));
  EXPECT_FALSE(full([](SeriesLook& k) { k.certainty = 0.5; }));
  EXPECT_FALSE(full([](SeriesLook& k) { k.teethHeard = false; }));
  EXPECT_FALSE(full([](SeriesLook& k) { k.whole = false; }));
  EXPECT_FALSE(full([](SeriesLook& k) { k.lines = 3; }));
  EXPECT_FALSE(full([](SeriesLook& k) { k.steady = false; }));
  EXPECT_FALSE(full([](SeriesLook& k) { k.agreed = false; }));
  EXPECT_FALSE(full([](SeriesLook& k) { k.leaving = true; }));
  EXPECT_FALSE(full([](SeriesLook& k) { k.free.offset = -0.02; }));
}

TEST(ShareTest, AWeakAxisAloneSaysNothing) {
  Looks l;
  l.look.free.share = 0.9;
  l.look.joint = 0.1;
  for (int i = 0; i < 5; ++i) {
    ++l.look.count;
    l.test.see(l.look);
  }
  EXPECT_FALSE(l.test.full());
}

}  // namespace
}  // namespace stillcut::detect
