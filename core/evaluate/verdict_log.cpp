#include "core/evaluate/verdict_log.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace stillcut::evaluate {
namespace {

constexpr double kBandsPerNeper = 50.0;  // bands of 2 %

bool differs(const Verdict& a, const Verdict& b) {
  return a.state != b.state || a.phase != b.phase || a.valid != b.valid || a.reason.code != b.reason.code ||
         a.earlyWarning != b.earlyWarning || a.kind != b.kind;
}

}  // namespace

void VerdictLog::observe(const Verdict& verdict) {
  const double dt = started_ ? secondsBetween(last_.time, verdict.time).value : 0.0;
  if (verdict.valid) sums_.validTime_s += dt;
  if (verdict.spindle.value > 0.0) {
    sums_.spindle_Hz += verdict.spindle.value * dt;
    spindleTime_ += dt;
  }
  if (verdict.alarming()) {
    if (!started_ || !last_.alarming()) ++sums_.alarms;
    if (sums_.firstAlarm_s < 0.0) sums_.firstAlarm_s = secondsBetween(begin_, verdict.time).value;
    sums_.alarmTime_s += dt;
    if (verdict.state == CutState::Chatter) sums_.chatterTime_s += dt;
    sums_.worstSeverity = std::max(sums_.worstSeverity, verdict.severity.value);
    if (verdict.frequency.value > 0.0) {
      Band& band = bands_[std::lround(kBandsPerNeper * std::log(verdict.frequency.value))];
      band.weight += verdict.severity.value;
      band.sum += verdict.severity.value * verdict.frequency.value;
    }
  }
  if (!verdict.valid) sums_.lastReason = sentence(verdict.reason);
  if (!started_ || differs(last_, verdict)) changes_.push_back(verdict);
  last_ = verdict;
  started_ = true;
}

void VerdictLog::appendEvents(nlohmann::json& array, std::size_t first) const {
  for (std::size_t i = first; i < changes_.size(); ++i) {
    const Verdict& v = changes_[i];
    array.push_back({{"t", secondsBetween(begin_, v.time).value},
                     {"detector", detector_},
                     {"state", std::string(name(v.state))},
                     {"phase", std::string(name(v.phase))},
                     {"valid", v.valid},
                     {"reason", sentence(v.reason)},
                     {"frequency_hz", v.frequency.value},
                     {"frequency_sd_hz", v.frequencySd.value},
                     {"severity", v.severity.value},
                     {"kind", std::string(name(v.kind))},
                     {"early_warning", v.earlyWarning}});
  }
}

// A line that lies where two bands meet belongs to both.
double VerdictLog::strongest() const {
  double most = 0.0;
  double frequency = 0.0;
  for (auto band = bands_.begin(); band != bands_.end(); ++band) {
    Band both = band->second;
    if (const auto next = std::next(band); next != bands_.end() && next->first == band->first + 1) {
      both.weight += next->second.weight;
      both.sum += next->second.sum;
    }
    if (!(both.weight > most)) continue;
    most = both.weight;
    frequency = both.sum / both.weight;
  }
  return frequency;
}

VerdictLog::Summary VerdictLog::summary() const {
  Summary s = sums_;
  s.detector = detector_;
  s.frequency_Hz = strongest();
  s.spindle_Hz = spindleTime_ > 0.0 ? sums_.spindle_Hz / spindleTime_ : 0.0;
  return s;
}

void toJson(nlohmann::json& object, const VerdictLog::Summary& s) {
  object = {{"detector", s.detector},
            {"alarms", s.alarms},
            {"first_alarm_s", s.alarms > 0 ? nlohmann::json(s.firstAlarm_s) : nlohmann::json()},
            {"alarm_time_s", s.alarmTime_s},
            {"chatter_time_s", s.chatterTime_s},
            {"valid_time_s", s.validTime_s},
            {"frequency_hz", s.frequency_Hz},
            {"worst_severity", s.worstSeverity},
            {"spindle_hz", s.spindle_Hz > 0.0 ? nlohmann::json(s.spindle_Hz) : nlohmann::json()},
            {"last_invalid_reason", s.lastReason}};
}

}  // namespace stillcut::evaluate
