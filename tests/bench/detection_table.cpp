// How every detector does on the reference cuts and on families of simulated cuts with known truth, default profile,
// x and y alone and together, told speed right and up to 3 % off. Prints Markdown: a line per family and detector.
//   detection_table [--seeds N] [--family TEXT] [--detector ID] [--each]
// --seeds: tools are scattered so often, 2 unless told. --each: also a line per run that is not good.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "core/detect/registry.h"
#include "tests/support/known_cuts/cut_families.h"
#include "tests/support/known_cuts/growth.h"
#include "tests/support/known_cuts/score.h"
#include "tests/support/known_cuts/sensor_kinds.h"

namespace stillcut::bench {
namespace {

struct Options {
  int seeds = 2;
  std::string family, detector;
  bool each = false;
};

struct Sum {
  int runs = 0, good = 0, early = 0, late = 0, missed = 0, falseAlarms = 0, frequencyOff = 0, kindWrong = 0,
      clearLate = 0;
  std::vector<double> after20, frequency, clear;

  void add(const Score& s) {
    ++runs;
    good += s.good();
    early += s.early;
    late += s.late;
    missed += s.missed;
    falseAlarms += s.falseAlarm;
    frequencyOff += s.frequencyOff;
    kindWrong += s.kindWrong;
    clearLate += s.clearLate;
    if (std::isfinite(s.after20)) after20.push_back(1e3 * s.after20);
    if (std::isfinite(s.frequencyError)) frequency.push_back(100.0 * std::abs(s.frequencyError));
    if (std::isfinite(s.clearDelay)) clear.push_back(1e3 * s.clearDelay);
  }
};

std::string spread(std::vector<double> values) {
  if (values.empty()) return "";
  std::sort(values.begin(), values.end());
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.0f / %.0f", values[values.size() / 2], values.back());
  return text.data();
}

std::string worst(const std::vector<double>& values) {
  if (values.empty()) return "";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", *std::max_element(values.begin(), values.end()));
  return text.data();
}

void printHead() {
  std::printf(
      "| family | detector | good | early | late | missed | false | delay to 20 %%, median / worst [ms] | "
      "frequency off | worst error [%%] | kind wrong | clear late | clear, median / worst [ms] |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
}

void print(const std::string& family, const std::string& detector, const Sum& s) {
  std::printf("| %s | %s | %d of %d | %d | %d | %d | %d | %s | %d | %s | %d | %d | %s |\n", family.c_str(),
              detector.c_str(), s.good, s.runs, s.early, s.late, s.missed, s.falseAlarms, spread(s.after20).c_str(),
              s.frequencyOff, worst(s.frequency).c_str(), s.kindWrong, s.clearLate, spread(s.clear).c_str());
}

void printRun(const KnownCut& cut, const Trial& trial, const Score& s) {
  std::printf(
      "  %-34s %-12s %-4s %+.0f %%  alarm %.3f after20 %+.0f ms after1 %+.0f ms  f %+.2f %% of %.1f Hz  %s"
      "  clear %.0f ms %s%s%s%s%s%s\n",
      (cut.family + " " + cut.name).c_str(), trial.detector.c_str(),
      trial.channels.empty()   ? "both"
      : trial.channels[0] == 0 ? "x"
                               : "y",
      100.0 * trial.speedError, s.alarm, 1e3 * s.after20, 1e3 * s.after1, 100.0 * s.frequencyError, cut.chatterHz,
      std::string(name(s.kind)).c_str(), 1e3 * s.clearDelay, s.early ? " early" : "", s.late ? " late" : "",
      s.missed ? " missed" : "", s.falseAlarm ? " false" : "", s.frequencyOff ? " frequency" : "",
      s.clearLate ? " clear" : "");
}

class Table {
 public:
  explicit Table(Options options) : options_(std::move(options)) {}

  void run(const KnownCut& cut) {
    if (options_.each) {
      std::printf("%s %s: Z%d %.0f rpm, 1 %% %.3f s, 20 %% %.3f s, %.1f Hz, %s, last above %.3f s\n",
                  cut.family.c_str(), cut.name.c_str(), cut.teeth, cut.rpm, cut.at1, cut.at20, cut.chatterHz,
                  std::string(name(cut.kind)).c_str(), cut.lastAbove);
    }
    if (cut.rule != AlarmRule::Silent && !(cut.at20 > 0.0)) {
      std::printf("%s %s: the truth knows no chatter; left out\n", cut.family.c_str(), cut.name.c_str());
      return;
    }
    if (!cut.stable) {
      std::printf("%s %s: chatters below its limit; left out\n", cut.family.c_str(), cut.name.c_str());
      return;
    }
    for (const detect::DetectorRow& row : detect::detectorTable()) {
      if (!options_.detector.empty() && row.id != options_.detector) continue;
      for (const std::vector<int>& channels : {std::vector<int>{}, {0}, {1}}) {
        const bool single = cut.recording.channels.size() == 1;
        if (!channels.empty() && (single || row.id == "coherence")) continue;
        if (single && row.id == "coherence") continue;  // invalid, as it must be
        for (const double error : cut.toldErrors) {
          const Trial trial{std::string(row.id), channels, error};
          const Score s = score(cut, trial);
          sums_[cut.family][trial.detector].add(s);
          if (options_.each && !s.good()) printRun(cut, trial, s);
        }
      }
    }
  }
  // A family's lines, as soon as it is done.
  void flush() {
    for (const auto& [family, detectors] : sums_) {
      for (const auto& [detector, sum] : detectors) print(family, detector, sum);
    }
    sums_.clear();
    std::fflush(stdout);
  }

 private:
  Options options_;
  std::map<std::string, std::map<std::string, Sum>> sums_;
};

void tabulate(const Options& options) {
  Table table(options);
  printHead();
  const auto wanted = [&](std::string_view family) { return family.find(options.family) != std::string_view::npos; };
  if (wanted("shared")) {
    for (const auto& [name, rule] : {std::pair{"c1_stable", AlarmRule::Silent},
                                     {"c2_hopf", AlarmRule::Sharp},
                                     {"c6_air_entry_chatter_exit", AlarmRule::Sharp},
                                     {"c7b_xu_800rpm", AlarmRule::Slow}}) {
      if (!haveSharedCut(name)) continue;
      KnownCut cut = sharedCut(name, rule);
      cut.family = cut.name;
      table.run(cut);
      table.flush();
    }
  }
  for (const CutFamily& family : cutFamilies()) {
    if (!wanted(family.name)) continue;
    for (const SimulationOrder& order : family.make(options.seeds)) table.run(simulate(order));
    table.flush();
  }
  for (const CutFamily& family : sensorKindFamilies()) {
    if (!wanted(family.name)) continue;
    for (const SimulationOrder& order : family.make(options.seeds)) table.run(simulate(order));
    table.flush();
  }
  for (const double constant : {0.005, 0.010, 0.020, 0.050}) {
    if (!wanted("growth")) break;
    for (int seed = 1; seed <= 8 * options.seeds; ++seed) table.run(growingCut(constant, static_cast<unsigned>(seed)));
    table.flush();
  }
  if (wanted("no growth")) {
    for (int seed = 1; seed <= options.seeds; ++seed) table.run(minuteWithoutGrowth(static_cast<unsigned>(seed)));
    table.flush();
  }
}

}  // namespace
}  // namespace stillcut::bench

int main(int argc, char** argv) {
  stillcut::bench::Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool value = i + 1 < argc;
    if (word == "--each")
      options.each = true;
    else if (word == "--seeds" && value)
      options.seeds = std::max(1, std::atoi(argv[++i]));
    else if (word == "--family" && value)
      options.family = argv[++i];
    else if (word == "--detector" && value)
      options.detector = argv[++i];
    else {
      std::fprintf(stderr, "detection_table [--seeds N] [--family TEXT] [--detector ID] [--each]\n");
      return 2;
    }
  }
  stillcut::bench::tabulate(options);
}
