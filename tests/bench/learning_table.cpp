// How the learner does on random machines it does not know, as Markdown; minutes.
//   learning_table [MACHINES] [FIRST SEED]

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "tests/support/hidden_machines/learning_trial.h"

namespace stillcut::test {
namespace {

constexpr double kTrial_s = 2.0;  // of a cut that chatters, until it is stopped

struct Row {
  const char* name;
  std::vector<LimitScore> scores{};
  int chattered = 0;
};

void print(const Row& row) {
  double called = 0.0;
  double stable = 0.0;
  double removal = 0.0;
  int chattering = 0;
  std::vector<double> errors;
  for (const LimitScore& s : row.scores) {
    called += s.called;
    stable += s.stable;
    removal += s.removal;
    chattering += s.removal == 0.0 ? 1 : 0;
    errors.push_back(s.error);
  }
  std::ranges::sort(errors);
  const auto n = static_cast<double>(row.scores.size());
  std::printf("| %s | %.1f | %.0f | %.0f | %.0f | %.0f | %.1f |\n", row.name, 100.0 * stable / std::max(1.0, called),
              100.0 * errors[errors.size() / 2], 100.0 * errors[errors.size() * 9 / 10], 100.0 * removal / n,
              100.0 * chattering / n, kTrial_s * row.chattered / n);
}

// Time of this thread alone, whatever else the computer does [s].
template <class Work>
double timed(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

class Table {
 public:
  void add(std::uint64_t seed) {
    const HiddenMachine machine = hiddenMachine(seed);
    learn::Random random(seed);
    OrdinaryShop shop(machine, seed);
    std::vector<learn::CutEvidence> cuts;
    int chattered = 0;
    for (int k = 0; k < 30; ++k) {
      cuts.push_back(shop.next());
      chattered += cuts.back().outcome == learn::CutOutcome::Chatter ? 1 : 0;
    }
    own_ += ownRemoval(machine, cuts);
    const learn::MachinePrior plain = learn::priorOfTool(machine.model.tool.diameter, machine.material);
    const learn::MachinePrior tap = tapped(machine, random);
    learn::LobePosterior nothing(plain, rangeFor(machine));
    rows_[0].scores.push_back(scoreOf(nothing, machine, 0));
    rows_[1].chattered += chooseCuts(nothing, machine, 5, seed);
    rows_[1].scores.push_back(scoreOf(nothing, machine, 5));
    ordinary(plain, machine, cuts, rows_[2]);
    learn::LobePosterior fresh(tap, rangeFor(machine));
    rows_[3].scores.push_back(scoreOf(fresh, machine, 0));
    rows_[4].scores.push_back(scoreOf(fresh, machine, 30));
    ordinary(tap, machine, cuts, rows_[5]);
    rows_[2].chattered += chattered;
    rows_[5].chattered += chattered;
  }

  void print(int machines, std::uint64_t first) const {
    std::printf("%d machines from seed %llu\n\n", machines, static_cast<unsigned long long>(first));
    std::printf(
        "| known | stable of 90 %% | error [%%] | of the worst tenth [%%] | removal [%% of most] | advice chatters "
        "[%%] "
        "| chatter [s] |\n|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows_) test::print(row);
    std::printf("\nThe shop alone removes %.0f %% of most. Slowest update of 30: %.2f s; map: %.3f s.\n",
                100.0 * own_ / machines, slowest_s_, map_s_);
  }

 private:
  void ordinary(const learn::MachinePrior& prior, const HiddenMachine& machine,
                const std::vector<learn::CutEvidence>& cuts, Row& row) {
    learn::LobePosterior posterior(prior, rangeFor(machine));
    for (const auto& cut : cuts) {
      slowest_s_ = std::max(slowest_s_, timed([&] { (void)posterior.add(cut).ok(); }));
    }
    map_s_ = std::max(map_s_, timed([&] { (void)stabilityMap(posterior, workOf(machine)); }));
    row.scores.push_back(scoreOf(posterior, machine, 30));
    if (std::getenv("LEARNING_TABLE_VERBOSE") == nullptr) return;
    const LimitScore& s = row.scores.back();
    std::printf("%s, %zu: immersion %.2f, %d teeth, error %.2f, stable %d of %d, removal %.2f, forgotten %d\n",
                row.name, row.scores.size(), machine.model.engagement.radialImmersion, machine.model.tool.teeth,
                s.error, s.stable, s.called, s.removal, posterior.forgotten());
  }

  std::vector<Row> rows_{{"tool and material"}, {"and 5 chosen cuts"},      {"tool, material, 30 ordinary cuts"},
                         {"tap test"},          {"the same 30 cuts later"}, {"tap test and 30 ordinary cuts"}};
  double own_ = 0.0;
  double slowest_s_ = 0.0;
  double map_s_ = 0.0;
};

// 200 cuts of one shop on one machine: what the last updates take.
void printCost() {
  const HiddenMachine machine = hiddenMachine(3);
  OrdinaryShop shop(machine, 3);
  learn::LobePosterior posterior(learn::priorOfTool(machine.model.tool.diameter, machine.material), rangeFor(machine));
  double slowest = 0.0;
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    const auto cut = shop.next();
    const double took = timed([&] { (void)posterior.add(cut).ok(); });
    if (i < 150) continue;
    slowest = std::max(slowest, took);
    sum += took;
  }
  std::printf("Cuts 151 to 200 on one machine: %.2f s an update, the slowest %.2f s.\n", sum / 50.0, slowest);
}

}  // namespace
}  // namespace stillcut::test

int main(int argc, char** argv) {
  const int machines = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto first = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  stillcut::test::Table table;
  for (int i = 0; i < machines; ++i) table.add(first + static_cast<std::uint64_t>(i));
  table.print(machines, first);
  stillcut::test::printCost();
  return 0;
}
