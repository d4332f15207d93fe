// The pyramid: any span drawn from it is what the samples themselves would draw, also after a crash and across gaps;
// and a reader goes to any time.
#include "core/session/session_overview.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/session/file/session_reader.h"
#include "core/session/file/session_writer.h"
#include "core/session/open_recording.h"
#include "tests/support/crash_lab.h"
#include "tests/support/step_samples.h"
#include "tests/support/temp_folder.h"

namespace stillcut::record {
namespace {

constexpr double kRate = 1000.0;
constexpr int kFrames = 500;

// Frame f of channel 0: something irregular, so that no two buckets have the same extremes.
float sampleAt(std::uint64_t f) {
  return static_cast<float>(std::sin(static_cast<double>(f) * 0.7) * (1.0 + static_cast<double>(f % 7919) * 1e-3));
}

// Blocks of half a second from 10 s on; after block `gapAfter` a pause of `pause`.
std::unique_ptr<SessionWriter> writeBlocks(const std::string& path, int blocks, int gapAfter = -1,
                                           Duration pause = {}) {
  SessionHeader header = exampleHeader();
  header.setup.rate = Hertz(kRate);
  header.setup.blockFrames = kFrames;
  auto writer = SessionWriter::create(path, header);
  EXPECT_TRUE(writer.ok());
  StepInput input;
  input.block.allocate(2, kFrames);
  input.block.frames = kFrames;
  input.block.rate = Hertz(kRate);
  const StepOutput output;
  Instant time = instantFromNs(10'000'000'000);
  for (int b = 0; b < blocks; ++b) {
    input.block.sequence = static_cast<std::uint64_t>(b);
    input.block.firstSample = time;
    for (int f = 0; f < kFrames; ++f) {
      const float s = sampleAt(static_cast<std::uint64_t>(b * kFrames + f));
      input.block.channel(0)[static_cast<std::size_t>(f)] = s;
      input.block.channel(1)[static_cast<std::size_t>(f)] = -s;
    }
    EXPECT_TRUE((*writer)->add(input, output).ok());
    time += std::chrono::milliseconds(500) + (b == gapAfter ? pause : Duration{});
  }
  EXPECT_TRUE((*writer)->flush().ok());
  return std::move(*writer);
}

MinMax plainly(std::uint64_t from, std::uint64_t to) {
  MinMax m{sampleAt(from), sampleAt(from)};
  for (std::uint64_t f = from; f < to; ++f) m = {std::min(m.min, sampleAt(f)), std::max(m.max, sampleAt(f))};
  return m;
}

TEST(Overview, ColumnsOfWholeBucketsAreWhatTheSamplesSay) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  constexpr int kBlocks = 300;  // 150 000 frames: two full buckets of level 2, and a tail
  ASSERT_TRUE(writeBlocks(path, kBlocks)->close().ok());
  auto overview = SessionOverview::open(path);
  ASSERT_TRUE(overview.ok()) << overview.error().line();
  const double scale = exampleSetup().channels[0].scale;
  EXPECT_EQ(toNs((*overview)->begin()), 10'000'000'000);
  EXPECT_EQ(toNs((*overview)->end()), 160'000'000'000);
  for (const std::uint64_t bucket : {1ULL, 256ULL, 4096ULL, 65536ULL}) {
    const std::uint64_t columns = std::min<std::uint64_t>(150'000 / bucket, 500);
    const Instant from = (*overview)->begin();
    const Instant to = from + std::chrono::milliseconds(bucket * columns);
    const auto picture = (*overview)->overview(0, from, to, static_cast<int>(columns));
    ASSERT_TRUE(picture.ok()) << picture.error().line();
    ASSERT_EQ(picture->size(), columns);
    for (std::uint64_t c = 0; c < columns; ++c) {
      const MinMax expected = plainly(c * bucket, (c + 1) * bucket);
      ASSERT_EQ(picture.value()[c].min, static_cast<float>(expected.min * scale)) << bucket << " " << c;
      ASSERT_EQ(picture.value()[c].max, static_cast<float>(expected.max * scale)) << bucket << " " << c;
    }
  }
  // Everything in one column, tail included.
  const auto all = (*overview)->overview(0, (*overview)->begin(), (*overview)->end(), 1);
  ASSERT_TRUE(all.ok());
  EXPECT_EQ(all.value()[0].max, static_cast<float>(plainly(0, 150'000).max * scale));
  EXPECT_FALSE((*overview)->overview(2, (*overview)->begin(), (*overview)->end(), 1).ok());
  EXPECT_FALSE((*overview)->overview(0, (*overview)->end(), (*overview)->begin(), 1).ok());
}

TEST(Overview, AColumnShorterThanASampleShowsItAndAGapShowsNothing) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  ASSERT_TRUE(writeBlocks(path, 20, 9, std::chrono::seconds(5))->close().ok());
  auto overview = SessionOverview::open(path);
  ASSERT_TRUE(overview.ok());
  EXPECT_EQ(toNs((*overview)->end()), 25'000'000'000) << "ten seconds of samples in fifteen";
  const auto close = (*overview)->overview(0, instantFromNs(10'100'000'000), instantFromNs(10'104'000'000), 16);
  ASSERT_TRUE(close.ok());
  for (const MinMax& column : close.value()) EXPECT_FALSE(std::isnan(column.min));
  const auto across = (*overview)->overview(0, instantFromNs(14'000'000'000), instantFromNs(21'000'000'000), 7);
  ASSERT_TRUE(across.ok());
  for (std::size_t c = 0; c < 7; ++c) {
    const bool inGap = c >= 1 && c <= 5;
    EXPECT_EQ(std::isnan(across.value()[c].min), inGap) << c;
  }
  // A column reaches as far as the buckets it touches.
  const double scale = exampleSetup().channels[0].scale;
  EXPECT_GE(across.value()[6].max, static_cast<float>(plainly(5000, 6000).max * scale));
  EXPECT_LE(across.value()[6].max, static_cast<float>(plainly(4864, 6144).max * scale));
}

TEST(Overview, ASessionThatIsStillWrittenOrWasCutOffIsDrawnToItsLastFlush) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  const auto writer = writeBlocks(path, 41);  // 20 500 frames: five buckets of 4096, none of 65536
  auto overview = SessionOverview::open(path);
  ASSERT_TRUE(overview.ok()) << overview.error().line();
  EXPECT_FALSE((*overview)->format().closedCleanly);
  const auto all = (*overview)->overview(1, (*overview)->begin(), (*overview)->end(), 5);
  ASSERT_TRUE(all.ok());
  EXPECT_EQ((*overview)->format().frames, 20'500);
  const double scale = exampleSetup().channels[1].scale;
  EXPECT_GE(all.value()[4].max, static_cast<float>(-plainly(16'400, 20'500).min * scale)) << "the tail is in it";
}

TEST(Seek, GoesToTheBlockOfATimeWithAllThatBelongsToIt) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  ASSERT_TRUE(writeBlocks(path, 20, 9, std::chrono::seconds(5))->close().ok());
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok());
  SampleBlock block;
  block.allocate(2, kFrames);
  const struct {
    double at;
    std::uint64_t block;
  } cases[] = {{10.0, 0}, {0.0, 0}, {12.25, 4}, {14.999, 9}, {17.0, 10}, {20.0, 10}, {24.9, 19}, {10.5, 1}};
  for (const auto& c : cases) {
    const Result<bool> found = (*reader)->seek(instantFromNs(0) + toDuration(Seconds(c.at)));
    ASSERT_TRUE(found.ok() && *found) << c.at;
    const Result<bool> more = (*reader)->read(block);
    ASSERT_TRUE(more.ok() && *more);
    EXPECT_EQ(block.sequence, c.block) << c.at;
  }
  ASSERT_TRUE((*reader)->seek(instantFromNs(99'000'000'000)).ok());
  EXPECT_FALSE(*(*reader)->read(block)) << "behind the end nothing is left";
}

TEST(Seek, VerdictsInputsAndEventsComeAlong) {
  const TempFolder folder;
  const std::string path = folder / "cut.h5";
  {
    auto writer = SessionWriter::create(path, exampleHeader());
    ASSERT_TRUE(writer.ok());
    for (int i = 0; i < 900; ++i) {
      StepRecord step = exampleStep(i);
      step.input.block.flags = 0;
      ASSERT_TRUE((*writer)->add(step.input, step.output).ok());
    }
  }
  const auto reader = openRecording(path);
  ASSERT_TRUE(reader.ok());
  SampleBlock block;
  block.allocate(2, 64);
  for (const int wanted : {700, 3, 450, 899}) {
    const StepRecord expected = exampleStep(wanted);
    ASSERT_TRUE((*reader)->seek(expected.input.block.firstSample).ok());
    ASSERT_TRUE(*(*reader)->read(block));
    // Blocks of uneven length and rate: the one found may be a neighbour, never another one's verdicts.
    const int got = static_cast<int>(block.sequence / 3);
    EXPECT_NEAR(got, wanted, 1);
    EXPECT_EQ(bitsOf((*reader)->recordedStep()->output), bitsOf(exampleStep(got).output));
  }
}

}  // namespace
}  // namespace stillcut::record
