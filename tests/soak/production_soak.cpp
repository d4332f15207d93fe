// soak_production [HOURS] [SEED]: HOURS (24 unless told) of simulated production, as fast as this machine can: stable
// parts, each with a tool, a machine, speeds, depths, entries and corners of its own (tests/support/production), and
// after every ninth of them one that chatters, with Auto granted throughout. Prints each alarm in a stable part with
// its reason, then alarms and moves in stable parts, chatter that was not ended, and memory at a tenth and at the end.
// Exit code 0: in 24 h at most one stable part with an alarm and one with a move, every chattering part ended quiet,
// and memory flat (5 % or 8 MB, the larger).

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/compose/scenario_rig.h"
#include "core/evaluate/simulation_report.h"
#include "tests/soak/resident.h"
#include "tests/support/production/drawn_part.h"

namespace stillcut::app {
namespace {

struct Tally {
  int stableParts = 0, alarmed = 0, moved = 0;
  int chatterParts = 0, notQuiet = 0;
  double hours = 0.0;
};

Result<milling::Scenario> scenario(const char* name) {
  return milling::loadScenario(std::string(STILLCUT_SOURCE_DIR "/resources/scenarios/") + name + ".toml");
}

Status runPart(milling::Scenario part, std::uint64_t seed, bool stable, Tally& tally) {
  part.grantsAuto = true;
  auto built = buildScenarioRig(part, {.methods = {}, .params = {}, .seed = seed});
  if (!built) return built.error();
  evaluate::SimulationHistory history;
  built->rig->send({OperatorAction::GrantBySimulation, Authority::Auto});
  bool was = false;
  built->rig->runToEnd([&](const StepInput& input, const StepOutput& output) {
    history.observe(input, output, built->source->plant());
    const Verdict& v = output.verdicts[static_cast<std::size_t>(output.inCharge)];
    if (stable && v.alarming() && !was) {
      std::printf("%s, %.2f s: %s, %.0f Hz at %.0f rpm\n", part.name.c_str(), sinceEpoch(v.time).value,
                  sentence(v.reason).c_str(), v.frequency.value, toRpm(v.spindle).value);
      std::fflush(stdout);  // a day of parts is watched while it runs
    }
    was = v.alarming();
  });
  bool alarm = false;
  bool move = false;
  bool lastChatters = false;
  for (const evaluate::SimulationHistory::Point& point : history.points()) {
    alarm |= point.alarming;
    move |= point.commandMoves;
    if (point.cutting) lastChatters = point.chattering;
  }
  if (stable) {
    ++tally.stableParts;
    tally.alarmed += alarm ? 1 : 0;
    tally.moved += move ? 1 : 0;
  } else {
    ++tally.chatterParts;
    tally.notQuiet += lastChatters ? 1 : 0;
  }
  tally.hours += history.points().empty() ? 0.0 : history.points().back().t / 3600.0;
  return Done{};
}

int soak(double hours, std::uint64_t seed) {
  const auto machine = scenario("production-stable");
  const auto chattering = scenario("demo");
  if (!machine || !chattering) return 2;
  Tally tally;
  double early = 0.0;
  for (std::uint64_t part = 0; tally.hours < hours; ++part) {
    const bool calm = part % 10 != 9;
    const auto drawn = calm ? test::drawnPart(*machine, seed + part) : *chattering;
    const Status ran = drawn ? runPart(*drawn, seed + part, calm, tally) : Status(drawn.error());
    if (!ran) {
      std::fprintf(stderr, "soak_production: %s\n", ran.error().line().c_str());
      return 2;
    }
    if (early == 0.0 && tally.hours >= 0.1 * hours) early = testing::residentMegabytes();
  }
  const double late = testing::residentMegabytes();
  std::printf(
      "%.2f h of production: %d stable parts, %d with an alarm, %d with a move; %d that chatter, %d not ended\n",
      tally.hours, tally.stableParts, tally.alarmed, tally.moved, tally.chatterParts, tally.notQuiet);
  std::printf("memory: %.1f MB at a tenth, %.1f MB at the end\n", early, late);
  const auto allowed = static_cast<int>(std::ceil(tally.hours / 24.0));
  const bool rare = tally.alarmed <= allowed && tally.moved <= allowed;
  return rare && tally.notQuiet == 0 && testing::flat(early, late) ? 0 : 1;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  const double hours = argc > 1 ? std::atof(argv[1]) : 24.0;
  const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  if (!(hours > 0.0 && hours <= 10000.0)) {
    std::fprintf(stderr, "soak_production: HOURS above 0\n");
    return 2;
  }
  return stillcut::app::soak(hours, seed);
}
