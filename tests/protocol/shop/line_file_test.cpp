// Lines that another program appends to a file.
#include "app/shop/line_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using record::TempFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

void append(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::app | std::ios::binary) << text;
}
std::vector<std::string> texts(LineFile& file, std::string* cursor = nullptr, std::size_t atMost = 100) {
  std::vector<std::string> all;
  const auto lines = file.read(atMost);
  for (const SourceLine& line : *lines) {
    all.push_back(line.text);
    if (cursor != nullptr) *cursor = line.cursor;
  }
  return all;
}

TEST(LineFile, TakesWholeLinesAsTheyCome) {
  const TempFolder folder;
  const std::string path = folder / "run.jsonl";
  LineFile file(path, "");
  EXPECT_THAT(texts(file), IsEmpty());  // it is not there yet
  append(path, "one\ntw");
  EXPECT_THAT(texts(file), ElementsAre("one"));
  append(path, "o\n\nthree\n");
  EXPECT_THAT(texts(file), ElementsAre("two", "three"));
  EXPECT_THAT(texts(file), IsEmpty());
  EXPECT_TRUE(file.atEnd());
}

TEST(LineFile, SomebodyWritesIsAnEvent) {
  const TempFolder folder;
  LineFile file(folder / "run.jsonl", "");
  texts(file);
  append(folder / "run.jsonl", "one\n");
  pollfd entry{file.descriptor(), POLLIN, 0};
  EXPECT_EQ(::poll(&entry, 1, 0), 1);
  EXPECT_THAT(texts(file), ElementsAre("one"));
  EXPECT_EQ(::poll(&entry, 1, 0), 0);
}

TEST(LineFile, GoesOnAfterTheLineThatWasTaken) {
  const TempFolder folder;
  const std::string path = folder.file("run.jsonl", "one\ntwo\nthree\n");
  std::string cursor;
  {
    LineFile file(path, "");
    EXPECT_THAT(texts(file, &cursor, 2), ElementsAre("one", "two"));
  }
  LineFile file(path, cursor);
  EXPECT_THAT(texts(file), ElementsAre("three"));
}

TEST(LineFile, ARotatedFileIsReadToItsEndFirst) {
  const TempFolder folder;
  const std::string path = folder.file("run.jsonl", "one\n");
  std::string cursor;
  {
    LineFile file(path, "");
    EXPECT_THAT(texts(file, &cursor), ElementsAre("one"));
    append(path, "two\n");
    std::filesystem::rename(path, folder / "run.jsonl.1");
    append(folder / "run.jsonl.1", "three\n");
    append(path, "four\n");
    EXPECT_THAT(texts(file), ElementsAre("two", "three", "four"));
  }
  LineFile later(path, cursor);  // as if all that had happened while nobody was reading
  EXPECT_THAT(texts(later), ElementsAre("two", "three", "four"));
}

// The times of the files are set, as those of a real rotation are hours apart.
TEST(LineFile, FilesThatWereRotatedWhileNobodyReadAreReadInTheirOrder) {
  for (const auto& [middle, newer] :
       {std::pair("run.jsonl.2", "run.jsonl.1"), {"run.jsonl-20261127", "run.jsonl-20261128"}}) {
    const TempFolder folder;
    const std::string path = folder.file("run.jsonl", "one\n");
    std::string cursor;
    {
      LineFile file(path, "");
      EXPECT_THAT(texts(file, &cursor), ElementsAre("one"));
    }
    append(path, "two\n");
    std::filesystem::rename(path, folder / "run.jsonl.9");
    const auto now = std::filesystem::last_write_time(folder / "run.jsonl.9");
    const auto written = [&](const std::string& name, const std::string& text, int hours) {
      std::filesystem::last_write_time(folder.file(name, text), now + std::chrono::hours(hours));
    };
    written(middle, "three\n", 1);
    written(newer, "four\n", 2);
    written("run.jsonl.8.gz", "what no line is\n", 1);  // compressed: it cannot be read
    written("other.jsonl", "of another run\n", 1);
    written("run.jsonl", "five\n", 3);
    LineFile later(path, cursor);
    EXPECT_THAT(texts(later), ElementsAre("two", "three", "four", "five"));
  }
}

TEST(LineFile, AFileThatIsBegunAnewIsReadFromItsBeginning) {
  const TempFolder folder;
  const std::string path = folder.file("run.jsonl", "one\ntwo\n");
  LineFile file(path, "");
  texts(file);
  folder.file("run.jsonl", "new\n");
  EXPECT_THAT(texts(file), ElementsAre("new"));
}

TEST(LineFile, AFileThatWasBegunAnewWhileNobodyReadIsReadFromItsBeginning) {
  const TempFolder folder;
  const std::string path = folder.file("run.jsonl", "one\ntwo\n");
  std::string cursor;
  {
    LineFile file(path, "");
    texts(file, &cursor);
    EXPECT_FALSE(file.goesOn());
  }
  EXPECT_TRUE(LineFile(path, cursor).goesOn());
  folder.file("run.jsonl", "new one\nnew two\nnew three\n");
  LineFile later(path, cursor);
  EXPECT_FALSE(later.goesOn());
  EXPECT_THAT(texts(later), ElementsAre("new one", "new two", "new three"));
}

TEST(LineFile, WhatIsTooLongIsNoLine) {
  const TempFolder folder;
  const std::string path = folder.file("run.jsonl", std::string(3 * LineFile::kLongestLine, 'x'));
  LineFile file(path, "");
  EXPECT_THAT(texts(file), IsEmpty());
  append(path, "end\nnext\n");
  EXPECT_THAT(texts(file), ElementsAre("next"));
}

}  // namespace
}  // namespace stillcut::shop
