#include <array>
#include <utility>

#include "core/base/conversions.h"
#include "core/model/channel.h"
#include "core/model/machine_state.h"
#include "core/model/operator_input.h"
#include "core/model/recording_answer.h"
#include "core/model/verdict.h"

namespace stillcut {
namespace {

struct QuantityRow {
  SensorQuantity quantity;
  std::string_view name;
  std::string_view unit;
  int integration;
};

constexpr std::array<QuantityRow, 7> kQuantities{{
    {SensorQuantity::Acceleration, "acceleration", "m/s\u00b2", -1},
    {SensorQuantity::Velocity, "velocity", "m/s", 0},
    {SensorQuantity::Displacement, "displacement", "m", 1},
    {SensorQuantity::Sound, "sound", "Pa", 0},
    {SensorQuantity::Force, "force", "N", 0},
    {SensorQuantity::Current, "current", "A", 0},
    {SensorQuantity::SpindleSpeed, "speed", "rpm", 0},
}};

const QuantityRow& row(SensorQuantity q) {
  return kQuantities[static_cast<std::size_t>(q)];
}

}  // namespace

std::string_view name(SensorQuantity q) {
  return row(q).name;
}

std::optional<SensorQuantity> sensorQuantityFromName(std::string_view text) {
  for (const QuantityRow& r : kQuantities) {
    if (r.name == text) return r.quantity;
  }
  return std::nullopt;
}

std::string_view siUnit(SensorQuantity q) {
  return row(q).unit;
}

double scaleOf(SensorQuantity q, double sensitivity, double volts) {
  return volts * 1e3 / sensitivity * (q == SensorQuantity::Acceleration ? kStandardGravity : 1.0);
}

int integrationFactor(SensorQuantity q) {
  return row(q).integration;
}

std::string_view name(CutState s) {
  constexpr std::array<std::string_view, 4> kNames{"air", "stable", "onset", "chatter"};
  return kNames[static_cast<std::size_t>(s)];
}

std::string_view name(CutPhase p) {
  constexpr std::array<std::string_view, 5> kNames{"air", "runup", "entry", "steady", "exit"};
  return kNames[static_cast<std::size_t>(p)];
}

std::string_view name(ChatterKind k) {
  constexpr std::array<std::string_view, 4> kNames{"unknown", "hopf", "flip", "forced"};
  return kNames[static_cast<std::size_t>(k)];
}

std::string_view name(Authority a) {
  constexpr std::array<std::string_view, 3> kNames{"off", "advise", "auto"};
  return kNames[static_cast<std::size_t>(a)];
}

std::string_view name(OverrideInhibit block) {
  constexpr std::array<std::string_view, kOverrideInhibits> kNames{
      "none",          "machine-off",     "machine-alarm", "no-program",      "overrides-locked", "speed-locked",
      "feed-locked",   "adaptive-locked", "other-client",  "control-refused", "component-silent", "component-down",
      "component-out", "starting"};
  return kNames[static_cast<std::size_t>(block) % kNames.size()];
}

std::string_view name(Finding f) {
  constexpr std::array<std::string_view, 3> kNames{"not-judged", "no-chatter", "chatter"};
  return kNames[static_cast<std::size_t>(f)];
}

std::string_view name(SpeedBasis b) {
  constexpr std::array<std::string_view, 3> kNames{"whole-waves", "half-wave", "lobes"};
  return kNames[static_cast<std::size_t>(b)];
}

}  // namespace stillcut
