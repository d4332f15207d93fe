// What the active work-holder makes of Ford's unstable cut on random plants: every mode's frequency within 5 %, its
// damping and stiffness within 30 % of the scenario's. Needs no stop-watch: what it prints is simulated.
//   active_table [PLANTS] [SEED]     20 and 1 unless told

#include <cstdio>
#include <cstdlib>
#include <random>

#include "app/compose/active_run.h"
#include "core/milling/scenario.h"

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

// On the axis that chatters more.
Attenuation ofChatter(const ActiveResult& result) {
  Attenuation loudest;
  for (const Attenuation& a : result.attenuation) {
    if (a.frequency == result.chatterHz && a.alone > loudest.alone) loudest = a;
  }
  return loudest;
}

int table(int plants, unsigned seed) {
  const auto ford = milling::loadScenario(STILLCUT_SOURCE_DIR "/resources/scenarios/ford-unstable.toml");
  if (!ford) {
    std::fprintf(stderr, "active_table: %s\n", ford.error().line().c_str());
    return 2;
  }
  std::mt19937_64 random(seed);
  const config::ParamSet defaults;
  int unstable = 0;
  int held = 0;
  std::printf(
      "| plant | alone | with control | chatter [Hz] | axis | [dB] | stroke x, y "
      "|\n|---|---|---|---|---|---|---|\n");
  for (int plant = 1; plant <= plants; ++plant) {
    ActiveOptions options;
    options.controller = active::fxlmsOptions(defaults);
    options.path = active::pathRequest(defaults);
    options.seed = seed + static_cast<unsigned>(plant);
    const auto result = runActive(scattered(*ford, random), options);
    if (!result) {
      std::fprintf(stderr, "active_table: %s\n", result.error().line().c_str());
      return 2;
    }
    const Attenuation chatter = ofChatter(*result);
    unstable += result->chatterAlone ? 1 : 0;
    held += result->chatterAlone && !result->chatterControlled && chatter.db >= 15.0 ? 1 : 0;
    std::printf("| %d | %s | %s | %.1f | %s | %.1f | %.0f %%, %.0f %% |\n", plant,
                result->chatterAlone ? "chatter" : "stable", result->chatterControlled ? "chatter" : "stable",
                result->chatterHz, chatter.axis.c_str(), chatter.db, 100.0 * result->axes[0].strokeUsed,
                100.0 * result->axes[1].strokeUsed);
  }
  std::printf(
      "\n%d of %d chatter when left alone; %d of them become stable with 15 dB and more on the axis that chatters "
      "more\n",
      unstable, plants, held);
  return 0;
}

}  // namespace
}  // namespace stillcut::app

int main(int argc, char** argv) {
  const int plants = argc > 1 ? std::atoi(argv[1]) : 20;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1U;
  return stillcut::app::table(plants, seed);
}
