// What the active work-holder makes of Ford's unstable cut on random plants: every mode's frequency within 5 %, its
// damping and stiffness within 30 % of the scenario's. Needs no stop-watch: what it prints is simulated.
//   active_table [PLANTS] [SEED] [fixed]     20 and 1 unless told; fixed: the scenario's lines on every plant, else its
//                                            own modes' and the line that the exact lobes see its chatter on
// Exit code 0: some plants chatter when left alone, every one of them is held, and no other becomes worse.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <random>

#include "app/compose/active_run.h"
#include "core/milling/simulation/scenario.h"
#include "core/milling/stability/exact_lobes.h"

namespace stillcut::app {
namespace {

milling::Scenario scattered(milling::Scenario scenario, std::mt19937_64& random) {
  const auto factor = [&](double share) { return std::uniform_real_distribution<>(1.0 - share, 1.0 + share)(random); };
  for (milling::Mode& mode : scenario.model.modes) {
    mode.frequency = Hertz(mode.frequency.value * factor(0.05));
    mode.damping *= factor(0.3);
    mode.stiffness *= factor(0.3);
  }
  return scenario;
}

// Where the exact lobes see this plant's chatter begin.
std::optional<milling::StabilityLimit> firstCrossing(const milling::Scenario& plant) {
  const auto lobes = milling::ExactLobes::make(plant.model, "plant");
  if (!lobes) return std::nullopt;
  const auto limits = lobes->limits(
      plant.programme.speed, {.maxAxialDepth = Metres(6e-3), .firstOnly = true, .frequencies = true, .hint = {}});
  if (!limits || !limits->hasLimit()) return std::nullopt;
  return limits->crossings.front();
}

// The lines to quieten are modes of the scenario and go with them; and where the exact lobes see the chatter of this
// plant coming, as they would be known of a machine before its cut.
std::vector<Hertz> ownLines(const milling::Scenario& ford, const milling::Scenario& plant) {
  std::vector<Hertz> lines;
  for (const Hertz line : ford.workHolder->quieten) {
    const auto& modes = ford.model.modes;
    const auto nearest = std::ranges::min_element(
        modes, {}, [&](const milling::Mode& m) { return std::abs(m.frequency.value - line.value); });
    lines.push_back(plant.model.modes[static_cast<std::size_t>(nearest - modes.begin())].frequency);
  }
  if (const auto limit = firstCrossing(plant)) lines.push_back(limit->frequency);
  return lines;
}

// On the axis that chatters more.
Attenuation ofChatter(const ActiveResult& result) {
  Attenuation loudest;
  for (const Attenuation& a : result.attenuation) {
    if (a.frequency == result.chatterHz && a.alone > loudest.alone) loudest = a;
  }
  return loudest;
}

int table(int plants, unsigned seed, bool own) {
  const auto ford = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/ford-unstable.toml");
  if (!ford) {
    std::fprintf(stderr, "active_table: %s\n", ford.error().line().c_str());
    return 2;
  }
  std::mt19937_64 random(seed);
  const config::ParamSet defaults;
  int unstable = 0, held = 0, spoiled = 0;
  std::printf(
      "| plant | depth over limit | alone | with control | chatter [Hz] | axis | [dB] | stroke x, y "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (int plant = 1; plant <= plants; ++plant) {
    ActiveOptions options;
    options.params = defaults;
    options.seed = seed + static_cast<unsigned>(plant);
    milling::Scenario scenario = scattered(*ford, random);
    if (own) scenario.workHolder->quieten = ownLines(*ford, scenario);
    const auto result = runActive(scenario, options);
    if (!result) {
      std::fprintf(stderr, "active_table: %s\n", result.error().line().c_str());
      return 2;
    }
    const Attenuation chatter = ofChatter(*result);
    unstable += result->chatterAlone ? 1 : 0;
    held += result->chatterAlone && !result->chatterControlled && chatter.db >= 15.0 ? 1 : 0;
    spoiled += !result->chatterAlone && result->chatterControlled ? 1 : 0;
    const auto limit = firstCrossing(scenario);
    const double depth = scenario.programme.depth.highest(0.0);
    std::printf("| %d | %.2f | %s | %s | %.1f | %s | %.1f | %.0f %%, %.0f %% |\n", plant,
                limit ? depth / limit->depth.value : 0.0, result->chatterAlone ? "chatter" : "stable",
                result->chatterControlled ? "chatter" : "stable", result->chatterHz, chatter.axis.c_str(), chatter.db,
                100.0 * result->axes[0].strokeUsed, 100.0 * result->axes[1].strokeUsed);
  }
  std::printf(
      "\n%d of %d chatter when left alone; %d of them become stable with 15 dB and more on the axis that chatters "
      "more. "
      "Of the others %d become worse.\n",
      unstable, plants, held, spoiled);
  return unstable > 0 && held == unstable && spoiled == 0 ? 0 : 1;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) try {
  const int plants = argc > 1 ? std::atoi(argv[1]) : 20;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1U;
  const bool own = argc <= 3 || std::string_view(argv[3]) != "fixed";
  return stillcut::app::table(plants, seed, own);
} catch (const std::exception& wrong) {
  std::fprintf(stderr, "active_table: %s\n", wrong.what());
  return 1;
}
