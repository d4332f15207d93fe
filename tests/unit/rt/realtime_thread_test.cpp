#include "core/rt/realtime_thread.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <array>
#include <atomic>
#include <string>

#include "core/rt/wakeup.h"
#include "tests/support/path_counter.h"

namespace stillcut::rt {
namespace {

constexpr Seconds kLong(30.0);

TEST(Wakeup, ANotifyBeforeTheWaitIsNotLostAndManyAreOne) {
  Wakeup wakeup;
  wakeup.notify();
  wakeup.notify();
  EXPECT_TRUE(wakeup.waitFor(kLong));
  EXPECT_FALSE(wakeup.waitFor(Seconds(0.0)));
}

TEST(Wakeup, TheTimeRunsOutWithoutANotify) {
  Wakeup wakeup;
  EXPECT_FALSE(wakeup.waitFor(Seconds(0.001)));
  EXPECT_FALSE(wakeup.waitFor(Seconds(-1.0)));
}

TEST(Wakeup, NotifyNeitherAllocatesNorLocks) {
  Wakeup wakeup;
  const test::PathCounter counter;
  wakeup.notify();
  EXPECT_TRUE(wakeup.waitFor(kLong));
  EXPECT_TRUE(counter.counts().none());
}

TEST(Wakeup, WakesAnotherThreadEveryTime) {
  constexpr int kTurns = 2000;
  Wakeup ping;
  Wakeup pong;
  int woken = 0;
  RealtimeThread thread({"ping-pong"}, [&](const std::stop_token&) {
    for (int i = 0; i < kTurns; ++i) {
      if (!ping.waitFor(kLong)) return;
      pong.notify();
    }
  });
  for (int i = 0; i < kTurns; ++i) {
    ping.notify();
    if (pong.waitFor(kLong)) ++woken;
  }
  EXPECT_EQ(woken, kTurns);
}

TEST(RealtimeThread, StopsAndJoinsWhenDestroyed) {
  std::atomic<bool> ended{false};
  Wakeup never;
  {
    const RealtimeThread thread({"stops"}, [&](const std::stop_token& stop) {
      while (!stop.stop_requested()) never.waitFor(Seconds(0.001));
      ended = true;
    });
  }
  EXPECT_TRUE(ended.load());
}

TEST(RealtimeThread, AThousandStartsAndStopsComeToAnEnd) {
  std::atomic<int> ran{0};
  for (int i = 0; i < 1000; ++i) {
    const RealtimeThread thread({"short"}, [&](const std::stop_token&) { ++ran; });
  }
  EXPECT_EQ(ran.load(), 1000);
}

TEST(RealtimeThread, ALongNameIsCutAndTheRestRuns) {
  Wakeup named;
  Wakeup seen;
  std::string name;
  {
    RealtimeThread thread({"a-name-longer-than-the-system-takes"}, [&](const std::stop_token&) {
      named.waitFor(kLong);
      std::array<char, 32> buffer{};
      ::pthread_getname_np(::pthread_self(), buffer.data(), buffer.size());
      name = buffer.data();
    });
    named.notify();
  }
  EXPECT_EQ(name, "a-name-longer-t");
}

TEST(RealtimeThread, SaysWhichSchedulingItGot) {
  Wakeup done;
  int policy = -1;
  Scheduling granted{};
  {
    Wakeup go;
    RealtimeThread thread({"fifo", Scheduling::Fifo, 10}, [&](const std::stop_token&) {
      go.waitFor(kLong);
      sched_param param{};
      ::pthread_getschedparam(::pthread_self(), &policy, &param);
      done.notify();
    });
    granted = thread.granted();
    go.notify();
    ASSERT_TRUE(done.waitFor(kLong));
  }
  EXPECT_EQ(policy == SCHED_FIFO, granted == Scheduling::Fifo);
  const RealtimeThread ordinary({"ordinary"}, [](const std::stop_token&) {});
  EXPECT_EQ(ordinary.granted(), Scheduling::Ordinary);
}

}  // namespace
}  // namespace stillcut::rt
