// The time of day of a recording's first sample, as WAV and universal files tell it.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "core/formats/universal/uff_date.h"
#include "core/formats/wall_clock.h"
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"
#include "tests/support/uff_dataset.h"

namespace stillcut::record {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

std::string littleEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xffU);
  return text;
}

std::string chunk(const std::string& id, const std::string& body) {
  return id + littleEndian(body.size(), 4) + body + (body.size() % 2 == 1 ? std::string(1, '\0') : "");
}

// One channel of 16 bits at 8000 Hz, with what stands before and behind its samples.
std::string wav(const std::string& before, const std::string& behind) {
  const std::string format = littleEndian(1, 2) + littleEndian(1, 2) + littleEndian(8000, 4) + littleEndian(16000, 4) +
                             littleEndian(2, 2) + littleEndian(16, 2);
  const std::string body = "WAVE" + chunk("fmt ", format) + before + chunk("data", std::string(1600, '\1')) + behind;
  return "RIFF" + littleEndian(body.size(), 4) + body;
}

std::string bext(const std::string& date, const std::string& time, std::uint64_t samples) {
  return chunk("bext", std::string(320, '\0') + date + time + littleEndian(samples, 8) + std::string(256, '\0'));
}

std::int64_t startOf(const std::string& content, const std::string& name) {
  const TempFolder folder;
  const WholeRecording all = readAll(folder.file(name, content));
  EXPECT_EQ(all.error, "");
  return all.format.started_ns;
}

std::int64_t moment(double seconds) {
  return *wallTime(2026, 11, 25, seconds);
}

TEST(WallClock, TheBroadcastChunkTellsTheFirstSample) {
  constexpr double kNine = 9 * 3600.0;
  EXPECT_EQ(startOf(wav(bext("2026-11-25", "09:00:00", 0), ""), "a.wav"), moment(kNine));
  // Samples since midnight tell the fraction.
  const auto samples = static_cast<std::uint64_t>((kNine + 0.25) * 8000);
  EXPECT_EQ(startOf(wav(bext("2026:11:25", "09-00-00", samples), ""), "a.wav"), moment(kNine + 0.25));
  // Of a session of its own they count from elsewhere.
  EXPECT_EQ(startOf(wav(bext("2026-11-25", "09:00:00", 28'800'000), ""), "a.wav"), moment(kNine));
  EXPECT_EQ(startOf(wav("", bext("2026-11-25", "09:00:00", 0)), "a.wav"), moment(kNine)) << "behind the samples";
}

TEST(WallClock, WhatTellsNoDayTellsNothing) {
  EXPECT_EQ(startOf(wav(bext("0000-00-00", "09:00:00", 0), ""), "a.wav"), 0);
  EXPECT_EQ(startOf(wav(bext(std::string(10, '\0'), std::string(8, '\0'), 5), ""), "a.wav"), 0);
  EXPECT_EQ(startOf(wav(bext("2026-02-30", "09:00:00", 0), ""), "a.wav"), 0);
  EXPECT_EQ(startOf(wav(bext("2026-11-25", "25:00:00", 0), ""), "a.wav"), 0);
  EXPECT_EQ(startOf(wav(chunk("bext", "short"), ""), "a.wav"), 0);
  EXPECT_EQ(startOf(wav("", chunk("LIST", "INFO" + chunk("ICRD", "2026-11-25"))), "a.wav"), 0) << "a day alone";
  EXPECT_EQ(startOf(wav("", ""), "a.wav"), 0);
}

TEST(WallClock, IxmlAndInfoTellItToo) {
  const std::string xml =
      "<?xml version=\"1.0\"?><BWFXML><BEXT><BWF_ORIGINATION_DATE>2026-11-25</BWF_ORIGINATION_DATE>"
      "<BWF_ORIGINATION_TIME>09:00:00</BWF_ORIGINATION_TIME></BEXT></BWFXML>";
  EXPECT_EQ(startOf(wav(chunk("iXML", xml), ""), "a.wav"), moment(32'400.0));
  const std::string info = "INFO" + chunk("ISFT", "rec") + chunk("ICRD", std::string("2026-11-25 09:00:00") + '\0');
  EXPECT_EQ(startOf(wav("", chunk("LIST", info)), "a.wav"), moment(32'400.0));
  const std::string zoned = "INFO" + chunk("ICRD", "2026-11-25T09:00:00+01:00");
  EXPECT_EQ(startOf(wav("", chunk("LIST", zoned)), "a.wav"), *wallTime("2026-11-25T08:00:00Z"));
}

TEST(WallClock, AUniversalFileTellsItInItsThirdLine) {
  EXPECT_EQ(uff::madeAt("25-NOV-26 09:00:00"), moment(32'400.0));
  EXPECT_EQ(uff::madeAt(" 25-Nov-2026 09:00:01 "), moment(32'401.0));
  EXPECT_EQ(uff::madeAt("2026-11-25 09:00:00"), moment(32'400.0));
  EXPECT_EQ(uff::madeAt("01-Jan-99 00:00:00"), wallTime(1999, 1, 1, 0.0));
  EXPECT_EQ(uff::madeAt("NONE"), std::nullopt);
  EXPECT_EQ(uff::madeAt("31-Feb-26 09:00:00"), std::nullopt);
  EXPECT_EQ(uff::madeAt("25-NOV-26"), std::nullopt);
  uff::Uff58Dataset set;
  set.function = uff::Uff58Function::TimeResponse;
  set.responseName = "x";
  set.id[2] = "25-NOV-26 09:00:00";
  set.abscissa = {uff::Uff58Quantity::Time, "Time", "s"};
  for (int i = 0; i < 100; ++i) {
    set.x.push_back(i * 1e-3);
    set.y.emplace_back(0.1 * i, 0.0);
  }
  EXPECT_EQ(startOf(test::uffDataset(set, uff::Uff58Form::Ascii), "a.uff"), moment(32'400.0));
}

// Summer and winter differ where there is summer time; the zone is this computer's.
TEST(WallClock, AStampWithAZoneNeedsNoComputer) {
  EXPECT_EQ(wallTime("1970-01-01T00:00:01Z"), kSecond_ns);
  EXPECT_EQ(wallTime("1970-01-01 01:00:01.5+01:00"), 1'500'000'000);
  EXPECT_EQ(wallTime("09:00:00"), std::nullopt);
  EXPECT_EQ(wallTime("03/04/2026 09:00:00"), std::nullopt) << "March or April";
}

}  // namespace
}  // namespace stillcut::record
