#include "core/safety/flight_recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gate_harness.h"

namespace stillcut::safety {
namespace {

using ::testing::HasSubstr;

FlightEntry entryAt(double seconds) {
  FlightEntry e;
  e.time = Instant(toDuration(Seconds(seconds)));
  return e;
}

TEST(FlightRecorder, KeepsTheLastTenSecondsOldestFirst) {
  FlightRecorder recorder;
  recorder.prepare(Seconds(0.1));
  for (int i = 1; i <= 250; ++i) recorder.push(entryAt(0.1 * i));
  ASSERT_TRUE(recorder.capture({ReasonCode::LinkLost, {0.4}}, entryAt(25.0).time));
  recorder.push(entryAt(25.1));  // the copy is not touched by what comes later

  FlightRecording recording;
  ASSERT_TRUE(recorder.take(recording));
  ASSERT_EQ(recording.entries.size(), 100U);
  EXPECT_EQ(recording.entries.front().time, entryAt(15.1).time);
  EXPECT_EQ(recording.entries.back().time, entryAt(25.0).time);
  EXPECT_FALSE(recorder.take(recording));
}

TEST(FlightRecorder, ALongCopyIsMadeInPortionsAndIsWholeAllTheSame) {
  FlightRecorder recorder;
  recorder.prepare(Seconds(0.001));  // 10 000 entries
  int n = 0;
  for (; n < 25000; ++n) recorder.push(entryAt(1e-3 * n));
  for (int k = 0; k < FlightRecorder::kSlots; ++k) {
    ASSERT_TRUE(recorder.capture({ReasonCode::LinkLost, {static_cast<double>(k)}}, entryAt(1e-3 * n).time));
  }
  FlightRecording recording;
  EXPECT_FALSE(recorder.take(recording)) << "no step may cost the whole copy";
  EXPECT_FALSE(recorder.capture({}, {}));  // every slot is promised
  for (int taken = 0; taken < FlightRecorder::kSlots; ++taken) {
    int steps = 0;
    while (!recorder.take(recording) && steps < 1000) {
      recorder.push(entryAt(1e-3 * n++));
      ++steps;
    }
    EXPECT_LT(steps, 100);
    ASSERT_EQ(recording.entries.size(), 10000U);
    EXPECT_EQ(recording.cause.n[0], taken);
    EXPECT_EQ(recording.entries.front().time, entryAt(15.0).time);
    EXPECT_EQ(recording.entries.back().time, entryAt(24.999).time);
  }
}

TEST(FlightRecorder, WhatFoundNoRoomIsCountedInTheNextRecording) {
  FlightRecorder recorder;
  recorder.prepare(Seconds(0.1));
  recorder.push(entryAt(1.0));
  for (int k = 0; k < FlightRecorder::kSlots + 2; ++k)
    (void)recorder.capture({ReasonCode::LinkLost, {}}, entryAt(1.0).time);
  FlightRecording recording;
  ASSERT_TRUE(recorder.take(recording));
  EXPECT_EQ(recording.missed, 2U);
  EXPECT_THAT(render(recording), HasSubstr("2 more causes found no room"));
  ASSERT_TRUE(recorder.take(recording));
  EXPECT_EQ(recording.missed, 0U);
  EXPECT_THAT(render(recording), ::testing::Not(HasSubstr("more causes")));
}

TEST(FlightRecorder, WhatIsHalfCopiedAtTheEndIsFinished) {
  FlightRecorder recorder;
  recorder.prepare(Seconds(0.001));
  for (int i = 0; i < 10000; ++i) recorder.push(entryAt(1e-3 * i));
  recorder.capture({}, entryAt(10.0).time);
  recorder.finish();
  FlightRecording recording;
  ASSERT_TRUE(recorder.take(recording));
  EXPECT_EQ(recording.entries.size(), 10000U);
}

TEST(FlightRecorder, AYoungRecorderGivesWhatItHas) {
  FlightRecorder recorder;
  recorder.prepare(Seconds(0.01));
  recorder.push(entryAt(0.01));
  recorder.capture({}, entryAt(0.02).time);
  FlightRecording recording;
  ASSERT_TRUE(recorder.take(recording));
  EXPECT_EQ(recording.entries.size(), 1U);
}

TEST(FlightRecorder, WhatNobodyTakesIsCountedAndTheFirstCausesStay) {
  FlightRecorder recorder;
  recorder.prepare(Seconds(0.1));
  for (int i = 0; i < FlightRecorder::kSlots + 2; ++i) {
    recorder.push(entryAt(i));
    recorder.capture({ReasonCode::GateStaleVerdict, {static_cast<double>(i)}}, entryAt(i).time);
  }
  EXPECT_EQ(recorder.missed(), 2U);
  FlightRecording recording;
  for (int i = 0; i < FlightRecorder::kSlots; ++i) {
    ASSERT_TRUE(recorder.take(recording));
    EXPECT_EQ(recording.cause.n[0], i);
  }
  EXPECT_FALSE(recorder.take(recording));
  EXPECT_TRUE(recorder.capture({}, entryAt(9).time));  // room again
}

TEST(FlightRecorder, BeforePrepareNothingHappens) {
  FlightRecorder recorder;
  recorder.push(entryAt(1));
  EXPECT_FALSE(recorder.capture({}, entryAt(1).time));
  FlightRecording recording;
  EXPECT_FALSE(recorder.take(recording));
}

TEST(FlightRecorder, AFaultReadsAsText) {
  testing::GateHarness h;
  FlightRecorder recorder;
  recorder.prepare(Seconds(testing::GateHarness::kDt));
  const auto step = [&] {
    const GateOutput out = h.step();
    GateInput in;
    in.now = h.now;
    in.verdict = h.verdict;
    in.request = h.request;
    in.machine = h.machine;
    recorder.push(flightEntry(in, out));
    if (out.flight) recorder.capture(out.reason, h.now);
  };
  h.verdict.state = CutState::Chatter;
  h.authority(Authority::Auto);
  h.ask(9000, 900);
  for (int i = 0; i < 100; ++i) step();
  h.machine.linkUp = false;
  step();
  FlightRecording recording;
  ASSERT_TRUE(recorder.take(recording));
  const std::string text = render(recording);
  EXPECT_THAT(text, HasSubstr("Cause: the machine has not answered"));
  EXPECT_THAT(text, HasSubstr("speed  90.0 % feed  90.0 %"));
  EXPECT_THAT(text, HasSubstr("link-down"));
  EXPECT_THAT(text, HasSubstr("chatter"));
  EXPECT_THAT(text, HasSubstr("9000 rpm"));
}

}  // namespace
}  // namespace stillcut::safety
