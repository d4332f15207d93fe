#include "core/control/fuzzy_params.h"

#include <array>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "core/units/number_text.h"

namespace stillcut::control {
namespace {

using config::ParamDecl;
using config::realParam;

constexpr ParamDecl kCycle =
    realParam("fuzzy.cycle", "Control cycle", "ms", 250.0, 50.0, 2000.0, "Speed and feed are changed once per cycle");
constexpr ParamDecl kRangeTime =
    realParam("fuzzy.range-time", "Time for the whole range", "s", 4.0, 1.0, 60.0,
              "At full output the whole range of an override takes this long (the paper's limit: a second)");
constexpr ParamDecl kCoherenceRef = realParam("fuzzy.coherence-reference", "Coherence reference", "", 0.8, 0.1, 0.95,
                                              "Coherence above which speed and feed fall (gamma_ref)");
constexpr ParamDecl kEnergyRef = realParam("fuzzy.energy-reference", "Energy reference", "", 1.5, 1.05, 20.0,
                                           "Vibration over that of the stable cut above which speed and feed fall");
constexpr ParamDecl kEnergyUp = realParam("fuzzy.energy-limit", "Energy limit", "", 5.0, 1.1, 100.0,
                                          "Vibration over that of the stable cut at which the feed goes to its lowest; "
                                          "at twice that the feed is held");
constexpr ParamDecl kHighest = realParam("fuzzy.highest", "Highest overrides", "%", 100.0, 100.0, 150.0,
                                         "Speed and feed rise no further than this fraction of the programmed values");
constexpr ParamDecl kRest = realParam("fuzzy.rest", "Rest of the speed", "s", 30.0, 0.0, 600.0,
                                      "The speed does not rise for so long after an alarm");
constexpr ParamDecl kLearning = realParam("fuzzy-learning.weight", "Learning weight", "", 0.4, 0.0, 0.8,
                                          "Share of the coherence error that the rules learn (w of eq. 3-32)");
constexpr std::string_view kTunings[] = {"single", "double"};
constexpr ParamDecl kTuning = config::choiceParam("fuzzy-direct.tuning", "Direct tuning", 1, kTunings,
                                                  "By coherence alone (eq. 3-37) or by coherence and energy (3-36)");
constexpr ParamDecl kCoherenceWeight = realParam("fuzzy-direct.coherence-weight", "Coherence weight", "", 0.65, 0.1,
                                                 2.0, "Weight of the coherence error (w_gamma of eq. 3-34)");
constexpr ParamDecl kEnergyWeight = realParam("fuzzy-direct.energy-weight", "Energy weight", "", 1.25, 0.1, 3.0,
                                              "Weight of the energy error (w_E of eq. 3-35)");
// Their ranges keep them in order, whatever is chosen.
constexpr ParamDecl kSmall = realParam("fuzzy.set-small", "Peak of small", "", kUniformCentres[0], 0.05, 0.35,
                                       "Where the coherence error is called small (NS, PS), of its whole range");
constexpr ParamDecl kMedium = realParam("fuzzy.set-medium", "Peak of medium", "", kUniformCentres[1], 0.36, 0.64,
                                        "Where the coherence error is called medium (NM, PM)");
constexpr ParamDecl kBig = realParam("fuzzy.set-big", "Peak of big", "", kUniformCentres[2], 0.65, 0.95,
                                     "Where the coherence error is called big (NB, PB)");
constexpr const ParamDecl* kCentres[] = {&kSmall, &kMedium, &kBig};
constexpr const ParamDecl* kParams[] = {&kCycle,    &kRangeTime, &kCoherenceRef, &kEnergyRef,
                                        &kEnergyUp, &kHighest,   &kRest};
constexpr const ParamDecl* kOwnParams[] = {&kLearning, &kTuning, &kCoherenceWeight,
                                           &kEnergyWeight};  // of the tuned ones;

constexpr std::size_t kCells = std::size_t{kCoherenceSets} * kCoherenceSets;

// "fuzzy.speed-rule-nb-ps": the rule for an error NB and a change PS.
struct CellKey {
  std::array<char, 24> text{};
  std::size_t length = 0;
  constexpr void add(std::string_view part) {
    for (const char c : part) text[length++] = c;
  }
  constexpr std::string_view view() const { return {text.data(), length}; }
};

constexpr std::array<std::string_view, kCoherenceSets> kSetWords{"nx", "nb", "nm", "ns", "ze", "ps", "pm", "pb", "px"};

constexpr std::array<CellKey, kCells> cellKeys(std::string_view stem) {
  std::array<CellKey, kCells> keys{};
  for (std::size_t k = 0; k < kCells; ++k) {
    keys[k].add(stem);
    keys[k].add(kSetWords[k / kCoherenceSets]);
    keys[k].add("-");
    keys[k].add(kSetWords[k % kCoherenceSets]);
  }
  return keys;
}

constexpr auto kSpeedKeys = cellKeys("fuzzy.speed-rule-");
constexpr auto kFeedKeys = cellKeys("fuzzy.feed-rule-");

std::vector<ParamDecl> makeCells() {
  std::vector<ParamDecl> cells;
  cells.reserve(2 * kCells);
  for (std::size_t k = 0; k < kCells; ++k) {
    cells.push_back(realParam(kSpeedKeys[k].view(), "Speed rule", "",
                              kSpeedRules[k / kCoherenceSets][k % kCoherenceSets], 1.0, 9.0,
                              "What this rule asks of the speed: 5 nothing, 1 down and 9 up at full (figure 3.7)"));
  }
  for (std::size_t k = 0; k < kCells; ++k) {
    cells.push_back(realParam(kFeedKeys[k].view(), "Feed rule", "", kFeedRules[k / kCoherenceSets][k % kCoherenceSets],
                              1.0, 9.0,
                              "What this rule asks of the feed: 5 nothing, 1 down and 9 up at full (figure 3.8)"));
  }
  return cells;
}

const std::vector<ParamDecl>& cells() {
  static const std::vector<ParamDecl> all = makeCells();
  return all;
}

}  // namespace

config::ParamTable fuzzyRuleParams() {
  static const std::vector<const ParamDecl*> table = [] {
    std::vector<const ParamDecl*> pointers;
    for (const ParamDecl& cell : cells()) pointers.push_back(&cell);
    return pointers;
  }();
  return table;
}

config::ParamTable fuzzyCentreParams() {
  return kCentres;
}

config::ParamTable fuzzyParams() {
  static const std::vector<const ParamDecl*> table = [] {
    std::vector<const ParamDecl*> pointers(std::begin(kParams), std::end(kParams));
    for (const config::ParamTable more : {fuzzyCentreParams(), fuzzyRuleParams(), config::ParamTable(kOwnParams)}) {
      pointers.insert(pointers.end(), more.begin(), more.end());
    }
    return pointers;
  }();
  return table;
}

FuzzyOptions fuzzyOptions(const config::ParamSet& params) {
  FuzzyOptions o;
  o.cycle = params.real(kCycle) / 1000.0;
  o.rangeTime = params.real(kRangeTime);
  o.coherenceRef = params.real(kCoherenceRef);
  o.energyRef = params.real(kEnergyRef);
  o.energyUp = params.real(kEnergyUp);
  o.highest = params.real(kHighest) / 100.0;
  o.rest = params.real(kRest);
  o.learning = params.real(kLearning);
  o.doubleTuning = params.choice(kTuning) == 1;
  o.coherenceWeight = params.real(kCoherenceWeight);
  o.energyWeight = params.real(kEnergyWeight);
  o.centres = {params.real(kSmall), params.real(kMedium), params.real(kBig)};
  for (std::size_t k = 0; k < kCells; ++k) {
    o.speedRules[k / kCoherenceSets][k % kCoherenceSets] = params.real(cells()[k]);
    o.feedRules[k / kCoherenceSets][k % kCoherenceSets] = params.real(cells()[kCells + k]);
  }
  return o;
}

bool usableTogether(const FuzzyOptions& options) {
  return options.energyUp > options.energyRef && !risingRule(options.speedRules) && !risingRule(options.feedRules);
}

Status checkFuzzyOptions(const FuzzyOptions& options) {
  if (!(options.energyUp > options.energyRef)) {
    return Error{"fuzzy.energy-limit", message("must be above fuzzy.energy-reference")};
  }
  for (const auto& [table, keys] : {std::pair(&options.speedRules, &kSpeedKeys), {&options.feedRules, &kFeedKeys}}) {
    const auto rising = risingRule(*table);
    if (!rising) continue;
    const auto key = [&keys = keys](std::size_t row, std::size_t column) {
      return std::string((*keys)[row * kCoherenceSets + column].view());
    };
    const auto rule = [&table = table](std::size_t row, std::size_t column) {
      return config::numberText((*table)[row][column]);
    };
    return Error{key(rising->row, rising->column),
                 message("%1 is above %2 of %3", rule(rising->row, rising->column),
                         rule(rising->overRow, rising->overColumn), key(rising->overRow, rising->overColumn)),
                 message("rules must fall as coherence rises")};
  }
  return Done{};
}

}  // namespace stillcut::control
