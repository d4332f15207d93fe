// Families of simulated cuts, each with a question of its own; several tools and seeds each. Depths are multiples of
// the exact stability limit, so that what a cut does is known beforehand.
// Thread: one; not the sample path.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tests/support/known_cuts/known_cut.h"

namespace stillcut::bench {

struct CutFamily {
  std::string_view name;
  std::string_view question;
  std::vector<SimulationOrder> (*make)(int seeds);
};

std::span<const CutFamily> cutFamilies();
// One cut of a family of so many seeds; throws where there is none of that name.
SimulationOrder orderOf(std::string_view family, int seeds, std::string_view name);
// One of them.
std::vector<SimulationOrder> flipOdd(int seeds);
std::vector<SimulationOrder> flipEven(int seeds);
std::vector<SimulationOrder> flipStable(int seeds);
std::vector<SimulationOrder> slowStable(int seeds);
std::vector<SimulationOrder> slowPassage(int seeds);
std::vector<SimulationOrder> quickRise(int seeds);
std::vector<SimulationOrder> strongStable(int seeds);
std::vector<SimulationOrder> speedDrifts(int seeds);
std::vector<SimulationOrder> intoTheSlot(int seeds);
std::vector<SimulationOrder> cornersAndSteps(int seeds);

}  // namespace stillcut::bench
