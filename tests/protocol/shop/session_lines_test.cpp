// A session that another program records, as the lines of a run.
#include "app/shop/session_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/session/file/session_writer.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using nlohmann::json;
using record::SessionWriter;
using record::TempFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::int64_t kTenthOfASecond = 100'000'000;

// Steps of 0.1 s, without a pause.
StepRecord stepAt(int tenth, CutState state, bool valid = true) {
  StepRecord step = record::exampleStep(0);
  SampleBlock& block = step.input.block;
  block.frames = 64;
  block.flags = 0;
  block.lostFrames = 0;
  block.rate = Hertz(640.0);
  block.sequence = static_cast<std::uint64_t>(tenth);
  block.firstSample = instantFromNs(tenth * kTenthOfASecond);
  step.input.inputCount = 0;
  step.input.machine.actualFeed = MetresPerSecond(0.05);
  step.input.machine.actualSpeed = Rpm(8500.0);
  step.input.machine.valid = true;
  StepOutput& out = step.output;
  out.hasCommand = false;
  out.eventCount = 0;
  out.verdictCount = 2;
  out.inCharge = 1;
  out.request.time = block.end();
  for (int detector = 0; detector < 2; ++detector) {
    Verdict v;
    v.time = block.end();
    v.state = detector == 1 ? state : CutState::AirCutting;
    v.phase = CutPhase::Steady;
    v.valid = valid;
    v.reason.code = valid ? ReasonCode::None : ReasonCode::InputClipped;
    v.frequency = state == CutState::Chatter ? Hertz(912.0) : Hertz(0.0);
    out.verdicts[static_cast<std::size_t>(detector)] = v;
  }
  return step;
}

std::vector<json> read(SessionLines& lines, std::string* cursor = nullptr, std::size_t atMost = 1000) {
  std::vector<json> all;
  const auto some = lines.read(atMost);
  for (const SourceLine& line : *some) {
    all.push_back(json::parse(line.text));
    if (cursor != nullptr) *cursor = line.cursor;
  }
  return all;
}
std::vector<std::string> types(const std::vector<json>& lines) {
  std::vector<std::string> all;
  for (const json& line : lines) all.push_back(line["type"]);
  return all;
}

class SessionLinesTest : public ::testing::Test {
 protected:
  void add(int tenth, CutState state, bool valid = true) {
    const StepRecord step = stepAt(tenth, state, valid);
    ASSERT_TRUE(writer_->add(step.input, step.output).ok());
  }
  void open(const std::string& name) {
    auto made = SessionWriter::create(folder_ / name, record::exampleHeader());
    ASSERT_TRUE(made.ok()) << made.error().line();
    writer_ = std::move(*made);
  }
  TempFolder folder_;
  std::unique_ptr<SessionWriter> writer_;
};

TEST_F(SessionLinesTest, AreReadBesideTheWriterAndEndWithIt) {
  SessionLines lines(folder_ / "", "");
  EXPECT_THAT(read(lines), IsEmpty());
  open("cut.h5");
  for (int k = 0; k < 10; ++k) add(k, CutState::Stable);
  ASSERT_TRUE(writer_->flush().ok());
  const auto first = read(lines);
  ASSERT_FALSE(first.empty());
  EXPECT_EQ(first[0]["type"], "start");
  EXPECT_EQ(first[0]["schema"], "stillcut-cli/1");
  EXPECT_EQ(first[0]["channels"].size(), 2U);
  EXPECT_EQ(first[1]["type"], "change");
  EXPECT_EQ(first[1]["state"], "stable");
  EXPECT_EQ(first[1]["machine"]["actual_feed_mm_min"], 3000.0);
  EXPECT_FALSE(lines.atEnd());
  EXPECT_THAT(read(lines), IsEmpty());
  for (int k = 10; k < 20; ++k) add(k, CutState::Chatter);
  add(20, CutState::Stable);
  ASSERT_TRUE(writer_->flush().ok());
  const auto second = read(lines);
  ASSERT_THAT(types(second), ElementsAre("change", "status", "change"));
  EXPECT_EQ(second[0]["state"], "chatter");
  EXPECT_EQ(second[0]["frequency_hz"], 912.0);
  EXPECT_NEAR(second[2]["chatter_s"].get<double>(), 1.0, 1e-9);
  EXPECT_NEAR(second[2]["chatter_mm"].get<double>(), 50.0, 1e-6);
  EXPECT_NEAR(second[2]["in_cut_s"].get<double>(), 2.0, 1e-9);
  ASSERT_TRUE(writer_->close().ok());
  EXPECT_THAT(types(read(lines)), ElementsAre("end"));
  EXPECT_TRUE(lines.atEnd());
  EXPECT_THAT(read(lines), IsEmpty());
}

TEST_F(SessionLinesTest, NotJudgedSaysWhy) {
  open("cut.h5");
  add(0, CutState::Stable, false);
  ASSERT_TRUE(writer_->flush().ok());
  SessionLines lines(folder_ / "", "");
  const auto told = read(lines);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[1]["state"], "not-judged");
  EXPECT_EQ(told[1]["reason"], "input-clipped");
}

