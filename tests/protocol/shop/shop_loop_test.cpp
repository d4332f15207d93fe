// A source that is read again from an earlier place, as the journal is at every start.
#include "app/shop/shop_loop.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/shop/run_lines.h"
#include "tests/support/temp_folder.h"

namespace stillcut::shop {
namespace {

using record::TempFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::json;
using testing::kBegan;
using testing::RunLines;

// Lines without a cursor, all at once.
class Lines final : public LineSource {
 public:
  explicit Lines(std::vector<json> lines) : lines_(std::move(lines)) {}
  ~Lines() override { ::close(readable_); }
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;
  Result<std::vector<SourceLine>> read(std::size_t /*atMost*/) override {
    std::vector<SourceLine> all;
    for (const json& line : std::exchange(lines_, {})) all.push_back({line.dump(), ""});
    return all;
  }
  int descriptor() const override { return readable_; }
  bool goesOn() const override { return false; }
  bool atEnd() const override { return lines_.empty(); }

 private:
  std::vector<json> lines_;
  int readable_ = ::open("/dev/null", O_RDONLY | O_CLOEXEC);  // always, so that the loop does not wait
};

class Heard final : public Listener {
 public:
  void hear(const json& line) override { lines.push_back(line["sequence"]); }
  void addEntries(std::vector<pollfd>& /*entries*/) const override {}
  void recall(const json& line) override { recalled.push_back(line["sequence"]); }
  void turn() override {}
  std::vector<int> lines, recalled;
};

// Start and a line a second, numbered from 1.
std::vector<json> aRun(std::int64_t began, int lines) {
  RunLines run(began);
  std::vector<json> all{run.start()};
  while (static_cast<int>(all.size()) < lines)
    all.push_back(run.state("status", static_cast<double>(all.size()), "stable"));
  return all;
}
std::vector<json> joined(std::vector<json> first, const std::vector<json>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

class AShopLoop : public ::testing::Test {
 protected:
  std::vector<int> told(std::vector<json> lines) {
    Lines source(std::move(lines));
    Heard heard;
    auto outbox = Outbox::open(folder_ / "box");
    ShopLoop loop({source, **outbox, nullptr, {&heard}, true}, [](const std::string&) {});
    EXPECT_TRUE(loop.run(-1, [] { return false; }).ok());
    recalled_ = heard.recalled;
    topics_.clear();
    for (const Outbox::Kept& kept : (*outbox)->after(0, 1000)) {
      topics_.push_back(kept.topic);
      runs_.push_back(json::parse(kept.payload)["run"]);
    }
    return heard.lines;
  }
  TempFolder folder_;
  std::vector<int> recalled_;
  std::vector<std::string> topics_;
  std::vector<std::int64_t> runs_;
};

TEST_F(AShopLoop, TakesTheTailOfAnOlderRunForWhatItIs) {
  const auto older = aRun(kBegan, 20), newer = aRun(kBegan + 3'600'000, 8);
  EXPECT_THAT(told(joined(older, {newer.begin(), newer.begin() + 5})), ::testing::SizeIs(25));
  const std::vector<json> tail(older.begin() + 2, older.end());
  EXPECT_THAT(told(joined(tail, newer)), ElementsAre(6, 7, 8));
  EXPECT_THAT(topics_, ::testing::Not(::testing::Contains("event/fault")));
  EXPECT_THAT(told(joined(tail, newer)), IsEmpty());
}

// Run for more than two days: its start is no longer in the window.
TEST_F(AShopLoop, GoesOnWithARunWhoseStartIsNoLongerThere) {
  const auto run = aRun(kBegan, 12);
  EXPECT_THAT(told({run.begin(), run.begin() + 6}), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(told({run.begin() + 3, run.begin() + 9}), ElementsAre(7, 8, 9));
  EXPECT_THAT(runs_, ::testing::Each(kBegan));
}

// For an agent that connects after a restart: tool and job of the run, and how it stands.
TEST_F(AShopLoop, RecallsTheStartAndTheNewestLine) {
  const auto run = aRun(kBegan, 12);
  told({run.begin(), run.begin() + 6});
  EXPECT_THAT(recalled_, IsEmpty());
  told({run.begin() + 6, run.begin() + 9});
  EXPECT_THAT(recalled_, ElementsAre(1, 6));
  told({});
  EXPECT_THAT(recalled_, ElementsAre(1, 9));
}

TEST_F(AShopLoop, TellsOfARunThatItMeetsInTheMiddle) {
  const auto run = aRun(kBegan, 12);
  EXPECT_THAT(told({run.begin() + 3, run.begin() + 9}), ElementsAre(4, 5, 6, 7, 8, 9));
}

}  // namespace
}  // namespace stillcut::shop
