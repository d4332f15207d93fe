#include "tests/lint/edges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stillcut::lint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(IncludeEdges, TheTreeKeepsToTheTable) {
  const auto files = readTree(STILLCUT_SOURCE_DIR);
  ASSERT_GT(files.size(), 50u);
  EXPECT_THAT(forbiddenIncludes(files, roomTable()), IsEmpty());
}

TEST(IncludeEdges, TheLinkLinesKeepToTheTableAndCoverTheIncludes) {
  EXPECT_THAT(wrongLinks(readTree(STILLCUT_SOURCE_DIR), roomTable()), IsEmpty());
}

TEST(IncludeEdges, MethodsFormatsAndMachinesKnowNothingOfEachOther) {
  EXPECT_THAT(crossings(readTree(STILLCUT_SOURCE_DIR), separateFolders()), IsEmpty());
}

TEST(IncludeEdges, TheTableHasNoCycle) {
  EXPECT_THAT(tableFaults(roomTable()), IsEmpty());
}

// That the check itself can fail.

TEST(IncludeEdgesCheck, CatchesAForbiddenEdge) {
  const std::vector<SourceFile> files{
      {"core/detect/a.cpp", "// one\n#include \"core/model/verdict.h\"\n#  include \"core/control/strategy.h\"\n"}};
  EXPECT_THAT(forbiddenIncludes(files, roomTable()),
              ElementsAre("core/detect/a.cpp:3: core/detect must not include core/control/strategy.h"));
}

TEST(IncludeEdgesCheck, CatchesAStepUpAndAScreenThatReachesIntoTheCore) {
  const std::vector<SourceFile> files{{"core/base/a.h", "#include \"core/model/verdict.h\"\n"},
                                      {"ui/pages/b.cpp", "#include \"core/pipeline/engine.h\"\n"},
                                      {"core/milling/c.h", "#include \"core/milling/stability/zoa.h\"\n"}};
  EXPECT_EQ(forbiddenIncludes(files, roomTable()).size(), 3u);
}

TEST(IncludeEdgesCheck, CatchesQtInCoreButNotInUi) {
  const std::vector<SourceFile> files{{"core/rt/a.h", "#include <QString>\n"},
                                      {"core/rt/b.h", "#include <QtCore/qglobal.h>\n"},
                                      {"ui/pages/c.h", "#include <QWidget>\n"}};
  EXPECT_THAT(forbiddenIncludes(files, roomTable()),
              ElementsAre("core/rt/a.h:1: core knows no Qt, but includes QString",
                          "core/rt/b.h:1: core knows no Qt, but includes "
                          "QtCore/qglobal.h"));
}

TEST(IncludeEdgesCheck, CatchesAFileOutsideEveryRoomAndAnUnrootedInclude) {
  const std::vector<SourceFile> files{{"core/other/a.h", ""}, {"core/rt/b.cpp", "#include \"spsc_ring.h\"\n"}};
  EXPECT_EQ(forbiddenIncludes(files, roomTable()).size(), 2u);
}

TEST(IncludeEdgesCheck, CatchesAForbiddenLinkAndAnIncludeWithoutItsLink) {
  const std::vector<SourceFile> files{
      {"core/detect/CMakeLists.txt", "stillcut_room(core_detect SOURCES a.cpp # why\n LINKS core_model core_cnc)"},
      {"core/model/CMakeLists.txt", "stillcut_room(core_model LINKS core_base)"},
      {"core/detect/a.cpp", "#include \"core/base/units.h\"\n#include \"core/dsp/fft.h\"\n"}};
  EXPECT_THAT(wrongLinks(files, roomTable()),
              ElementsAre("core/detect/CMakeLists.txt: core_detect must not link core_cnc",
                          "core/detect/a.cpp:2: includes core/dsp/fft.h, but core/detect does not link core/dsp"));
}

TEST(IncludeEdgesCheck, CatchesAMethodThatIncludesAnother) {
  const std::vector<SourceFile> files{{"core/detect/xu/a.cpp",
                                       "#include \"core/detect/detector.h\"\n#include \"core/detect/growth/b.h\"\n"
                                       "#include \"core/detect/liao/c.h\"\n"}};
  EXPECT_THAT(crossings(files, separateFolders()),
              ElementsAre("core/detect/xu/a.cpp:3: core/detect/xu must know nothing of core/detect/liao/c.h"));
}

TEST(IncludeEdgesCheck, CatchesACycleInTheTable) {
  EXPECT_THAT(tableFaults({{"core/a", {"core/b"}}, {"core/b", {"core/a"}}}),
              ElementsAre("core/a may include core/b, which is not above it"));
}

}  // namespace
}  // namespace stillcut::lint
