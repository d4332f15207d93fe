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

template <class... Values>
std::string words(const char* form, Values... values) {
  std::string text(256, '\0');
  const int size = std::snprintf(text.data(), text.size(), form, values...);
  text.resize(static_cast<std::size_t>(std::clamp(size, 0, 255)));
  return text;
}

Seconds median(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return Seconds(values[values.size() / 2]);
}

}  // namespace

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
      steps_.push_back(safety());
      break;
  }
  if (!steps_.back().good || steps_.size() == kSteps) link_.close();
  return true;
}

bool LinkTrial::passed() const {
  return steps_.size() == kSteps && std::all_of(steps_.begin(), steps_.end(), [](const auto& s) { return s.good; });
}

TrialStep LinkTrial::connect() {
  const Status opened = link_.open();
  if (!opened) return {kNames[0], opened.error().line(), false};
  return {kNames[0], std::string(link_.describe().label) + " answers", true};
}

TrialStep LinkTrial::read() {
  const Instant began = clock_.now();
  MachineState m;
  rt::Wakeup never;  // only its time-out is used
  while (clock_.now() - began < kReadTime && !m.valid) {
    m = link_.read(clock_.now());
    if (!m.valid) never.waitFor(kBetweenReads);
  }
  if (!m.valid) return {kNames[1], "it answers, but its state is incomplete", false};
  const char* const doing = m.block == OrderBlock::MachineOff     ? "the machine is off"
                            : m.block == OrderBlock::MachineAlarm ? "the machine is in alarm"
                            : m.feedHold                          ? "feed held"
                            : m.programRunning                    ? "program running"
                                                                  : "no program running";
  return {kNames[1],
          words("%s; spindle %.0f rev/min, programmed %.0f; overrides %.0f %% speed, %.0f %% feed%s", doing,
                m.actualSpeed.value, m.programmedSpeed.value, 100.0 * m.speedOverride.value,
                100.0 * m.feedOverride.value, m.overridesEnabled ? "" : "; locked by the program"),
          true};
}

TrialStep LinkTrial::measure() {
  std::vector<double> looks, ages;
  for (int i = 0; i < kLooks; ++i) {
    const Instant before = clock_.now();
    const MachineState m = link_.read(before);
    const Instant after = clock_.now();
    looks.push_back(secondsBetween(before, after).value);
    if (m.valid) ages.push_back(std::max(0.0, secondsBetween(m.time, after).value));
  }
  look_ = median(looks);
  age_ = median(ages);
  const int lost = kLooks - static_cast<int>(ages.size());
  std::string said =
      words("a look takes %.1f ms, and what it shows is %.1f ms old", 1e3 * look_.value, 1e3 * age_.value);
  if (lost > 0) said += words("; %d of %d looks were lost", lost, kLooks);
  return {kNames[2], said, 2 * lost < kLooks};
}

TrialStep LinkTrial::safety() const {
  const LinkInfo info = link_.describe();
  const std::string range =
      words("speed %.0f to %.0f %%, feed %.0f to %.0f %%; ", 100.0 * info.lowestSpeed.value,
            100.0 * info.highestSpeed.value, 100.0 * info.lowestFeed.value, 100.0 * info.highestFeed.value);
  return {kNames[3],
          range + (info.machineWatchdog ? "the machine goes back by itself when nothing comes from here"
                                        : "the machine has no watchdog: if this program dies, the overrides stay"),
          true};
}

}  // namespace stillcut::cnc
