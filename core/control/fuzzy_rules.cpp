#include "core/control/fuzzy_rules.h"

#include <algorithm>
#include <cmath>

namespace stillcut::control {
namespace {

// Named as the paper's figures name them. NOLINTNEXTLINE(readability-identifier-naming)
constexpr double NB = 2.0, NM = 3.0, NS = 4.0, ZE = kZero, PS = 6.0, PM = 7.0, PB = 8.0;

}  // namespace

// clang-format off
const RuleTable kSpeedRules{{
    {PB, PM, PM, PM, PM, PM, PM, PS, PS},
    {PM, PM, PM, PS, PS, PS, PS, PS, PS},
    {PM, PM, PS, PS, PS, PS, ZE, ZE, ZE},
    {PS, PS, PS, ZE, ZE, ZE, ZE, ZE, ZE},
    {PS, PS, ZE, ZE, ZE, ZE, ZE, NS, NS},
    {ZE, ZE, ZE, ZE, ZE, ZE, NS, NS, NS},
    {ZE, ZE, ZE, NS, NS, NS, NS, NM, NM},
    {NS, NS, NS, NS, NS, NS, NM, NM, NM},
    {NS, NS, NM, NM, NM, NM, NM, NM, NB}}};
const RuleTable kFeedRules{{
    {PM, PM, PM, PM, PM, PM, PS, PS, PS},
    {PM, PM, PS, PS, PS, PS, PS, PS, ZE},
    {PS, PS, PS, PS, PS, ZE, ZE, ZE, ZE},
    {PS, PS, ZE, ZE, ZE, ZE, ZE, ZE, ZE},
    {ZE, ZE, ZE, ZE, ZE, ZE, ZE, ZE, ZE},
    {ZE, ZE, ZE, ZE, ZE, ZE, ZE, NS, NS},
    {ZE, ZE, ZE, ZE, NS, NS, NS, NS, NS},
    {ZE, NS, NS, NS, NS, NS, NS, NM, NM},
    {NS, NS, NS, NM, NM, NM, NM, NM, NM}}};
// clang-format on
const std::array<double, kEnergySets> kEnergyRules{PB, PM, PS, ZE, NS, NM, NB};

std::optional<RisingRule> risingRule(const RuleTable& table) STILLCUT_RT {
  std::optional<RisingRule> worst;
  double most = kMostRise;
  const auto compare = [&](const RisingRule& pair) {
    const double rise = table[pair.row][pair.column] - table[pair.overRow][pair.overColumn];
    if (rise <= most) return;
    most = rise;
    worst = pair;
  };
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < table[i].size(); ++j) {
      for (std::size_t before = 0; before < i; ++before) compare({i, j, before, j});
      for (std::size_t before = 0; before < j; ++before) compare({i, j, i, before});
    }
  }
  return worst;
}

template <int Sets>
std::array<double, Sets> memberships(double x) STILLCUT_RT {
  std::array<double, Sets> degree{};
  const double finite = std::isfinite(x) ? x : 0.0;
  const double place = (std::clamp(finite, -1.0, 1.0) + 1.0) * 0.5 * (Sets - 1);
  const auto below = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(Sets - 2));
  const double above = place - static_cast<double>(below);
  degree[below] = 1.0 - above;
  degree[below + 1] = above;
  return degree;
}

template std::array<double, kCoherenceSets> memberships<kCoherenceSets>(double x) STILLCUT_RT;
template std::array<double, kEnergySets> memberships<kEnergySets>(double x) STILLCUT_RT;

std::array<double, kCoherenceSets> memberships(double x, const SetCentres& centres) STILLCUT_RT {
  const double finite = std::isfinite(x) ? std::clamp(x, -1.0, 1.0) : 0.0;
  const std::array<double, 5> peaks{0.0, centres[0], centres[1], centres[2], 1.0};
  const double size = std::abs(finite);
  std::size_t below = 0;
  while (below < 3 && size >= peaks[below + 1]) ++below;
  const double above = (size - peaks[below]) / (peaks[below + 1] - peaks[below]);
  std::array<double, kCoherenceSets> degree{};
  constexpr std::size_t kMiddle = kCoherenceSets / 2;
  const auto at = [&degree, finite](std::size_t set) -> double& {
    return degree[finite < 0.0 ? kMiddle - set : kMiddle + set];
  };
  at(below) = 1.0 - above;
  at(below + 1) = above;
  return degree;
}

RuleTable firing(const FuzzyInputs& in, const SetCentres& centres) STILLCUT_RT {
  const auto rows = memberships(in.coherence, centres);
  const auto columns = memberships(in.change, centres);
  RuleTable strength{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) strength[i][j] = std::min(rows[i], columns[j]);
  }
  return strength;
}

double infer(const RuleTable& table, const FuzzyInputs& in, const SetCentres& centres) STILLCUT_RT {
  const RuleTable strength = firing(in, centres);
  WeightedAverage answer;
  for (std::size_t i = 0; i < table.size(); ++i) {
    for (std::size_t j = 0; j < table[i].size(); ++j) answer.add(strength[i][j], table[i][j]);
  }
  if (in.energyKnown) {
    const auto degree = memberships<kEnergySets>(in.energy);
    for (std::size_t i = 0; i < degree.size(); ++i) answer.add(degree[i], kEnergyRules[i]);
  }
  return std::clamp((answer.value() - kZero) / (9.0 - kZero), -1.0, 1.0);
}

}  // namespace stillcut::control
