#include "app/cli/learn/learn_answer.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/base/json_schema.h"
#include "core/learn/evidence_lines.h"

namespace stillcut::app {
namespace {

using nlohmann::json;

struct Value {
  double median = 0.0;
  double spread = 0.0;  // standard deviation of its logarithm
};

// Weighted mean and deviation of ln x.
template <class Read>
Value valueOf(const learn::GuessCloud& guesses, const Read& read) {
  double mean = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < guesses.size(); ++i) {
    const double x = std::log(read(guesses.machine(i)));
    mean += guesses.weights()[i] * x;
    square += guesses.weights()[i] * x * x;
  }
  return {std::exp(mean), std::sqrt(std::max(0.0, square - mean * mean))};
}

struct LearnedMode {
  Value frequency, damping, stiffness;
};

std::vector<LearnedMode> modesOf(const learn::GuessCloud& guesses) {
  std::vector<LearnedMode> modes;
  const std::size_t count = guesses.machine(0).modes.size();
  for (std::size_t m = 0; m < count; ++m) {
    modes.push_back({valueOf(guesses, [m](const auto& d) { return d.modes[m].frequency.value; }),
                     valueOf(guesses, [m](const auto& d) { return d.modes[m].damping; }),
                     valueOf(guesses, [m](const auto& d) { return d.modes[m].stiffness; })});
  }
  return modes;
}

json toJson(const Value& v) {
  return {{"median", v.median}, {"relative_sd", v.spread}};
}

int chattered(const std::vector<learn::CutEvidence>& cuts) {
  int count = 0;
  for (const auto& c : cuts) count += c.outcome == learn::CutOutcome::Chatter ? 1 : 0;
  return count;
}

}  // namespace

json toJson(const learn::CutEvidence& cut) {
  return json::parse(learn::evidenceLine(cut));
}

json toJson(const learn::LearnedAdvice& a) {
  return {{"speed_rpm", a.speed.value}, {"depth_mm", 1e3 * a.depth.value}, {"probability_stable", a.probabilityStable}};
}

json toJson(const learn::NextCut& next) {
  return {{"speed_rpm", next.speed.value},
          {"depth_mm", 1e3 * next.depth.value},
          {"probability_stable", next.probabilityStable},
          {"bits", next.bits},
          {"gain_expected", next.removalExpected / next.removalNow - 1.0},
          {"best_now", toJson(next.now)},
          {"best_if_stable", toJson(next.ifStable)},
          {"best_if_chatter", next.ifChatter.removal > 0.0 ? toJson(next.ifChatter) : json()}};
}

json postureJson(Learned& learned, double risk) {
  learn::MapRequest request = learned.work;
  request.speeds = 60;
  const learn::LimitQuantiles limits = limitQuantiles(learned.posterior, request, risk);
  json rows = json::array();
  for (std::size_t i = 0; i < limits.speeds.size(); ++i) {
    rows.push_back({{"speed_rpm", limits.speeds[i].value},
                    {"low_mm", 1e3 * limits.low[i].value},
                    {"median_mm", 1e3 * limits.median[i].value},
                    {"high_mm", 1e3 * limits.high[i].value},
                    {"at_risk_mm", 1e3 * limits.atRisk[i].value}});
  }
  json modes = json::array();
  for (const LearnedMode& m : modesOf(learned.posterior.guesses())) {
    modes.push_back({{"frequency_hz", toJson(m.frequency)},
                     {"damping", toJson(m.damping)},
                     {"stiffness_n_per_m", toJson(m.stiffness)}});
  }
  request.speeds = 160;
  const Message& anew = learned.posterior.startedAnew();
  return {
      {"schema", kJsonSchema},
      {"command", "learn show"},
      {"prior", learned.origin},
      {"cuts", learned.cuts.size()},
      {"chattered", chattered(learned.cuts)},
      {"forgotten", learned.posterior.forgotten()},
      {"started_anew", anew.empty() ? json() : json(text(anew))},
      {"last_cut_expected", learned.posterior.lastExpected()},
      {"modes", modes},
      {"tangential_n_per_m2", toJson(valueOf(learned.posterior.guesses(), [](const auto& d) { return d.tangential; }))},
      {"risk", risk},
      {"advice", toJson(learnedAdvice(learned.posterior, request, risk))},
      {"limits", rows}};
}

void printPosture(Learned& learned, double risk) {
  const int chatter = chattered(learned.cuts);
  std::printf("%zu cuts, %d of them with chatter; from: %s\n", learned.cuts.size(), chatter, learned.origin.c_str());
  const Message& anew = learned.posterior.startedAnew();
  if (!anew.empty()) std::printf("%s\n", text(anew).c_str());
  if (!learned.cuts.empty() && learned.posterior.lastExpected() < 0.1) {
    std::printf("the last cut was not expected (%.0f %%): another cause than the lobes, or is the tool another one?\n",
                100.0 * learned.posterior.lastExpected());
  }
  for (const LearnedMode& m : modesOf(learned.posterior.guesses())) {
    std::printf("mode %6.0f Hz +- %.0f %%, damping %.3f +- %.0f %%, stiffness %.3g N/m +- %.0f %%\n",
                m.frequency.median, 100.0 * m.frequency.spread, m.damping.median, 100.0 * m.damping.spread,
                m.stiffness.median, 100.0 * m.stiffness.spread);
  }
  learn::MapRequest request = learned.work;
  request.speeds = 16;
  const learn::LimitQuantiles limits = limitQuantiles(learned.posterior, request, risk);
  std::printf("%10s %10s %10s %10s %14s\n", "rpm", "10 % [mm]", "50 % [mm]", "90 % [mm]", "at risk [mm]");
  for (std::size_t i = 0; i < limits.speeds.size(); ++i) {
    std::printf("%10.0f %10.2f %10.2f %10.2f %14.2f\n", limits.speeds[i].value, 1e3 * limits.low[i].value,
                1e3 * limits.median[i].value, 1e3 * limits.high[i].value, 1e3 * limits.atRisk[i].value);
  }
  request.speeds = 160;
  const learn::LearnedAdvice best = learnedAdvice(learned.posterior, request, risk);
  std::printf("most is removed at %.0f rpm and %.2f mm, stable with %.0f %%\n", best.speed.value,
              1e3 * best.depth.value, 100.0 * best.probabilityStable);
}

}  // namespace stillcut::app
