// What files are read and written with, below the formats: the journal of overwrites, lines, raw bytes, files that
// appear whole.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/formats/text/line_reader.h"
#include "core/formats/universal/byte_window.h"
#include "core/storage/journal.h"
#include "core/storage/journaled_file.h"
#include "core/storage/part_file.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

JournalContent randomContent(std::mt19937& random, unsigned most) {
  JournalContent content;
  content.commit = random();
  content.fileSize = 1000 + random() % 100000;
  content.sizeAfter = random();
  for (auto n = random() % most; n > 0; --n) {
    Overwrite o;
    o.offset = random() % 1000;
    o.bytes.resize(1 + random() % 60);
    for (std::byte& b : o.bytes) b = static_cast<std::byte>(random() % 256);
    o.before.resize(o.bytes.size());
    for (std::byte& b : o.before) b = static_cast<std::byte>(random() % 256);
    content.overwrites.push_back(o);
  }
  return content;
}

TEST(Journal, GivesBackWhatWasPutIn) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const JournalContent content = randomContent(random, 8);
    const auto back = decodeJournal(encodeJournal(content));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->commit, content.commit);
    EXPECT_EQ(back->fileSize, content.fileSize);
    EXPECT_EQ(back->sizeAfter, content.sizeAfter);
    ASSERT_EQ(back->overwrites.size(), content.overwrites.size());
    for (std::size_t i = 0; i < content.overwrites.size(); ++i) {
      EXPECT_EQ(back->overwrites[i].offset, content.overwrites[i].offset);
      EXPECT_EQ(back->overwrites[i].bytes, content.overwrites[i].bytes);
      EXPECT_EQ(back->overwrites[i].before, content.overwrites[i].before);
    }
  }
}

// A crash may end the journal anywhere: then the session has not been touched, and it must count as none.
TEST(Journal, TornAnywhereItIsAsGoodAsNone) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 20; ++trial) {
    JournalContent content = randomContent(random, 5);
    content.overwrites.push_back({7, {std::byte{1}, std::byte{2}}, {std::byte{3}, std::byte{4}}});
    const std::vector<std::byte> whole = encodeJournal(content);
    for (std::size_t n = 0; n < whole.size(); ++n) {
      EXPECT_FALSE(decodeJournal(std::span(whole).first(n)).has_value()) << n << " of " << whole.size();
    }
  }
}

TEST(Journal, OneTurnedBitIsNoticed) {
  std::mt19937 random(3);
  JournalContent content = randomContent(random, 4);
  content.overwrites.push_back({3, {std::byte{9}}, {std::byte{8}}});
  const std::vector<std::byte> whole = encodeJournal(content);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::vector<std::byte> bent = whole;
      bent[i] ^= static_cast<std::byte>(1U << bit);
      const auto back = decodeJournal(bent);
      if (!back) continue;
      // Only bytes that carry nothing may turn unnoticed.
      EXPECT_EQ(back->commit, content.commit) << i;
      EXPECT_EQ(back->fileSize, content.fileSize) << i;
      EXPECT_EQ(back->sizeAfter, content.sizeAfter) << i;
      ASSERT_EQ(back->overwrites.size(), content.overwrites.size()) << i;
      for (std::size_t k = 0; k < content.overwrites.size(); ++k) {
        EXPECT_EQ(back->overwrites[k].bytes, content.overwrites[k].bytes) << i;
        EXPECT_EQ(back->overwrites[k].before, content.overwrites[k].before) << i;
        EXPECT_EQ(back->overwrites[k].offset, content.overwrites[k].offset) << i;
      }
    }
  }
}

TEST(Journal, HostileBytesAreNone) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<std::byte> bytes(random() % 300);
    for (std::byte& b : bytes) b = static_cast<std::byte>(random());
    EXPECT_FALSE(decodeJournal(bytes).has_value());
  }
  EXPECT_EQ(journalPath("a/cut.h5"), "a/cut.h5.journal");
}

