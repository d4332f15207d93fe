// Markers: touched during the cut, added afterwards, listed; nothing else in the file changes.
#include "core/session/file/session_markers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/session/describe_recording.h"
#include "core/session/file/session_reader.h"
#include "core/session/session_glance.h"
#include "core/storage/hdf5_file.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

constexpr std::int64_t kMade = 1'700'000'000'000'000'000;  // 2023-11-14T22:13:20Z

// Ten blocks of 2.5 ms from 1 s on, with these touches from block 4 on, four in each.
std::string recordingOf(const TempFolder& folder, const std::vector<OperatorInput>& touches,
                        const std::string& operatorName = "Grace") {
  std::string path = folder / "cut.h5";
  SessionHeader header = exampleHeader();
  header.operatorName = operatorName;
  auto writer = SessionWriter::create(path, header);
  EXPECT_TRUE(writer.ok());
  StepRecord step = exampleStep(0);
  step.input.block.frames = 64;
  step.input.block.flags = 0;
  step.input.block.rate = Hertz(25600.0);
  for (int i = 0; i < 10; ++i) {
    step.input.block.firstSample = instantFromNs(1'000'000'000 + i * 2'500'000);
    step.input.inputCount = 0;
    for (std::size_t k = 0; i >= 4 && k < kMaxInputsPerStep; ++k) {
      const std::size_t touch = static_cast<std::size_t>(i - 4) * kMaxInputsPerStep + k;
      if (touch < touches.size()) step.input.inputs[static_cast<std::size_t>(step.input.inputCount++)] = touches[touch];
    }
    EXPECT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  EXPECT_TRUE((*writer)->close().ok());
  return path;
}

std::string touched(const TempFolder& folder, const std::vector<OperatorAction>& actions,
                    const std::string& operatorName = "Grace") {
  std::vector<OperatorInput> touches;
  touches.reserve(actions.size());
  for (const OperatorAction action : actions) touches.push_back({action, Authority::Off});
  return recordingOf(folder, touches, operatorName);
}

TEST(Markers, ATouchDuringTheCutIsKeptWithItsTimeAndItsAuthor) {
  const TempFolder folder;
  const std::string path = touched(folder, {OperatorAction::TrueAlarm, OperatorAction::Hold, OperatorAction::FalseAlarm,
                                            OperatorAction::ReportChatter});
  const auto markers = readMarkers(path);
  ASSERT_TRUE(markers.ok()) << markers.error().line();
  ASSERT_EQ(markers->size(), 3U) << "holding is no marker";
  const char* labels[] = {"true-alarm", "false-alarm", "heard"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ((*markers.value().begin()).author, "Grace");
    EXPECT_EQ(markers.value()[i].label, labels[i]);
    EXPECT_EQ(toNs(markers.value()[i].begin), 1'012'500'000) << "the end of the block that was heard";
    EXPECT_GT(markers.value()[i].made_ns, kMade);
  }
}

TEST(Markers, ATouchThatWasNotMeantIsTakenBackAndNothingElse) {
  const TempFolder folder;
  const std::string path = touched(folder, {OperatorAction::UndoMark, OperatorAction::TrueAlarm,
                                            OperatorAction::FalseAlarm, OperatorAction::UndoMark});
  const auto markers = readMarkers(path);
  ASSERT_TRUE(markers.ok()) << markers.error().line();
  ASSERT_EQ(markers->size(), 1U);
  EXPECT_EQ(markers.value()[0].label, "true-alarm");
}

TEST(Markers, OneUndoTakesBackOneTouch) {
  const TempFolder folder;
  const auto markers = readMarkers(touched(folder, {OperatorAction::TrueAlarm, OperatorAction::ReportChatter,
                                                    OperatorAction::UndoMark, OperatorAction::UndoMark}));
  ASSERT_TRUE(markers.ok()) << markers.error().line();
  ASSERT_EQ(markers->size(), 1U) << "the older one may be of an alarm long ago";
  EXPECT_EQ(markers.value()[0].label, "true-alarm");
}

// The alarm that began at 1.005 s, in the second block, with later marks of other things between.
TEST(Markers, AnAlarmHasOneMarkWheneverItIsMade) {
  const TempFolder folder;
  const auto of = [](OperatorAction action, double alarm_s) {
    OperatorInput input;
    input.action = action;
    input.value = alarm_s;
    return input;
  };
  const auto markers =
      readMarkers(recordingOf(folder, {of(OperatorAction::FalseAlarm, 1.005), of(OperatorAction::TrueAlarm, 1.0075),
                                       of(OperatorAction::ReportChatter, 0.0), of(OperatorAction::TrueAlarm, 1.005),
                                       of(OperatorAction::UndoMark, 1.0075), of(OperatorAction::FalseAlarm, 0.5),
                                       of(OperatorAction::FalseAlarm, 1e300), of(OperatorAction::UndoMark, 3.0)}));
  ASSERT_TRUE(markers.ok()) << markers.error().line();
  ASSERT_EQ(markers->size(), 2U) << "of no alarm before this recording or after now";
  EXPECT_EQ(markers.value()[1].label, "heard");
  EXPECT_EQ(markers.value()[0].label, "true-alarm");
  EXPECT_EQ(toNs(markers.value()[0].begin), 1'006'000'000) << "just after it began, so that it is the one begun last";
}

// 22 letters of three bytes each are more than a marker has room for.
TEST(Markers, ALongNameOfTheOperatorIsCutBetweenTwoLettersAndTheRecordingGoesOn) {
  const TempFolder folder;
  std::string name;
  for (int i = 0; i < 22; ++i) name += "\xE9\x93\xA3";
  const std::string path = touched(folder, {OperatorAction::FalseAlarm}, name);
  const auto markers = readMarkers(path);
  ASSERT_TRUE(markers.ok()) << markers.error().line();
  ASSERT_EQ(markers->size(), 1U);
  EXPECT_EQ(markers.value()[0].author, name.substr(0, 63));
  const auto counts = countSession(path);
  ASSERT_TRUE(counts.ok());
  EXPECT_EQ(counts->steps, 10U) << "those after the touch as well";
}

TEST(Markers, SpansAndNotesAreAddedChangedAndRemovedAfterwards) {
  const TempFolder folder;
  const std::string path = touched(folder, {OperatorAction::ReportChatter});
  const auto before = countSession(path);
  const Marker span{0,    instantFromNs(1'005'000'000), instantFromNs(1'020'000'000), "chatter", "Ada", "wall \xC3\xBC",
                    kMade};
  const auto number = addMarker(path, span);
  ASSERT_TRUE(number.ok()) << number.error().line();
  EXPECT_EQ(number.value(), 1U);
  EXPECT_EQ(addMarker(path, {0, instantFromNs(0), instantFromNs(0), "note", "Ada", "first", kMade}).value(), 2U);
  auto markers = readMarkers(path);
  ASSERT_TRUE(markers.ok());
  ASSERT_EQ(markers->size(), 3U);
  EXPECT_EQ(markers.value()[0].note, "first") << "by time";
  EXPECT_EQ(markers.value()[1].label, "chatter");
  EXPECT_EQ(markers.value()[1].note, span.note);
  EXPECT_EQ(markers.value()[1].end, span.end);
  EXPECT_EQ(markers.value()[1].made_ns, kMade);

  Marker moved = markers.value()[1];
  moved.label = "stable";
  ASSERT_TRUE(changeMarker(path, moved).ok());
  ASSERT_TRUE(removeMarker(path, 0).ok());
  markers = readMarkers(path);
  ASSERT_TRUE(markers.ok());
  ASSERT_EQ(markers->size(), 2U);
  EXPECT_EQ(markers.value()[1].label, "stable");
  EXPECT_FALSE(removeMarker(path, 0).ok()) << "it is gone";
  EXPECT_FALSE(removeMarker(path, 77).ok());

  const auto after = countSession(path);
  ASSERT_TRUE(before.ok() && after.ok());
  EXPECT_EQ(after.value().steps, before.value().steps);
  EXPECT_EQ(after.value().verdicts, before.value().verdicts);
  EXPECT_TRUE(Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT))) << "others can open it";
  EXPECT_EQ(folder.files(), 1U);
}

TEST(Markers, WhatDoesNotFitIsRefusedAndTheFileStaysAsItWas) {
  const TempFolder folder;
  const std::string path = touched(folder, {});
  EXPECT_FALSE(addMarker(path, {0, instantFromNs(5), instantFromNs(4), "chatter", "Ada", "", 0}).ok());
  EXPECT_FALSE(addMarker(path, {0, {}, {}, "", "Ada", "", 0}).ok());
  const auto tooLong = addMarker(path, {0, {}, {}, "note", "Ada", std::string(512, 'x'), 0});
  ASSERT_FALSE(tooLong.ok());
  EXPECT_THAT(tooLong.error().line(), HasSubstr("too long"));
  EXPECT_FALSE(addMarker(folder / "missing.h5", {0, {}, {}, "note", "Ada", "", 0}).ok());
  EXPECT_TRUE(readMarkers(path).value().empty());
  EXPECT_EQ(countSession(path).value().steps, 10U);
  EXPECT_EQ(folder.files(), 1U);
}

TEST(Glance, TellsLengthAndMarkersAndChangesNothing) {
  const TempFolder folder;
  const std::string path = touched(folder, {OperatorAction::FalseAlarm});
  ASSERT_TRUE(addMarker(path, {0, instantFromNs(0), instantFromNs(0), "note", "Ada", "", 0}).ok());
  ASSERT_TRUE(removeMarker(path, 0).ok());
  const auto written = std::filesystem::last_write_time(path);
  const auto glance = glanceAtSession(path);
  ASSERT_TRUE(glance);
  EXPECT_NEAR(glance->length.value, 0.025, 1e-9);
  EXPECT_EQ(glance->markers, 1) << "a removed one does not count";
  EXPECT_EQ(std::filesystem::last_write_time(path), written);
  EXPECT_FALSE(glanceAtSession(folder / "missing.h5"));
  EXPECT_FALSE(glanceAtSession(folder.file("torn.h5", "\x89HDF\r\n\x1a\n and no more")));
}

TEST(Glance, TellsHowOftenAndHowLongItAlarmed) {
  const TempFolder folder;
  const std::string path = folder / "alarms.h5";
  auto writer = SessionWriter::create(path, exampleHeader());
  ASSERT_TRUE(writer.ok());
  StepRecord step = exampleStep(0);
  step.input.block.frames = 64;
  step.input.block.flags = 0;
  step.input.block.rate = Hertz(25600.0);
  for (int i = 0; i < 10; ++i) {
    step.input.block.firstSample = instantFromNs(1'000'000'000 + i * 2'500'000);
    step.output.eventCount = 0;
    const auto tell = [&](ReasonCode code, double seconds) {
      step.output.events[0] = {step.input.block.firstSample, 0, EventLevel::Info, {code, {seconds}}};
      step.output.eventCount = 1;
    };
    if (i == 1) tell(ReasonCode::ChatterBegan, 1700.0);
    if (i == 3) tell(ReasonCode::ChatterEnded, 0.004);
    if (i == 4) tell(ReasonCode::ChatterBegan, 1700.0);
    if (i == 5) tell(ReasonCode::ChatterLeftCut, 0.002);
    if (i == 6) tell(ReasonCode::ChatterBegan, 1700.0);  // and goes on to the end of the recording
    ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
  }
  ASSERT_TRUE((*writer)->close().ok());
  const auto glance = glanceAtSession(path);
  ASSERT_TRUE(glance);
  EXPECT_EQ(glance->alarms, 3);
  EXPECT_NEAR(glance->alarmed.value, 0.004 + 0.002 + 0.010, 1e-9);
  EXPECT_GT(glance->started_ns, 0) << "when it began, whenever the file was last changed";
}

TEST(Glance, LeavesAloneWhatIsStillWrittenOrWasCutOff) {
  const TempFolder folder;
  const std::string path = folder / "killed.h5";
  ASSERT_GE(recordUntilKilled(path, 200), 200);
  const auto size = std::filesystem::file_size(path);
  EXPECT_FALSE(glanceAtSession(path));
  EXPECT_EQ(std::filesystem::file_size(path), size);
  ASSERT_TRUE(look(path).opens) << "opening it repairs it";
  const auto glance = glanceAtSession(path);
  ASSERT_TRUE(glance);
  EXPECT_GT(glance->length.value, 0.0);
}

TEST(Markers, AreListedByInfo) {
  const TempFolder folder;
  const std::string path = touched(folder, {OperatorAction::FalseAlarm});
  ASSERT_TRUE(
      addMarker(path, {0, instantFromNs(1'000'000'000), instantFromNs(1'020'000'000), "stable", "Ada", "quiet", kMade})
          .ok());
  const auto description = describeRecording(path);
  ASSERT_TRUE(description.ok()) << description.error().line();
  EXPECT_THAT(toText(description.value()),
              HasSubstr("marker       #1 0 to 0.02 s: stable (Ada, 2023-11-14T22:13:20Z) quiet\n"));
  EXPECT_THAT(toText(description.value()), HasSubstr("marker       #0 0.0125 s: false-alarm (Grace, "));
  EXPECT_THAT(toJson(description.value()), HasSubstr("\"label\": \"false-alarm\""));
}

}  // namespace
}  // namespace stillcut::record
