#include "tests/support/hidden_machines/learning_trial.h"

#include <algorithm>
#include <cmath>

#include "core/learn/next_cut.h"

namespace stillcut::test {

learn::MapRequest workOf(const HiddenMachine& machine) {
  learn::MapRequest request;
  request.engagement = machine.model.engagement;
  request.teeth = machine.model.tool.teeth;
  request.lowest = machine.lowest;
  request.highest = machine.highest;
  request.deepest = machine.deepest;
  return request;
}

learn::LearnRange rangeFor(const HiddenMachine& machine) {
  return {machine.lowest * 0.95, machine.highest * 1.05, machine.deepest};
}

LimitScore scoreOf(learn::LobePosterior& posterior, const HiddenMachine& machine, int cuts, int speeds) {
  learn::MapRequest request = workOf(machine);
  request.speeds = speeds;
  const learn::LimitQuantiles learned = limitQuantiles(posterior, request, 0.1);
  const milling::CutModel model = machine.after(cuts);
  LimitScore score;
  std::vector<double> errors;
  double most = 0.0;
  for (std::size_t i = 0; i < learned.speeds.size(); ++i) {
    const double depth = trueLimit(model, learned.speeds[i], machine.deepest).depth;
    most = std::max(most, depth * learned.speeds[i].value);
    // Where neither knows a limit there is nothing to be right about.
    const double deep = 0.97 * machine.deepest.value;
    if (learned.median[i].value < deep || depth < deep) {
      errors.push_back(std::abs(std::log(learned.median[i].value / depth)));
    }
    if (learned.atRisk[i].value >= deep) continue;
    ++score.called;
    score.stable += learned.atRisk[i].value <= depth ? 1 : 0;
  }
  if (!errors.empty()) {
    std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2));
    score.error = errors[errors.size() / 2];
  }
  request.speeds = 160;
  const learn::LearnedAdvice advice = learnedAdvice(posterior, request, 0.1);
  const bool holds = trueLimit(model, advice.speed, machine.deepest).depth >= advice.depth.value;
  score.removal = holds ? advice.removal / most : 0.0;
  return score;
}

int chooseCuts(learn::LobePosterior& posterior, const HiddenMachine& machine, int count, std::uint64_t seed) {
  learn::Random random(seed);
  learn::TrialLimits limits;
  limits.engagement = machine.model.engagement;
  limits.teeth = machine.model.tool.teeth;
  limits.lowest = machine.lowest;
  limits.highest = machine.highest;
  limits.deepest = machine.deepest;
  int chattered = 0;
  for (int i = 0; i < count; ++i) {
    limits.cutsLeft = count - i;
    const auto next = nextCut(posterior, limits);
    if (!next) return chattered;
    const auto cut = makeCut(machine, i, next->speed, next->depth, limits.engagement, random);
    chattered += cut.outcome == learn::CutOutcome::Chatter ? 1 : 0;
    if (!posterior.add(cut)) return chattered;
  }
  return chattered;
}

double ownRemoval(const HiddenMachine& machine, const std::vector<learn::CutEvidence>& cuts) {
  const milling::CutModel model = machine.after(static_cast<int>(cuts.size()));
  double most = 0.0;
  for (int i = 0; i < 24; ++i) {
    const Rpm speed = machine.lowest + (machine.highest - machine.lowest) * (i / 23.0);
    most = std::max(most, trueLimit(model, speed, machine.deepest).depth * speed.value);
  }
  double own = 0.0;
  for (const auto& cut : cuts) {
    const bool main = cut.engagement.radialImmersion == model.engagement.radialImmersion &&
                      cut.engagement.side == model.engagement.side;
    if (!main || cut.outcome == learn::CutOutcome::Chatter) continue;
    if (trueLimit(model, cut.speed, machine.deepest).depth < cut.depth.value) continue;
    own = std::max(own, cut.depth.value * cut.speed.value);
  }
  return own / most;
}

}  // namespace stillcut::test