// Journals of the format before this one, without the bytes as they were.
TEST(Journal, OfTheFirstFormatCompletesAFileThatIsStillMarkedAndNoOther) {
  const std::vector<unsigned char> first{
      0x53, 0x43, 0x54, 0x4A, 0x52, 0x4E, 0x4C, 0x31, 1, 0, 0, 0,  0, 0, 0, 0, 100, 0,  0, 0,    0,
      0,    0,    0,    1,    0,    0,    0,    0,    0, 0, 0, 17, 0, 0, 0, 0, 0,   0,  0, 0x5C, 0x26,
      0xC2, 0xD1, 0x8D, 0xAB, 0x83, 0xD5, 0,    0,    0, 0, 0, 0,  0, 0, 0, 0, 0,   0,  0, 0,    0,
      0,    60,   0,    0,    0,    0,    0,    0,    0, 1, 0, 0,  0, 0, 0, 0, 0,   'b'};
  for (const char flags : {'\5', '\0'}) {
    const TempFolder folder;
    std::string content("\x89HDF\r\n\x1a\n\3\10\10", 11);
    content += flags;
    content.resize(100, 'a');
    const std::string path = folder.file("cut.h5", content);
    folder.file("cut.h5.journal", std::string(first.begin(), first.end()));
    const auto recovered = recoverFromJournal(path, [] { return Status(Done{}); });
    ASSERT_TRUE(recovered.ok());
    EXPECT_EQ(recovered.value(), flags != 0 ? Recovery::Recovered : Recovery::AnothersJournal);
    std::ifstream in(path, std::ios::binary);
    const std::string now{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(now[60], flags != 0 ? 'b' : 'a');
  }
}

class LineReading : public testing::Test {
 protected:
  // All lines of a file with this content; a last one "!..." is the error.
  std::vector<std::string> lines(const std::string& content) {
    LineReader reader(folder_.file("a.txt", content));
    std::vector<std::string> all;
    if (const Status opened = reader.open(); !opened) return {"!" + opened.error().line()};
    std::string_view line;
    while (true) {
      const auto more = reader.next(line);
      if (!more) {
        all.push_back("!" + more.error().line());
        return all;
      }
      if (!*more) return all;
      all.emplace_back(line);
      EXPECT_EQ(reader.number(), static_cast<std::int64_t>(all.size()));
    }
  }
  TempFolder folder_;
};

TEST_F(LineReading, AgreesWithPlainGetlineWhateverTheLengths) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 60; ++trial) {
    std::string content;
    for (auto n = random() % 40; n > 0; --n) {
      content += std::string(trial % 3 == 0 ? random() % 9000 : random() % 20, static_cast<char>('a' + random() % 26));
      content += trial % 2 == 0 ? "\n" : "\r\n";
    }
    if (trial % 4 == 0) content += "the last without an end";
    std::vector<std::string> plain;
    std::istringstream in(content);
    for (std::string line; std::getline(in, line);) {
      if (line.ends_with('\r')) line.pop_back();
      plain.push_back(line);
    }
    EXPECT_EQ(lines(content), plain) << trial;
  }
}

TEST_F(LineReading, AByteOrderMarkIsNoText) {
  EXPECT_EQ(lines("\xEF\xBB\xBFt,x\n1,2\n"), (std::vector<std::string>{"t,x", "1,2"}));
  EXPECT_TRUE(lines("").empty());
  EXPECT_EQ(lines("\n\n"), (std::vector<std::string>{"", ""}));
}

TEST_F(LineReading, TheLongestLineIsReadAndALongerOneIsNone) {
  EXPECT_EQ(lines(std::string(LineReader::kLongestLine, 'x') + "\nend\n").size(), 2U);
  const auto tooLong = lines("first\n" + std::string(LineReader::kLongestLine + 1, 'x') + "\nend\n");
  ASSERT_EQ(tooLong.size(), 2U);
  EXPECT_NE(tooLong[1].find("a.txt:2: the line is too long"), std::string::npos) << tooLong[1];
}

TEST_F(LineReading, BytesThatAreNoTextAreRefusedWithTheirLine) {
  const auto got = lines(std::string("1,2\n3,\0004\n", 9));
  ASSERT_EQ(got.size(), 2U);
  EXPECT_NE(got[1].find("a.txt:2: holds bytes that are no text"), std::string::npos) << got[1];
}

