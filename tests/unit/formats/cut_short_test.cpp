// A file whose end is missing: no sample of it is ever made up, and nothing is written to it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "core/session/describe_recording.h"
#include "core/session/file/session_reader.h"
#include "core/session/open_recording.h"
#include "core/session/session_overview.h"
#include "core/storage/hdf5_file.h"
#include "core/storage/journal.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void expectRefusedAndUntouched(const std::string& path) {
  const std::string before = contentOf(path);
  const auto repaired = repairSession(path);
  ASSERT_FALSE(repaired.ok()) << before.size() << " bytes were 'repaired'";
  EXPECT_EQ(repaired.error().line().find('\n'), std::string::npos);
  const auto reader = openRecording(path);
  ASSERT_FALSE(reader.ok());
  EXPECT_EQ(reader.error().line().find('\n'), std::string::npos);
  EXPECT_FALSE(describeRecording(path).ok());
  EXPECT_FALSE(countSession(path).ok());
  EXPECT_FALSE(SessionOverview::open(path).ok());
  EXPECT_TRUE(contentOf(path) == before) << before.size() << " bytes became " << contentOf(path).size();
}

// Lengths at which a file of `size` bytes is cut: one byte short, within the last chunks, and anywhere.
std::vector<std::size_t> cuts(std::size_t size, int count) {
  std::mt19937 random(9);
  std::vector<std::size_t> lengths{size - 1, size - 100, size - 5000, size - 40000, 100};
  for (int i = 0; i < count; ++i) lengths.push_back(std::uniform_int_distribution<std::size_t>(100, size - 1)(random));
  return lengths;
}

TEST(CutShort, AClosedSessionIsRefusedByAllAndLeftAsItIs) {
  const TempFolder folder;
  const std::string whole = folder / "whole.h5";
  {
    auto writer = SessionWriter::create(whole, exampleHeader());
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 500; ++i) {
      const StepRecord step = exampleStep(i);
      ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
    }
    ASSERT_TRUE((*writer)->close().ok());
  }
  ASSERT_EQ(look(whole).steps, 500);
  const std::string content = contentOf(whole);
  for (const std::size_t length : cuts(content.size(), 20)) {
    expectRefusedAndUntouched(folder.file("part.h5", content.substr(0, length)));
  }
  const auto nearly = openRecording(folder.file("part.h5", content.substr(0, content.size() - 1)));
  ASSERT_FALSE(nearly.ok());
  EXPECT_THAT(nearly.error().line(), HasSubstr("cut short"));
  EXPECT_THAT(nearly.error().line(), HasSubstr(std::to_string(content.size() - 1)));
  EXPECT_THAT(nearly.error().line(), HasSubstr(std::to_string(content.size())));
}

TEST(CutShort, WhatAKilledWriterLeftIsReadAsItWasRecordedOrRefused) {
  const TempFolder folder;
  const std::string killed = folder / "killed.h5";
  const int added = recordUntilKilled(killed, 900);
  ASSERT_GT(added, 0);
  const std::string content = contentOf(killed);
  const std::string journal = contentOf(journalPath(killed));
  const std::string path = folder / "part.h5";
  int refused = 0;
  for (const bool withJournal : {true, false}) {
    for (const std::size_t length : cuts(content.size(), 20)) {
      const std::string part = content.substr(0, length);
      std::filesystem::remove(journalPath(path));
      folder.file("part.h5", part);
      if (withJournal) folder.file("part.h5.journal", journal);
      const WhatIsLeft left = look(path);
      ASSERT_FALSE(left.damaged) << length << " of " << content.size() << ": " << left.error;
      if (left.opens) continue;
      ++refused;
      EXPECT_TRUE(contentOf(path) == part) << length;
      expectRefusedAndUntouched(path);
    }
  }
  EXPECT_GT(refused, 10);
}

TEST(CutShort, AnotherProgramsFileIsNotRepaired) {
  const TempFolder folder;
  const std::string path = folder / "other.h5";
  {
    const std::vector<float> values(100'000, 1.0F);
    const hsize_t size = values.size();
    const Hdf5Id file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    const Hdf5Id space(H5Screate_simple(1, &size, nullptr));
    const Hdf5Id data(
        H5Dcreate2(file.get(), "x", H5T_NATIVE_FLOAT, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    ASSERT_GE(H5Dwrite(data.get(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  }
  const std::string content = contentOf(path);
  expectRefusedAndUntouched(folder.file("part.h5", content.substr(0, content.size() - 1000)));

  // The journal of a session that had this name before.
  const std::vector<std::byte> left = encodeJournal(
      {1,
       content.size(),
       {{content.size() - 8, std::vector<std::byte>(8, std::byte{'b'}), std::vector<std::byte>(8, std::byte{0})}},
       content.size()});
  folder.file("other.h5.journal", std::string(reinterpret_cast<const char*>(left.data()), left.size()));
  expectRefusedAndUntouched(path);
}

}  // namespace
}  // namespace stillcut::record
