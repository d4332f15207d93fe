#include "core/evaluate/audacity_labels.h"

#include <algorithm>
#include <cstdio>

#include "core/evaluate/alarm_score.h"

namespace stillcut::evaluate {
namespace {

constexpr double kBand = 0.02;      // of the frequency, on either side of it
constexpr Seconds kShortest{0.05};  // of what could not be judged

}  // namespace

void AudacityLabels::observe(Seconds time, Seconds took, const Verdict& verdict) {
  if (verdict.valid && !verdict.alarming()) return;
  const Seconds begin = std::max(Seconds(), time - took);
  const bool alarm = verdict.alarming();
  const auto goesOn = [&](const Label& last) {
    const Seconds pause = begin - last.end;
    return last.alarm == alarm && (alarm ? pause < kAlarmPause : last.code == verdict.reason.code && pause < took);
  };
  if (labels_.empty() || !goesOn(labels_.back())) {
    Label label;
    label.begin = begin;
    label.alarm = alarm;
    label.code = verdict.reason.code;
    label.reason = verdict.reason;
    labels_.push_back(label);
  }
  Label& label = labels_.back();
  label.end = time;
  if (!alarm) return;
  label.worst = std::max(label.worst, verdict.state);
  if (!(verdict.frequency.value > 0.0)) return;
  label.weight += verdict.severity.value;
  label.weighted += verdict.severity.value * verdict.frequency.value;
}

std::string AudacityLabels::text() const {
  std::string all;
  for (const Label& l : labels_) {
    if (!l.alarm && l.end - l.begin < kShortest) continue;
    char times[80];
    std::snprintf(times, sizeof times, "%.6f\t%.6f\t", l.begin.value, l.end.value);
    all += times;
    if (!l.alarm) {
      all += "not judged: " + sentence(l.reason) + "\n";
      continue;
    }
    all += name(l.worst);
    const double hertz = l.weight > 0.0 ? l.weighted / l.weight : 0.0;
    char band[96] = "";
    if (hertz > 0.0) {
      std::snprintf(band, sizeof band, " %.0f Hz\n\\\t%.3f\t%.3f", hertz, hertz * (1.0 - kBand), hertz * (1.0 + kBand));
    }
    all += band + std::string("\n");
  }
  return all;
}

}  // namespace stillcut::evaluate
