#include "tests/support/field_cases/table_cut.h"

#include "core/milling/simulation/noise.h"
#include "tests/support/field_cases/tone.h"

namespace stillcut::field {
namespace {

constexpr int kTeeth = 2;
constexpr double kEntry_s = 1.5, kBegin_s = 4.0, kGrowth_s = 0.3;
constexpr double kNoise = 0.02;    // m/s^2
constexpr double kGravity = 9.81;  // m/s^2

}  // namespace

TableSamples tableSamples(const TableCut& s) {
  milling::NoiseSource random(s.seed);
  TableSamples all;
  all.t = sampled(kTableRows, kTableRate, [](double t) { return t; });
  all.x = sampled(kTableRows, kTableRate, [&](double /*t*/) { return kNoise * random.normal(); });
  const auto inCut = sampled(kTableRows, kTableRate, [](double t) { return t > kEntry_s ? 1.0 : 0.0; });
  for (int k = 1; k < 8; ++k) addTone(all.x, kTableRate, {2.0 / k, k * kTeeth * s.spindle, 1.0 * k}, inCut);
  const auto grown = sampled(kTableRows, kTableRate, [](double t) { return ramp(t, kBegin_s, kGrowth_s); });
  addTone(all.x, kTableRate, {8.0, s.chatter, 0.0}, grown);
  for (const double v : all.x) {
    all.y.push_back(0.7 * v + kNoise * random.normal());
    all.z.push_back(0.3 * v + kGravity + kNoise * random.normal());
  }
  return all;
}

FieldCase tableCase(const TableCut& s, const TableSamples& samples, int axes) {
  Signal signal{kTableRate, SensorQuantity::Acceleration, {}};
  for (const auto* axis : {&samples.x, &samples.y, &samples.z}) {
    if (static_cast<int>(signal.channels.size()) < axes) signal.channels.push_back(inSinglePrecision(*axis));
  }
  return {std::move(signal), kTeeth, 60.0 * s.spindle, {true, kBegin_s, kBegin_s + 0.4, kTableLength - 0.1}};
}

}  // namespace stillcut::field
