#include "tests/support/field_cases/alarm_course.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>

#include "core/detect/registry.h"
#include "core/sensing/conditioner.h"

namespace stillcut::field {
namespace {

constexpr double kBlock_s = 0.005;  // as of every imported recording
constexpr double kLeastFraction = 0.9;

CutSetup setupOf(const record::RecordingFormat& format, int teeth, double speed) {
  CutSetup setup;
  setup.teeth = teeth;
  setup.nominalSpeed = Rpm(speed);
  setup.rate = format.rate;
  setup.blockFrames = std::max(1, static_cast<int>(format.rate.value * kBlock_s));
  for (const record::RecordedChannel& channel : format.channels) setup.channels.push_back(channel.info);
  return setup;
}

void follow(record::RecordingReader& reader, const CutSetup& setup, const Observe& observe, AlarmCourse& course) {
  auto detector = detect::makeDetector(detect::kDefaultDetector);
  if (!detector) {
    course.fault = detector.error().line();
    return;
  }
  detect::Conditioner conditioner;
  conditioner.prepare(setup, {});
  (*detector)->prepare(setup, {});
  SampleBlock block;
  block.allocate(static_cast<int>(setup.channels.size()), setup.blockFrames);
  bool before = false;
  Result<bool> more = reader.read(block);
  for (; more && *more; more = reader.read(block)) {
    const detect::ConditionedBlock& conditioned = conditioner.process(block, {});
    const Verdict verdict = (*detector)->process(conditioned);
    if (observe) observe(verdict, conditioned);
    const double time = sinceEpoch(verdict.time).value;
    if (before) course.alarms.back().to = time;
    if (verdict.alarming() && !before) course.alarms.push_back({time, time});
    before = verdict.alarming();
  }
  if (!more) course.fault = more.error().line();
}

template <class... Values>
std::string formatted(const char* format, Values... values) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace

AlarmCourse alarmCourse(record::RecordingReader& reader, int teeth, double speed, const Observe& observe) {
  AlarmCourse course;
  try {
    follow(reader, setupOf(reader.format(), teeth, speed), observe, course);
  } catch (const std::exception& e) {  // a set-up that no part can be prepared for
    course.fault = e.what();
  }
  return course;
}

std::string shortfall(const AlarmTruth& truth, const AlarmCourse& course) {
  if (!course.fault.empty()) return course.fault;
  const int alarms = static_cast<int>(course.alarms.size());
  if (!truth.chatter) {
    return alarms == 0 ? "" : formatted("%d alarms, the first at %.2f s", alarms, course.alarms.front().from);
  }
  if (alarms == 0) return "no alarm";
  double inAlarm = 0.0;
  for (const Interval& alarm : course.alarms) {
    inAlarm += std::max(0.0, std::min(alarm.to, truth.to) - std::max(alarm.from, truth.from));
  }
  const double fraction = inAlarm / (truth.to - truth.from);
  const std::string found = formatted("in alarm %.0f %% of it, %d alarms", 100.0 * fraction, alarms);
  if (course.alarms.front().from < truth.begin) {
    return formatted("alarm at %.2f s, chatter begins at %.2f s; ", course.alarms.front().from, truth.begin) + found;
  }
  const bool tooMany = truth.mostAlarms > 0 && alarms > truth.mostAlarms;
  return fraction < kLeastFraction || tooMany ? found : "";
}

}  // namespace stillcut::field
