// Cuts are kept for good: they survive a kill, merge without duplicates, and no foreign file is touched.
#include "core/learn/evidence_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/learn/evidence_lines.h"
#include "tests/support/temp_folder.h"

namespace stillcut::learn {
namespace {

using testing::HasSubstr;

CutEvidence aCut(double speed, CutOutcome outcome = CutOutcome::Stable) {
  CutEvidence cut;
  cut.assembly = {"Mill 3", "T12", "ER32", Metres(0.048)};
  cut.material = "aluminium";
  cut.teeth = 4;
  cut.diameter = Metres(0.012);
  cut.speed = Rpm(speed);
  cut.depth = Metres(0.0013);
  cut.engagement = {0.5, milling::MillingDirection::Down, {}};
  cut.outcome = outcome;
  if (outcome == CutOutcome::Chatter) cut.frequency = Hertz(913.7);
  cut.frequencySd = Hertz(1.25);
  cut.time_s = 1'700'000'000 + static_cast<std::int64_t>(speed);
  cut.source = "a \"cut\", Größe 12.h5";
  return cut;
}

std::string bytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class EvidenceStoreTest : public testing::Test {
 protected:
  EvidenceStore opened(const std::string& name) {
    auto store = EvidenceStore::open(folder_ / name);
    EXPECT_TRUE(store.ok()) << (store ? "" : store.error().line());
    return std::move(store).value();
  }
  record::TempFolder folder_;
};

TEST_F(EvidenceStoreTest, KeepsEveryFieldOfACut) {
  CutEvidence cut = aCut(8500.0, CutOutcome::Chatter);
  cut.engagement = milling::engagementBetween(0.7, 2.1);
  const std::string id = opened("a").add(cut).value();
  const auto kept = opened("a").cuts().value();
  ASSERT_EQ(kept.size(), 1U);
  cut.id = id;
  EXPECT_EQ(evidenceLine(kept[0]), evidenceLine(cut));
  EXPECT_EQ(kept[0].speed, cut.speed);
  EXPECT_EQ(kept[0].depth, cut.depth);
}

TEST_F(EvidenceStoreTest, FindsTheCutsOfOneAssemblyByTime) {
  EvidenceStore store = opened("a");
  for (const double speed : {9000.0, 7000.0, 8000.0}) ASSERT_TRUE(store.add(aCut(speed)).ok());
  CutEvidence other = aCut(5000.0, CutOutcome::Chatter);
  other.assembly.stickOut = Metres(0.060);
  ASSERT_TRUE(store.add(other).ok());
  const auto found = store.cuts({"Mill 3", "T12", "", Metres(0.048)}).value();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].speed.value, 7000.0);
  EXPECT_EQ(found[2].speed.value, 9000.0);
  const auto counted = store.assemblies().value();
  ASSERT_EQ(counted.size(), 2U);
  EXPECT_EQ(counted[0].stable, 3);
  EXPECT_EQ(counted[1].chatter, 1);
}

TEST_F(EvidenceStoreTest, MergesMachinesWithoutDuplicates) {
  EvidenceStore first = opened("a");
  EvidenceStore second = opened("b");
  ASSERT_TRUE(first.add(aCut(7000.0)).ok());
  ASSERT_TRUE(second.add(aCut(8000.0)).ok());
  EXPECT_EQ(first.merge(folder_ / "b").value().added, 1);
  const MergeCount again = first.merge(folder_ / "b").value();
  EXPECT_EQ(again.added, 0);
  EXPECT_EQ(again.known, 1);
  const std::string lines = first.exportLines().value();
  const MergeCount back = second.importLines(lines, "lines").value();
  EXPECT_EQ(back.added, 1);
  EXPECT_EQ(back.known, 1);
  EXPECT_EQ(second.exportLines().value(), lines);
}

TEST_F(EvidenceStoreTest, TakesAllLinesOrNone) {
  EvidenceStore store = opened("a");
  std::string lines;
  CutEvidence cut = aCut(7000.0);
  cut.id = newEvidenceId();
  lines = evidenceLine(cut) + "\n\n{\"schema\": \"stillcut-evidence/1\", \"teeth\": \"four\"}\n";
  const auto read = store.importLines(lines, "cuts.jsonl");
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().line(), HasSubstr("cuts.jsonl:3"));
  EXPECT_TRUE(store.cuts().value().empty());
  for (const char* bad : {"[]", "nonsense", "{\"a\": 1}", "\x80\xff", "{\"schema\": \"stillcut-evidence/1\"}"}) {
    EXPECT_FALSE(store.importLines(bad, "cuts.jsonl").ok()) << bad;
  }
}

TEST_F(EvidenceStoreTest, RefusesWhatIsNoCut) {
  EvidenceStore store = opened("a");
  CutEvidence deep = aCut(7000.0);
  deep.depth = Metres(std::nan(""));
  EXPECT_FALSE(store.add(deep).ok());
  CutEvidence nameless = aCut(7000.0);
  nameless.assembly.tool.clear();
  EXPECT_FALSE(store.add(nameless).ok());
  EXPECT_FALSE(store.remove("nobody").ok());
  EXPECT_TRUE(store.cuts().value().empty());
}

TEST_F(EvidenceStoreTest, LeavesForeignFilesAsTheyAre) {
  const std::string text = folder_ / "notes.txt";
  std::ofstream(text) << "these are a shop's notes, and no database at all, however often they are opened as one";
  const std::string foreign = folder_ / "other.sqlite";
  sqlite3* db = nullptr;
  ASSERT_EQ(sqlite3_open(foreign.c_str(), &db), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(db, "CREATE TABLE bookmark(a); INSERT INTO bookmark VALUES(1)", nullptr, nullptr, nullptr),
            SQLITE_OK);
  sqlite3_close(db);
  for (const std::string& path : {text, foreign}) {
    const std::string before = bytesOf(path);
    const auto store = EvidenceStore::open(path);
    ASSERT_FALSE(store.ok());
    EXPECT_THAT(store.error().line(), HasSubstr(path));
    EXPECT_EQ(bytesOf(path), before);
  }
  EXPECT_FALSE(EvidenceStore::openToRead(folder_ / "missing").ok());
  EXPECT_FALSE(std::filesystem::exists(folder_ / "missing"));
  EXPECT_FALSE(EvidenceStore::open(folder_ / "").ok());
}

// A writer that is killed again and again loses nothing that it said was kept.
TEST_F(EvidenceStoreTest, SurvivesAKill) {
  const auto path = folder_ / "a";
  opened("a");
  std::size_t said = 0;
  for (int round = 0; round < 3; ++round) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
      auto store = EvidenceStore::open(path);
      for (int i = 1; store && store->add(aCut(1000.0 + i)); ++i) {
        if (::write(ends[1], "x", 1) != 1) break;
      }
      _exit(1);
    }
    ::close(ends[1]);
    char mark = 0;
    for (int i = 0; i < 3 + round && ::read(ends[0], &mark, 1) == 1; ++i) ++said;
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    while (::read(ends[0], &mark, 1) == 1) ++said;
    ::close(ends[0]);
  }
  const auto kept = opened("a").cuts().value();
  EXPECT_GE(kept.size(), said);
  EXPECT_LE(kept.size(), said + 3);  // one each was kept and not yet said
}

}  // namespace
}  // namespace stillcut::learn
