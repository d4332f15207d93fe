#include "tests/support/field_cases/four_flute_sound.h"

#include "core/milling/simulation/noise.h"
#include "tests/support/field_cases/tone.h"

namespace stillcut::field {
namespace {

constexpr int kTeeth = 4;
constexpr double kGrowth_s = 0.3;
constexpr double kLoudness = 0.9;  // of full scale

}  // namespace

std::vector<double> fourFluteSamples(const FourFluteSound& s) {
  milling::NoiseSource random(s.seed);
  const double toothPassing = kTeeth * s.speed / 60.0;
  auto x = sampled(static_cast<std::size_t>(s.length * s.rate), s.rate,
                   [&](double /*t*/) { return kLoudness * 0.003 * random.normal(); });
  const auto inCut = sampled(x.size(), s.rate, [&](double t) { return t > s.entry ? 1.0 : 0.0; });
  for (int k = 1; k <= 6; ++k) addTone(x, s.rate, {kLoudness * 0.05 / k, k * toothPassing, 1.0 * k}, inCut);
  const auto grown = sampled(x.size(), s.rate, [&](double t) { return ramp(t, s.begin, kGrowth_s); });
  addTone(x, s.rate, {kLoudness * 0.25, s.chatter, 0.0}, grown);
  return x;
}

FieldCase fourFluteCase(const FourFluteSound& s, const std::vector<std::vector<double>>& channels) {
  Signal signal{s.rate, SensorQuantity::Sound, {}};
  for (const auto& channel : channels) signal.channels.push_back(inSixteenBits(channel));
  return {std::move(signal), kTeeth, s.speed, {true, s.begin, s.begin + kGrowth_s, s.length - 0.1}};
}

FieldCase fourFluteSound(const FourFluteSound& s) {
  return fourFluteCase(s, {fourFluteSamples(s)});
}

}  // namespace stillcut::field
