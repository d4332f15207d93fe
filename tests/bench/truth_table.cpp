// truth_table [TOOLS [FIRST]]: the truth of the simulated cut against the exact lobes at 0.9 and 1.1 times the limit,
// over random tools, engagements, helices, pitches and force laws; lists every cut in which they disagree. 500 tools
// unless told, from the one numbered FIRST; minutes. With a single tool its case is printed, for `stillcut-cli lobes`.

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "core/milling/model_toml.h"
#include "tests/support/truth_cuts.h"

namespace stillcut {
namespace {

constexpr int kKinds = 5;

struct Tally {
  int judged = 0, young = 0, wrong = 0;
};

class Table {
 public:
  Table(int tools, int first) : tools_(tools), next_(first), last_(first + tools) {}

  int run() {
    {
      std::vector<std::jthread> threads;
      for (unsigned i = 0; i < 2; ++i) threads.emplace_back([this] { work(); });
    }
    Tally all;
    for (int k = 0; k < kKinds; ++k) {
      const Tally& t = tallies_[static_cast<std::size_t>(k)];
      std::printf("%-22s %4d judged, %3d had no time to grow, %d disagree\n",
                  test::cutKindName(static_cast<test::CutKind>(k)), t.judged, t.young, t.wrong);
      all.judged += t.judged;
      all.wrong += t.wrong;
    }
    std::printf("%d cuts judged, %d disagree, %d tools refused\n", all.judged, all.wrong, refused_.load());
    return 0;
  }

 private:
  void work() {
    for (int n = next_++; n < last_; n = next_++) one(n);
  }

  void one(int n) {
    milling::NoiseSource random(1u + static_cast<unsigned>(n));
    const auto kind = static_cast<test::CutKind>(n % kKinds);
    const milling::Scenario s = test::randomCut(random, kind);
    if (tools_ == 1) std::printf("%s", milling::modelText(s.model).c_str());
    const auto known = test::knownLimit(s);
    if (!known) ++refused_;
    if (!known || !known.value()) return;
    for (double factor : {0.9, 1.1}) {
      const test::Comparison found = test::compareWithTruth(s, **known, factor);
      const std::scoped_lock lock(mutex_);
      Tally& t = tallies_[static_cast<std::size_t>(kind)];
      if (found.agreement == test::Agreement::NoTimeToGrow) {
        ++t.young;
        continue;
      }
      ++t.judged;
      if (found.agreement == test::Agreement::Agrees) continue;
      ++t.wrong;
      std::printf("tool %d: %s\n", n, test::comparisonText(s, **known, factor, found).c_str());
      std::fflush(stdout);
    }
  }

  int tools_;
  std::atomic<int> next_;
  int last_;
  std::atomic<int> refused_{0};
  std::mutex mutex_;  // of the tallies and the lines
  std::array<Tally, kKinds> tallies_{};
};

}  // namespace
}  // namespace stillcut

int main(int argc, char** argv) {
  const int tools = argc > 1 ? std::atoi(argv[1]) : 500;
  const int first = argc > 2 ? std::atoi(argv[2]) : 0;
  return stillcut::Table(tools, first).run();
}
