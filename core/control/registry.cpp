#include "core/control/registry.h"

#include <string>
#include <vector>

#include "core/config/nearest_word.h"
#include "core/control/extremum.h"
#include "core/control/fuzzy.h"
#include "core/control/lobe_center.h"
#include "core/control/monitor.h"
#include "core/control/quarter_phase.h"
#include "core/control/stable_pocket.h"

namespace stillcut::control {
namespace {

template <class T>
std::unique_ptr<Strategy> make() {
  return std::make_unique<T>();
}

std::string allIds() {
  std::string all;
  for (const StrategyEntry& entry : strategyTable()) all += (all.empty() ? "" : ", ") + std::string(entry.id);
  return all;
}

}  // namespace

std::span<const StrategyEntry> strategyTable() {
  static const std::vector<StrategyEntry> table{
      {"monitor", &make<Monitor>, {}},
      {"stable-pocket", &make<StablePocket>, stablePocketParams()},
      {"lobe-center", &make<LobeCenter>, lobeCenterParams()},
      {"extremum-paper", &make<ExtremumPaper>, extremumParams()},
      {"extremum-seek", &make<ExtremumSeek>, extremumParams()},
      {"quarter-phase", &make<QuarterPhase>, quarterPhaseParams()},
      {"fuzzy", &make<Fuzzy>, fuzzyParams()},
      {"fuzzy-learning", &make<FuzzyLearning>, fuzzyParams()},
      {"fuzzy-direct", &make<FuzzyDirect>, fuzzyParams()},
  };
  return table;
}

Result<std::unique_ptr<Strategy>> makeStrategy(std::string_view id) {
  for (const StrategyEntry& entry : strategyTable()) {
    if (entry.id == id) return entry.make();
  }
  std::vector<std::string_view> ids;
  for (const StrategyEntry& entry : strategyTable()) ids.push_back(entry.id);
  const Message hint = config::didYouMean(id, ids);
  return Error{message("strategy"), message("unknown id '%1'", id),
               hint.empty() ? message("known: %1", allIds()) : hint};
}

}  // namespace stillcut::control
