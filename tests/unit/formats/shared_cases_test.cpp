// Files as users have them, with the right answers beside them. Skipped, saying so, where the folder is absent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/read_all.h"

namespace stillcut::record {
namespace {

struct Right {
  const char* file;
  std::size_t channels = 2;
  std::int64_t frames = 4000;
  std::size_t notes = 0;
};

std::filesystem::path folder() {
  return std::filesystem::path(STILLCUT_SHARED_DIR) / "cases_files";
}

class SharedCase : public testing::TestWithParam<Right> {};

TEST_P(SharedCase, IsReadAsItIs) {
  const Right& right = GetParam();
  const std::string path = folder() / right.file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "not here: " << path;
  const WholeRecording all = readAll(path);
  ASSERT_EQ(all.error, "");
  EXPECT_NEAR(all.format.rate.value, 10'000.0, 1e-6);
  EXPECT_EQ(all.format.channels.size(), right.channels);
  EXPECT_EQ(all.format.frames, right.frames);
  EXPECT_EQ(all.format.notes.size(), right.notes);
}

// A note: what is damaged or missing, or that the times have no unit and seconds were assumed.
INSTANTIATE_TEST_SUITE_P(All, SharedCase,
                         testing::Values(Right{"msec.csv"}, Right{"usec.csv"}, Right{"time_ns.csv"},
                                         Right{"seconds_elapsed.csv"}, Right{"hash_header.csv", 2, 4000, 1},
                                         Right{"quoted_decimal_comma.csv"}, Right{"sign_blank.txt"}, Right{"pipe.csv"},
                                         Right{"fortran_d.txt", 2, 4000, 1}, Right{"iso_time.csv"}, Right{"iso_T.csv"},
                                         Right{"clock_time.csv"}, Right{"date_and_time.csv"}, Right{"german_date.csv"},
                                         Right{"blank_cell.csv", 2, 3999, 1}, Right{"footer.csv", 2, 4000, 1},
                                         Right{"index_increment.csv"}, Right{"recorder_killed.wav", 2, 4000, 1},
                                         Right{"sox_killed.wav", 2, 4000, 1}, Right{"size_zero.wav", 2, 4000, 1},
                                         Right{"broken_off.wav", 2, 2749, 1}, Right{"abscissa_written.uff", 1},
                                         Right{"two_rates.uff", 1, 4000, 1}, Right{"txy.mat", 2, 4000, 1},
                                         Right{"struct.mat"}, Right{"not_closed.h5", 1, 4000, 1}),
                         [](const auto& instance) {
                           std::string name = instance.param.file;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(SharedCases, NamesOverMoreColumnsAreRefusedWhateverTheRate) {
  const std::string path = folder() / "comma_comma.csv";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "not here: " << path;
  EXPECT_THAT(readAll(path).error, testing::HasSubstr("commas"));
  ReadOptions options;
  options.rate = Hertz(10'000.0);
  EXPECT_THAT(readAll(path, options).error, testing::HasSubstr("commas"));
  EXPECT_EQ(readAll(folder() / "hash_header.csv", options).format.channels.size(), 2U) << "a time is no channel";
}

}  // namespace
}  // namespace stillcut::record
