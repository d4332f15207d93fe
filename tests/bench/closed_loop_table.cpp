// What control makes of the scenarios and of random tools, one line per run:
//   closed_loop_table [--strategies a,b] [--detector ID] [--no-scenarios] [--scenario NAME|FILE] [--tools N] [--first
//   K]
//                     [--verdicts real|ideal|both] [--modes-known] [--delays] [--trace]
// Scenarios run under every strategy with the program's own verdicts; random tools under the named ones (the default
// strategy unless told), with the program's verdicts and with the simulation's truth in their place, so that strategies
// can be judged on their own.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/compose/known_lobes.h"
#include "core/control/registry.h"
#include "tests/support/closed_loop/loop_run.h"
#include "tests/support/closed_loop/random_tool.h"

namespace stillcut::test {
namespace {

struct TableOptions {
  std::vector<std::string> strategies;
  std::string scenario, detector;
  bool noScenarios = false, modesKnown = false, delays = false, trace = false;
  std::uint64_t tools = 0, first = 1;
  std::string verdicts = "both";
};

struct Tally {
  int runs = 0, reached = 0, fewChanges = 0;
};
constexpr int kFewChanges = 3;

void head() {
  std::printf("%-22s %-15s %-5s %-16s %-16s %7s %7s %7s %8s %6s %6s %7s %8s %6s %4s\n", "cut", "strategy", "by",
              "outcome", "expected", "alarm", "command", "quiet", "marked", "peak", "final", "rpm", "mm/min", "mrr",
              "n");
}

void row(const evaluate::SimulationReport& r, const std::string& name, const char* by, std::string_view expected,
         const char* lobes = "") {
  std::printf("%-22s %-15s %-5s %-16s %-16s %7.3f %7.3f %7.3f %8.2f %6.2f %6.2f %7.0f %8.0f %6.2f %4d %s\n",
              name.c_str(), r.strategy.c_str(), by, r.outcome.c_str(), std::string(expected).c_str(), r.alarmDelay,
              r.commandDelay, r.quietDelay, r.marked, r.peakRatio, r.finalRatio, r.finalSpeed, r.finalFeed, r.mrrRatio,
              r.speedChanges, lobes);
  std::fflush(stdout);
}

void count(Tally& tally, const evaluate::SimulationReport& r, std::string_view expected, bool sound = true) {
  ++tally.runs;
  if (r.outcome != expected || !sound) return;
  ++tally.reached;
  const int back = expected == name(milling::Expectation::NoStableSpeed) ? 1 : 0;  // to the programmed speed
  tally.fewChanges += r.speedChanges <= kFewChanges + back ? 1 : 0;
}

void summary(const char* what, const std::map<std::string, Tally>& tallies) {
  for (const auto& [strategy, t] : tallies) {
    std::printf("%s: %s reached %d of %d as expected, %d of them within %d changes\n", what, strategy.c_str(),
                t.reached, t.runs, t.fewChanges, kFewChanges);
  }
}

std::vector<std::string> bySpeedStrategies() {
  std::vector<std::string> ids;
  for (const control::StrategyEntry& entry : control::strategyTable()) ids.emplace_back(entry.id);
  return ids;
}

// What went on, twenty times a second and whenever the request's reason changes.
void trace(const milling::Scenario& scenario, const LoopOptions& options) {
  LoopRun run(scenario, options);
  double next = 0.0;
  ReasonCode said = ReasonCode::None;
  while (run.advance()) {
    const StepOutput& out = run.last().output;
    const double t = run.plant().time().value;
    if (t < next && out.request.reason.code == said) continue;
    if (t >= next) next = t + 0.05;
    said = out.request.reason.code;
    const Verdict& v = out.verdicts[static_cast<std::size_t>(out.inCharge)];
    const milling::ChatterTruth& truth = run.plant().truth();
    std::printf("%7.3f  %-7s %-6s %s %7.1f Hz er %.3f | true %c %.3f, %8.2f m/s2 | %6.0f rpm %6.0f mm/min | %s\n", t,
                std::string(name(v.state)).c_str(), std::string(name(v.phase)).c_str(), v.valid ? "ok" : "--",
                v.frequency.value, v.severity.value, truth.chattering() ? 'C' : '-', truth.chatterRatio(),
                truth.vibration(), run.input().machine.actualSpeed.value, toMmPerMin(run.input().machine.actualFeed),
                sentence(v.valid ? out.request.reason : v.reason).c_str());
  }
}

// What the lobes allow, beside what is heard.
void describe(const RandomTool& tool) {
  const milling::CutModel& m = tool.scenario.model;
  std::printf("%s: %d teeth, %.0f rpm, immersion %.2f", tool.scenario.name.c_str(), m.tool.teeth,
              tool.scenario.programme.speed.value, m.engagement.radialImmersion);
  for (const milling::Mode& mode : m.modes) {
    std::printf(", %c %.0f Hz %.3f %.1e N/m", mode.direction[0] > 0.5 ? 'x' : 'y', mode.frequency.value, mode.damping,
                mode.stiffness);
  }
  std::printf("; stable");
  for (const StableSpeeds::Range& r : tool.known.ranges) std::printf(" %.0f..%.0f", r.from.value, r.to.value);
  std::printf("\n");
}

void scenarios(const TableOptions& options) {
  std::vector<std::filesystem::path> files;
  for (const auto& f : std::filesystem::directory_iterator(STILLCUT_SOURCE_DIR "/resources/scenarios")) {
    if (f.path().extension() == ".toml" && !options.scenario.ends_with(".toml") &&
        (options.scenario.empty() || f.path().stem() == options.scenario)) {
      files.push_back(f.path());
    }
  }
  if (options.scenario.ends_with(".toml")) files.emplace_back(options.scenario);
  std::sort(files.begin(), files.end());
  std::map<std::string, Tally> tallies;
  for (const auto& file : files) {
    const auto scenario = milling::loadScenario(file.string());
    if (!scenario) throw std::runtime_error(scenario.error().line());
    const evaluate::SimulationHistory alone = runAlone(*scenario);
    for (const std::string& strategy : options.strategies.empty() ? bySpeedStrategies() : options.strategies) {
      LoopOptions loop;
      loop.strategy = strategy;
      loop.detector = options.detector;
      if (options.modesKnown) loop.stableSpeeds = app::stableSpeeds(*scenario);
      for (const bool ideal : {false, true}) {
        if (options.verdicts == (ideal ? "real" : "ideal")) continue;
        loop.ideal = ideal;
        if (options.trace) trace(*scenario, loop);
        const evaluate::SimulationReport r = runLoop(*scenario, loop, alone);
        row(r, scenario->name, ideal ? "truth" : "own", name(scenario->expect));
        count(tallies[strategy + (ideal ? " by truth" : "")], r, name(scenario->expect));
      }
    }
  }
  summary("scenarios", tallies);
}

void randomTools(const TableOptions& options) {
  std::map<std::string, Tally> stable, narrow, none;
  int quiet = 0;
  const std::vector<std::string> strategies =
      options.strategies.empty() ? std::vector<std::string>{"stable-pocket"} : options.strategies;
  for (std::uint64_t number = options.first; number < options.first + options.tools; ++number) {
    const RandomTool tool = randomTool(number);
    if (options.trace) describe(tool);
    const evaluate::SimulationHistory alone = runAlone(tool.scenario);
    const auto& points = alone.points();
    const bool chatters = std::any_of(points.begin(), points.end(), [](const auto& p) { return p.chattering; });
    quiet += chatters ? 0 : 1;
    const std::string label = tool.scenario.name + " " + std::to_string(tool.timesLimit).substr(0, 4) + "x " +
                              std::to_string(tool.waves).substr(0, 3);
    for (const std::string& strategy : strategies) {
      for (const bool ideal : {false, true}) {
        if (options.verdicts == (ideal ? "real" : "ideal")) continue;
        LoopOptions loop;
        loop.strategy = strategy;
        loop.detector = options.detector;
        loop.ideal = ideal;
        if (options.modesKnown) loop.stableSpeeds = tool.known;
        if (options.trace) trace(tool.scenario, loop);
        const evaluate::SimulationReport r = runLoop(tool.scenario, loop, alone);
        const std::string_view expected = name(tool.scenario.expect);
        if (!chatters) continue;  // grows too slowly for the time there is, or locks where the truth sees nothing
        const bool reachable = tool.scenario.expect == milling::Expectation::Stable;
        const bool sound = stableByLobes(tool, Rpm(r.finalSpeed));
        row(r, label, ideal ? "truth" : "own", expected, sound ? "lobes: stable" : "lobes: unstable");
        auto& tally = !reachable ? none : tool.widest < kNarrow ? narrow : stable;
        count(tally[strategy + (ideal ? " by truth" : "")], r, expected, sound || !reachable);
      }
    }
  }
  summary("random tools with a stable speed in reach", stable);
  summary("random tools with nothing but a pocket narrower than 2 %", narrow);
  summary("random tools without one", none);
  std::printf("random tools that do not chatter by truth when left alone, not counted: %d of %d\n", quiet,
              static_cast<int>(options.tools));
}

// van Dijk's machine has 40 to 70 ms between command and drive; a strategy has to bear 0 to 120.
void delays(const TableOptions& options) {
  for (const char* file : {"demo", "van-dijk-ramp"}) {
    auto scenario = milling::loadScenario(std::string(STILLCUT_SOURCE_DIR "/resources/scenarios/") + file + ".toml");
    if (!scenario) throw std::runtime_error(scenario.error().line());
    scenario->programme.duration = std::min(scenario->programme.duration, Seconds(9.0));
    const evaluate::SimulationHistory alone = runAlone(*scenario);
    for (const std::string& strategy : options.strategies.empty() ? bySpeedStrategies() : options.strategies) {
      for (int ms = 0; ms <= 120; ms += 20) {
        scenario->overrides.shortestDelay = scenario->overrides.longestDelay = Seconds(ms / 1000.0);
        LoopOptions loop;
        loop.strategy = strategy;
        row(runLoop(*scenario, loop, alone), scenario->name + " " + std::to_string(ms) + " ms", "own",
            name(scenario->expect));
      }
    }
  }
}

int table(int argc, char** argv) {
  TableOptions options;
  CLI::App app{"What control makes of the scenarios and of random tools"};
  app.add_option("--strategies", options.strategies)->delimiter(',');
  app.add_option("--scenario", options.scenario);
  app.add_option("--detector", options.detector);
  app.add_flag("--no-scenarios", options.noScenarios);
  app.add_flag("--modes-known", options.modesKnown);
  app.add_flag("--delays", options.delays);
  app.add_flag("--trace", options.trace);
  app.add_option("--tools", options.tools);
  app.add_option("--first", options.first);
  app.add_option("--verdicts", options.verdicts)->check(CLI::IsMember({"real", "ideal", "both"}));
  CLI11_PARSE(app, argc, argv);
  head();
  if (options.delays) delays(options);
  if (!options.noScenarios) scenarios(options);
  if (options.tools > 0) randomTools(options);
  return 0;
}

}  // namespace
}  // namespace stillcut::test

int main(int argc, char** argv) {
  try {
    return stillcut::test::table(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "closed_loop_table: %s\n", e.what());
    return 1;
  }
}