TEST_F(SessionLinesTest, EventsAndMarkersCome) {
  open("cut.h5");
  StepRecord step = stepAt(0, CutState::Stable);
  step.output.eventCount = 1;
  step.output.events[0] = {step.input.block.end(), 4, EventLevel::Info, {ReasonCode::AdviceRefused, {8800.0, 2900.0}}};
  ASSERT_TRUE(writer_->add(step.input, step.output).ok());
  Marker marker;
  marker.begin = marker.end = step.input.block.end();
  marker.label = "chatter";
  marker.author = "Ada";
  marker.note = "ein Fleck";
  ASSERT_TRUE(writer_->addMarker(marker).ok());
  ASSERT_TRUE(writer_->flush().ok());
  SessionLines lines(folder_ / "", "");
  const auto told = read(lines);
  ASSERT_THAT(types(told), ElementsAre("start", "event", "change", "marker"));
  EXPECT_EQ(told[1]["reason"], "advice-refused");
  EXPECT_EQ(told[1]["values"][0], 8800.0);
  EXPECT_EQ(told[3]["author"], "Ada");
  EXPECT_EQ(told[3]["label"], "chatter");
}

// Wherever it is interrupted, the lines together are the same.
TEST_F(SessionLinesTest, GoOnWhereTheyWereLeft) {
  open("cut.h5");
  for (int k = 0; k < 60; ++k) add(k, k % 7 < 4 ? CutState::Stable : CutState::Chatter);
  ASSERT_TRUE(writer_->close().ok());
  SessionLines whole(folder_ / "", "");
  auto expected = read(whole);
  for (auto rest = read(whole); !rest.empty(); rest = read(whole))
    expected.insert(expected.end(), rest.begin(), rest.end());
  std::string cursor;
  std::vector<json> pieces;
  for (bool more = true; more;) {
    SessionLines piece(folder_ / "", cursor);
    const auto some = read(piece, &cursor, 3);
    more = !some.empty();
    pieces.insert(pieces.end(), some.begin(), some.end());
  }
  EXPECT_EQ(json(pieces), json(expected));
  std::uint64_t number = 0;
  for (const json& line : pieces) EXPECT_EQ(line["sequence"], ++number);
}

TEST_F(SessionLinesTest, TheNextSessionFollowsWhenThisOneIsDone) {
  open("one.h5");
  add(0, CutState::Stable);
  ASSERT_TRUE(writer_->close().ok());
  SessionLines lines(folder_ / "", "");
  EXPECT_THAT(types(read(lines)), ElementsAre("start", "change"));
  EXPECT_THAT(types(read(lines)), ElementsAre("end"));
  const auto before = std::filesystem::last_write_time(folder_ / "one.h5");
  open("two.h5");
  add(0, CutState::Chatter);
  ASSERT_TRUE(writer_->close().ok());
  std::filesystem::last_write_time(folder_ / "two.h5", before + std::chrono::seconds(60));
  EXPECT_THAT(read(lines), IsEmpty());  // over to the next
  EXPECT_THAT(types(read(lines)), ElementsAre("start", "change"));
}

TEST_F(SessionLinesTest, WhatIsNoSessionIsPassedOver) {
  folder_.file("broken.h5", std::string(5000, 'x'));
  SessionLines lines(folder_ / "", "");
  EXPECT_THAT(read(lines), IsEmpty());
  open("cut.h5");
  add(0, CutState::Chatter);
  ASSERT_TRUE(writer_->close().ok());
  const auto later = std::filesystem::last_write_time(folder_ / "cut.h5") + std::chrono::seconds(60);
  std::filesystem::last_write_time(folder_ / "broken.h5", later);
  EXPECT_THAT(types(read(lines)), ElementsAre("start", "change"));
  EXPECT_THAT(types(read(lines)), ElementsAre("end"));
  folder_.file("newer.h5", "no session either");
  EXPECT_THAT(read(lines), IsEmpty());
}

// Somebody sets a marker in yesterday's session while a cut is being recorded.
TEST_F(SessionLinesTest, AnOldSessionThatIsChangedIsNotTheNewest) {
  open("old.h5");
  add(0, CutState::Stable);
  ASSERT_TRUE(writer_->close().ok());
  open("live.h5");
  add(0, CutState::Stable);
  ASSERT_TRUE(writer_->flush().ok());
  SessionLines lines(folder_ / "", "");
  EXPECT_THAT(types(read(lines)), ElementsAre("start", "change"));
  const auto later = std::filesystem::last_write_time(folder_ / "live.h5") + std::chrono::seconds(60);
  std::filesystem::last_write_time(folder_ / "old.h5", later);
  EXPECT_THAT(read(lines), IsEmpty());
  add(1, CutState::Chatter);
  ASSERT_TRUE(writer_->flush().ok());
  const auto told = read(lines);
  ASSERT_THAT(types(told), ElementsAre("change"));
  EXPECT_EQ(told[0]["state"], "chatter");
}

// As `run` counts them: run-up and what was not judged in air are no cut.
TEST_F(SessionLinesTest, SecondsInCutAreThoseInTheMaterial) {
  open("cut.h5");
  for (int k = 0; k < 10; ++k) {
    StepRecord step = stepAt(k, CutState::Stable, k >= 2);
    step.output.verdicts[1].phase = k < 6 ? CutPhase::RunUp : CutPhase::Steady;
    ASSERT_TRUE(writer_->add(step.input, step.output).ok());
  }
  ASSERT_TRUE(writer_->close().ok());
  SessionLines lines(folder_ / "", "");
  read(lines);
  const auto end = read(lines);
  ASSERT_THAT(types(end), ElementsAre("end"));
  EXPECT_NEAR(end[0]["in_cut_s"].get<double>(), 0.3, 1e-9);
}

}  // namespace
}  // namespace stillcut::shop
