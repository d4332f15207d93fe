#include "core/cnc/link_trial.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/rt/wakeup.h"

namespace stillcut::cnc {
namespace {

constexpr Duration kReadTime = std::chrono::seconds(3);
constexpr Seconds kBetweenReads{0.002};

constexpr const char* kAnswers = "%1 answers";
constexpr const char* kIncomplete = "it answers, but its state is incomplete";
constexpr const char* kOff = "the machine is off";
constexpr const char* kAlarm = "the machine is in alarm";
constexpr const char* kHeld = "feed held";
constexpr const char* kRunning = "program running";
constexpr const char* kIdle = "no program running";
constexpr const char* kSpindle = "spindle %1 rpm, programmed %2";
constexpr const char* kUnmeasured = "spindle programmed %1 rpm, not measured";
constexpr const char* kOverrides = "overrides %1 % speed, %2 % feed";
constexpr const char* kLocked = "locked by the program";
constexpr const char* kDelay = "a look takes %1 ms, and what it shows is %2 ms old";
constexpr const char* kLost = "%1 of %2 looks were lost";
constexpr const char* kRange = "speed %1 to %2 %, feed %3 to %4 %";
constexpr const char* kProved = "an order was seen to act, and to be taken back, after %1 ms";
constexpr const char* kUnproved = "no order has shown it yet: nothing was moved";
constexpr const char* kWatchdog = "the machine goes back by itself when nothing comes from here";
constexpr const char* kNoWatchdog = "the machine has no watchdog: if this program dies, the overrides stay";
constexpr const char* kKept =
    "the machine has no watchdog: a process of its own brings the overrides back if this program dies; they stay where "
    "both are killed at once, or the cable goes";
constexpr const char* kByTheRun = "as the run that holds the machine tells: nothing more was asked";
constexpr std::array kWords{kAnswers, kIncomplete, kOff,       kAlarm,      kHeld,  kRunning, kIdle,
                            kSpindle, kUnmeasured, kOverrides, kLocked,     kDelay, kLost,    kRange,
                            kProved,  kUnproved,   kWatchdog,  kNoWatchdog, kKept,  kByTheRun};

std::string number(double value, int decimals = 0) {
  std::array<char, 32> digits{};
  const int size = std::snprintf(digits.data(), digits.size(), "%.*f", decimals, value);
  return {digits.data(), static_cast<std::size_t>(std::clamp(size, 0, 31))};
}

std::string percent(Ratio value) {
  return number(100.0 * value.value);
}

Message spindle(const MachineState& m) {
  const std::string programmed = number(m.programmedSpeed.value);
  const bool measured = m.actualSpeed.value > 0.0 || m.link.speed != Instant{};
  return measured ? Message(kSpindle, {number(m.actualSpeed.value), programmed}) : Message(kUnmeasured, {programmed});
}

Seconds median(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return Seconds(values[values.size() / 2]);
}

LinkTrialStep readStep(const MachineState& m) {
  if (!m.valid) return {LinkTrial::kNames[1], {{kIncomplete, {}}}, false};
  const char* const doing = m.block == OverrideInhibit::MachineOff     ? kOff
                            : m.block == OverrideInhibit::MachineAlarm ? kAlarm
                            : m.feedHold                               ? kHeld
                            : m.programRunning                         ? kRunning
                                                                       : kIdle;
  LinkTrialStep step{LinkTrial::kNames[1],
                     {{doing, {}}, spindle(m), {kOverrides, {percent(m.speedOverride), percent(m.feedOverride)}}},
                     true};
  if (!m.overridesEnabled) step.said.push_back({kLocked, {}});
  return step;
}

LinkTrialStep safetyStep(const LinkInfo& info, Seconds effect) {
  const char* const alone = info.machineWatchdog ? kWatchdog : info.kept ? kKept : kNoWatchdog;
  return {
      LinkTrial::kNames[3],
      {{kRange,
        {percent(info.lowestSpeed), percent(info.highestSpeed), percent(info.lowestFeed), percent(info.highestFeed)}},
       effect.value > 0.0 ? Message(kProved, {number(1e3 * effect.value)}) : Message(kUnproved, {}),
       {alone, {}}},
      true};
}

}  // namespace

std::span<const char* const> LinkTrial::words() {
  return kWords;
}

bool LinkTrial::next() {
  if (steps_.size() == kSteps || (!steps_.empty() && !steps_.back().good)) return false;
  switch (steps_.size()) {
    case 0:
      steps_.push_back(connect());
      break;
    case 1:
      steps_.push_back(read());
      break;
    case 2:
      steps_.push_back(measure());
      break;
    default:
      steps_.push_back(safetyStep(link_.describe(), effect_));
      break;
  }
  if (!steps_.back().good || steps_.size() == kSteps) link_.close();
  return true;
}

bool LinkTrial::passed() const {
  return steps_.size() == kSteps && std::all_of(steps_.begin(), steps_.end(), [](const auto& s) { return s.good; });
}

LinkTrialStep LinkTrial::connect() {
  const Status opened = link_.open();
  if (!opened) return {kNames[0], {opened.error().asMessage()}, false};
  return {kNames[0], {{kAnswers, {std::string(link_.describe().label)}}}, true};
}

LinkTrialStep LinkTrial::read() {
  const Instant began = clock_.now();
  MachineState m;
  rt::Wakeup never;  // only its time-out is used
  while (clock_.now() - began < kReadTime && !m.valid) {
    m = link_.read(clock_.now());
    if (!m.valid) never.waitFor(kBetweenReads);
  }
  return readStep(m);
}

LinkTrialStep LinkTrial::measure() {
  std::vector<double> looks, ages;
  Seconds roundTrip{};
  for (int i = 0; i < kLooks; ++i) {
    const Instant before = clock_.now();
    const MachineState m = link_.read(before);
    const Instant after = clock_.now();
    looks.push_back(secondsBetween(before, after).value);
    if (!m.valid) continue;
    ages.push_back(std::max(0.0, secondsBetween(m.time, after).value));
    roundTrip = m.link.roundTrip;
  }
  // A link that runs apart tells what it knows at once: what it has measured itself counts then.
  look_ = std::max(median(looks), roundTrip);
  age_ = median(ages);
  const int lost = kLooks - static_cast<int>(ages.size());
  LinkTrialStep step{
      kNames[2], {{kDelay, {number(1e3 * look_.value, 1), number(1e3 * age_.value, 1)}}}, 2 * lost < kLooks};
  if (lost > 0) step.said.push_back({kLost, {number(lost), number(kLooks)}});
  return step;
}

std::vector<LinkTrialStep> LinkTrial::ofRun(const LinkInfo& info, const MachineState& state, Seconds age,
                                            Seconds effect) {
  std::vector<LinkTrialStep> steps{{kNames[0], {{kAnswers, {std::string(info.label)}}, {kByTheRun, {}}}, true},
                                   readStep(state)};
  if (!steps.back().good) return steps;
  const std::string look = number(1e3 * state.link.roundTrip.value, 1);
  steps.push_back({kNames[2], {{kDelay, {look, number(1e3 * age.value, 1)}}}, true});
  steps.push_back(safetyStep(info, effect));
  return steps;
}

}  // namespace stillcut::cnc