// The same calls over a file and over memory.
TEST(ByteWindow, AFileReadsAsTheSameBytesInMemory) {
  const TempFolder folder;
  std::mt19937 random(6);
  std::string content(3 * uff::ByteWindow::kCapacity + 777, '\0');
  for (char& c : content) c = static_cast<char>(random() % 12 == 0 ? '\n' : 'a' + random() % 20);
  const std::string path = folder.file("b.bin", content);
  auto file = uff::ByteWindow::open(path);
  ASSERT_TRUE(file.ok());
  uff::ByteWindow memory(content);
  for (int call = 0; call < 20000 && !memory.atEnd(); ++call) {
    ASSERT_EQ(file->left(), memory.left());
    ASSERT_EQ(file->position(), memory.position());
    switch (random() % 5) {
      case 0: {
        const std::uint64_t to = random() % (content.size() + 1);
        file->seek(to);
        memory.seek(to);
        break;
      }
      case 1: {
        const std::size_t n = random() % 5000;
        const std::string_view bytes = memory.take(n);
        ASSERT_EQ(std::string(file->take(n)), std::string(bytes));
        break;
      }
      default:
        ASSERT_EQ(std::string(file->line()), std::string(memory.line()));
    }
  }
}

TEST(ByteWindow, TakesLessOnlyAtTheEnd) {
  uff::ByteWindow window("12345\r\nabc");
  EXPECT_EQ(window.line(), "12345");
  EXPECT_EQ(window.position(), 7U);
  EXPECT_EQ(window.take(2), "ab");
  EXPECT_EQ(window.take(9), "c");
  EXPECT_TRUE(window.atEnd());
  EXPECT_EQ(window.take(1), "");
  EXPECT_FALSE(uff::ByteWindow::open("/no/such/file").ok());
}

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(PartFile, AppearsWhenItIsCompleteAndNotBefore) {
  const TempFolder folder;
  const std::string path = folder / "a.wav";
  {
    PartFile file(path);
    ASSERT_TRUE(file.opened());
    file.writeAt(0, "head");
    file.writeAt(8, "tail");
    file.writeAt(0, "HEAD");
    EXPECT_FALSE(std::filesystem::exists(path));
    ASSERT_TRUE(file.finish().ok());
  }
  EXPECT_EQ(contentOf(path), std::string("HEAD\0\0\0\0tail", 12));
  EXPECT_EQ(folder.files(), 1U);
}

TEST(PartFile, GivenUpItLeavesNothingAndTheOldFileStays) {
  const TempFolder folder;
  const std::string path = folder.file("a.wav", "old");
  {
    PartFile file(path);
    file.writeAt(0, "new");
  }
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(folder.files(), 1U);
}

TEST(PartFile, AFolderThatIsNotThereIsNamed) {
  const PartFile file("/no/such/folder/a.wav");
  EXPECT_FALSE(file.opened());
  EXPECT_EQ(file.failure().line(), "/no/such/folder/a.wav: cannot be written (No such file or directory)");
}

TEST(PartFile, WhatFindsNoRoomIsSaidAtTheEnd) {
  const TempFolder folder;
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{20'000, before.rlim_max};
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);  // write() fails instead
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  PartFile file(folder / "a.wav");
  const bool opened = file.opened();
  if (opened) file.writeAt(0, std::string(100'000, 'x'));
  const Status status = opened ? file.finish() : Status(Done{});
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().line().find("File too large"), std::string::npos) << status.error().line();
  EXPECT_TRUE(std::filesystem::is_empty(folder / "")) << "neither the file nor a part of it";
}

TEST(PartFile, TwoAtOnceDoNotMixAndTheLastStays) {
  const TempFolder folder;
  PartFile one(folder / "a.txt"), other(folder / "a.txt");
  one.writeAt(0, "one");
  other.writeAt(0, "other");
  ASSERT_TRUE(other.finish().ok());
  ASSERT_TRUE(one.finish().ok());
  std::ifstream in(folder / "a.txt");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "one");
}

}  // namespace
}  // namespace stillcut::record
