#include "core/control/speed_choices.h"

#include <algorithm>
#include <cmath>

#include "core/control/machine_readings.h"
#include "core/control/target_speed.h"

namespace stillcut::control {
namespace {

constexpr std::size_t kMost = 4;
constexpr double kSameWaves = 0.05;  // of a wave: chatter's frequency is not known better at the present speed
constexpr double kHalf = 0.5;

void nearestFirst(std::vector<SpeedChoice>& choices, Rpm present) {
  const auto away = [present](const SpeedChoice& c) { return std::abs((c.speed - present).value); };
  std::stable_sort(choices.begin(), choices.end(),
                   [&away](const SpeedChoice& a, const SpeedChoice& b) { return away(a) < away(b); });
  if (choices.size() > kMost) choices.resize(kMost);
}

// A range that holds the present speed has been refuted by the cut itself.
std::vector<SpeedChoice> fromLobes(const SpeedQuestion& q) {
  std::vector<SpeedChoice> choices;
  for (const StableSpeeds::Range& range : q.known->ranges) {
    const Rpm low = std::max(range.from, q.reach.low);
    const Rpm high = std::min(range.to, q.reach.high);
    if (!(low < high) || (low <= q.present && q.present <= high)) continue;
    const Rpm best = std::clamp(range.best, low, high);
    choices.push_back({best, q.chatter / toothPassing(best, q.teeth), SpeedBasis::Lobes, low, high});
  }
  return choices;
}

std::vector<SpeedChoice> fromWaves(const SpeedQuestion& q) {
  const double waves = q.chatter / toothPassing(q.present, q.teeth);
  std::vector<SpeedChoice> choices;
  const auto add = [&](double wanted, SpeedBasis basis) {
    if (wanted < kHalf || std::abs(wanted - waves) < kSameWaves) return;
    const Rpm speed = q.present * (waves / wanted);
    if (q.reach.contains(speed)) choices.push_back({speed, wanted, basis, {}, {}});
  };
  const double whole = std::floor(waves);
  const double part = waves - whole;
  for (const double p : {whole - 1.0, whole, whole + 1.0, whole + 2.0}) {
    // Of the farther ones only where a nearer one is the present speed.
    const bool farther = p < whole || p > whole + 1.0;
    const bool needed = p < whole ? part < kSameWaves : part > 1.0 - kSameWaves;
    if (p >= 1.0 && (!farther || needed)) add(p, SpeedBasis::WholeWaves);
  }
  if (part > kHalf) add(whole + kHalf, SpeedBasis::HalfWave);
  return choices;
}

}  // namespace

std::vector<SpeedChoice> speedChoices(const SpeedQuestion& question) {
  const bool known = positive(question.chatter.value) && question.teeth > 0 && positive(question.present.value);
  if (!known) return {};
  std::vector<SpeedChoice> choices = question.known != nullptr ? fromLobes(question) : fromWaves(question);
  nearestFirst(choices, question.present);
  return choices;
}

}  // namespace stillcut::control
