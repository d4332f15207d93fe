// Strangers' HDF5 files are read by another process: what it reads comes back whole, its death is one line, at any
// block, and no lock that this process holds meanwhile is waited for.
#include "core/formats/hdf5/isolated_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <thread>

#include "core/session/convert_recording.h"
#include "core/storage/hdf5_file.h"
#include "tests/support/read_all.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

using testing::HasSubstr;

std::string foreign(const TempFolder& folder, int frames) {
  std::string text = "t,Fx (N),Fy (N)\n";
  for (int i = 0; i < frames; ++i) {
    char line[64];
    std::snprintf(line, sizeof line, "%.3f,%d,%d\n", i * 1e-3, i, -i);
    text += line;
  }
  std::string path = folder / "foreign.h5";
  EXPECT_TRUE(convertRecording(folder.file("in.csv", text), path).ok());
  return path;
}

// The one child of this thread.
pid_t child() {
  std::ifstream children("/proc/thread-self/children");
  pid_t number = -1;
  children >> number;
  return number;
}

TEST(IsolatedReader, HandsOverEverySampleInBlocksOfAnyLength) {
  const TempFolder folder;
  const std::string path = foreign(folder, 5000);
  for (const int capacity : {1, 333, 5000, 100'000}) {
    const WholeRecording all = readAll(path, {}, capacity);
    ASSERT_EQ(all.error, "");
    ASSERT_EQ(all.values.at(1).size(), 5000U);
    for (std::size_t i = 0; i < 5000; ++i) ASSERT_EQ(all.values[1][i], -static_cast<double>(i));
  }
  ReadOptions options;
  options.channels = {1};
  options.scale = 2.0;
  const WholeRecording chosen = readAll(path, options);
  ASSERT_EQ(chosen.values.size(), 1U);
  EXPECT_EQ(chosen.values[0].at(7), -14.0);
}

TEST(IsolatedReader, TheDeathOfTheProcessIsOneLineAtAnyBlock) {
  const TempFolder folder;
  const std::string path = foreign(folder, 5000);
  for (const int before : {0, 3}) {
    const auto reader = openIsolated(path, "", {});
    ASSERT_TRUE(reader.ok()) << reader.error().line();
    ASSERT_NE(*reader, nullptr);
    SampleBlock block;
    block.allocate(2, 100);
    for (int i = 0; i < before; ++i) {
      const Result<bool> more = (*reader)->read(block);
      ASSERT_TRUE(more.ok() && *more);
    }
    const pid_t process = child();
    ASSERT_GT(process, 0);
    ASSERT_EQ(::kill(process, SIGSEGV), 0);
    const Result<bool> more = (*reader)->read(block);
    ASSERT_FALSE(more.ok());
    EXPECT_EQ(more.error().line(), path + ": the HDF5 library cannot read it (a damaged file)");
  }
  EXPECT_LE(child(), 0) << "no process is left behind";
}

// With a fork in place of a fresh process this hangs: the copy of the library's lock would stay locked for ever.
TEST(IsolatedReader, OpensWhileAnotherThreadIsInTheLibraryAllTheTime) {
  const TempFolder folder;
  const std::string path = foreign(folder, 50);
  std::atomic<bool> done{false};
  std::thread busy([&] {
    quietHdf5();
    while (!done) Hdf5Id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
  });
  for (int i = 0; i < 20; ++i) EXPECT_EQ(readAll(path).error, "");
  done = true;
  busy.join();
}

TEST(IsolatedReader, WhatTheImporterRefusesIsSaidInItsWords) {
  const TempFolder folder;
  const std::string path = foreign(folder, 50);
  ReadOptions options;
  options.channels = {5};
  EXPECT_THAT(readAll(path, options).error, HasSubstr("5"));
  EXPECT_THAT(readAll(path + ":/nothing").error, HasSubstr("nothing"));
}

}  // namespace
}  // namespace stillcut::record
