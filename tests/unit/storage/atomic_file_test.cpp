#include "core/storage/atomic_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace stillcut {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class AtomicFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  auto filesLeft() const { return std::distance(fs::directory_iterator(folder_), {}); }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("stillcut-atomic-file-" + std::to_string(::getpid()));
};

TEST_F(AtomicFile, CreatesAndReplacesAndLeavesNothingElse) {
  const fs::path file = folder_ / "a.toml";
  ASSERT_TRUE(writeFileAtomically(file, "one").ok());
  const std::string binary("two\0\n\xff", 6);
  ASSERT_TRUE(writeFileAtomically(file, binary).ok());
  EXPECT_EQ(contentOf(file), binary);
  EXPECT_EQ(filesLeft(), 1);
}

TEST_F(AtomicFile, AFailureNamesFileAndCauseAndTouchesNothing) {
  const fs::path folderInTheWay = folder_ / "taken";
  fs::create_directories(folderInTheWay / "inside");
  const Status failed = writeFileAtomically(folderInTheWay, "text");
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().line(), folderInTheWay.string() + ": cannot be written (Is a directory)");
  EXPECT_TRUE(fs::is_directory(folderInTheWay / "inside"));
  EXPECT_EQ(filesLeft(), 1) << "the temporary file is gone";
}

TEST_F(AtomicFile, AMissingFolderIsNamedAsTheCause) {
  const Status failed = writeFileAtomically(folder_ / "no" / "such" / "folder.toml", "text");
  ASSERT_FALSE(failed.ok());
  EXPECT_EQ(text(failed.error().why), "No such file or directory");
}

}  // namespace
}  // namespace stillcut
