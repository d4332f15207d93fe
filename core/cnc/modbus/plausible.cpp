#include "core/cnc/modbus/plausible.h"

#include <algorithm>
#include <cmath>

namespace stillcut::cnc {
namespace {

constexpr double kFastestSpindle = 300000.0;  // rev/min
constexpr double kFastestFeed = 600000.0;     // mm/min
constexpr double kHighestKnob = 400.0;        // %
constexpr double kTooFast = 2.0;              // times the programmed speed at the highest override
constexpr double kLargeJump = 0.25;           // of the programmed value
constexpr double kSmallJump = 100.0;          // rev/min or mm/min, where little or nothing is programmed
constexpr double kKnobJump = 10.0;            // %
constexpr double kAnyCount = 1e12;            // a counter may stand anywhere

bool isSpeed(MachineSignal s) noexcept {
  return s == MachineSignal::ProgrammedSpeed || s == MachineSignal::ActualSpeed;
}
bool isFeed(MachineSignal s) noexcept {
  return s == MachineSignal::ProgrammedFeed || s == MachineSignal::ActualFeed;
}

}  // namespace

bool isFlag(MachineSignal s) noexcept {
  return s >= MachineSignal::Running && s <= MachineSignal::OverridesEnabled;
}

MachineSignal programmedOf(MachineSignal s) noexcept {
  return isFeed(s) ? MachineSignal::ProgrammedFeed : MachineSignal::ProgrammedSpeed;
}

bool canBe(const RegisterMap& map, MachineSignal s, double value, double fastest) noexcept {
  if (isFlag(s) || s == MachineSignal::Heartbeat) return true;
  double highest = isSpeed(s) ? kFastestSpindle : isFeed(s) ? kFastestFeed : kHighestKnob;
  if (s == MachineSignal::ActualSpeed && fastest > 0.0) highest = kTooFast * fastest * map.highestSpeed.value;
  // Backwards is a speed too; what is programmed and chosen has no sign.
  const bool measured = s == MachineSignal::ActualSpeed || s == MachineSignal::ActualFeed;
  const Register& r = *map.at(s);
  return std::isfinite(value) && value >= r.lowest.value_or(measured ? -highest : 0.0) &&
         value <= r.highest.value_or(highest);
}

double jumpOf(MachineSignal s, double programmed) noexcept {
  if (isFlag(s)) return 0.5;
  if (s == MachineSignal::Heartbeat) return kAnyCount;
  if (!isSpeed(s) && !isFeed(s)) return kKnobJump;
  return std::max(kSmallJump, kLargeJump * programmed);
}

}  // namespace stillcut::cnc
