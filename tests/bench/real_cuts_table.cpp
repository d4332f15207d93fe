// bench_real_cuts [--each] [DETECTOR ...]: every shared real recording, every detector (or those named), told speed
// exact, 2 % low, 2 % high and not at all. Per line: delay of the first alarm in the chatter segment, part of it that
// is in alarm and in full chatter, alarm outside of it [s] and where the first one began. --each: every channel alone
// as well. --file TEXT: those whose path holds it. --looks ERROR: at this error of the told speed, every look at the
// line series (core/spindle/series_watch.h).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/support/real_cuts.h"

namespace stillcut::bench {
namespace {

constexpr double kErrors[] = {0.0, -0.02, 0.02, -1.0};  // of the told speed; -1: not told

void print(const RealCut& cut, const std::vector<int>& channels, double error, const std::vector<Tally>& all) {
  char told[16];
  std::snprintf(told, sizeof told, error <= -1.0 ? "none" : "%+.0f %%", 100.0 * error);
  std::string which;
  for (const int c : channels) which += std::to_string(c);
  for (const Tally& t : all) {
    std::printf("%-38.38s %-5s %4s %-12s", cut.file.filename().c_str(), which.empty() ? "all" : which.c_str(), told,
                t.id.c_str());
    const double length = chatterLength(cut);
    if (length > 0.0 && t.delay >= 0.0) {
      std::printf(" delay %5.2f s, alarm %5.1f %%, chatter %5.1f %%", t.delay, 100.0 * t.alarm / length,
                  100.0 * t.chatter / length);
    } else if (length > 0.0) {
      std::printf(" missed                                     ");
    }
    if (t.falseAlarm > 0.0) std::printf("  FALSE %.2f s from %.2f s", t.falseAlarm, t.firstFalse);
    if (t.invalid > 0.0) std::printf("  invalid %.2f s", t.invalid);
    std::printf("\n");
  }
  std::fflush(stdout);
}

void printLook(const detect::ConditionedBlock& block) {
  static unsigned last = 0;
  const detect::SeriesLook& l = block.series;
  if (l.count == last) return;
  last = l.count;
  std::printf(
      "%8.3f %-6s %8.1f rpm used %8.1f sd %.4f certainty %.2f teeth %d lines %2d explained %.2f  off %.2f joint "
      "%.2f "
      "at %7.1f Hz %+.3f x%d channel %d%s%s%s%s\n",
      sinceEpoch(block.end()).value, std::string(name(block.phase)).c_str(), 60.0 * l.spindle.value,
      60.0 * block.spindle.value, l.sd, l.certainty, l.teethHeard, l.lines, l.explained, l.free.share, l.joint,
      l.free.line.value, l.free.offset, l.free.members, l.channel, l.whole ? "" : " part", l.leaving ? " leaving" : "",
      l.agreed ? "" : " DISAGREE", l.steady ? "" : " MOVES");
}

bool judge(const RealCut& cut, const std::vector<int>& channels, double error, const std::vector<std::string>& wanted,
           double begin, bool looks = false) {
  const auto all = judgeRealCut(cut, channels, error, wanted, begin,
                                looks ? printLook : std::function<void(const detect::ConditionedBlock&)>());
  if (!all) {
    std::fprintf(stderr, "%s\n", all.error().line().c_str());
    return false;
  }
  print(cut, channels, error, *all);
  return true;
}

int table(const std::vector<std::string>& wanted, bool each, const std::string& only, double looksAt, double begin,
          int axis) {
  const std::filesystem::path recordings = std::filesystem::path(STILLCUT_SHARED_DIR) / "recordings";
  std::vector<RealCut> cuts = realCuts(recordings);
  for (const RealCut& later : laterCuts(recordings)) cuts.push_back(later);
  if (cuts.empty()) {
    std::printf("no recordings at %s\n", STILLCUT_SHARED_DIR);
    return 0;
  }
  for (const RealCut& cut : cuts) {
    if (cut.file.string().find(only) == std::string::npos) continue;
    if (looksAt > -1.0) {
      judge(cut, axis >= 0 ? std::vector<int>{axis} : cut.channels, looksAt, wanted, begin, true);
      continue;
    }
    std::vector<std::vector<int>> sets{cut.channels};
    if (each && cut.channels.empty() && cut.file.filename() != "audio_T2503") sets.insert(sets.end(), {{0}, {1}, {2}});
    for (std::size_t s = 0; s < sets.size(); ++s) {
      bool read = true;
      for (const double error : kErrors) read = read && judge(cut, sets[s], error, wanted, begin);
      if (!read && s == 0) return 1;
      if (!read) break;  // it has no more channels
    }
  }
  return 0;
}

}  // namespace
}  // namespace stillcut::bench

int main(int argc, char** argv) {
  std::vector<std::string> wanted(argv + 1, argv + argc);
  const bool each = std::erase(wanted, "--each") > 0;
  std::string only;
  double looksAt = -1.0;
  double begin = 0.0;
  int axis = -1;
  for (auto w = wanted.begin(); w != wanted.end();) {
    const bool file = *w == "--file";
    const bool begins = *w == "--begin";
    const bool alone = *w == "--axis";
    if ((!file && !begins && !alone && *w != "--looks") || w + 1 == wanted.end()) {
      ++w;
      continue;
    }
    if (file) {
      only = *(w + 1);
    } else if (alone) {
      axis = std::atoi((w + 1)->c_str());
    } else if (begins) {
      begin = std::atof((w + 1)->c_str());
    } else {
      looksAt = std::atof((w + 1)->c_str());
    }
    w = wanted.erase(w, w + 2);
  }
  return stillcut::bench::table(wanted, each, only, looksAt, begin, axis);
}
