#include "core/evaluate/alarm_score.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace stillcut::evaluate {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

bool overlap(double a, double b, double c, double d) {
  return std::max(a, c) < std::min(b, d);
}

// What of [begin, end) no chatter, begun or grown, covers with its margins.
std::vector<Alarm> outsideChatter(const std::vector<TruthSpan>& truth, const Alarm& alarm) {
  std::vector<Alarm> parts{alarm};
  for (const TruthSpan& span : truth) {
    if (span.kind != SpanKind::Chatter && span.kind != SpanKind::Grew) continue;
    const Seconds from = span.begin - kEarly;
    const Seconds to = span.end + kLinger;
    std::vector<Alarm> left;
    for (const Alarm& part : parts) {
      if (part.begin < from) left.push_back({part.begin, std::min(part.end, from)});
      if (part.end > to) left.push_back({std::max(part.begin, to), part.end});
    }
    parts = std::move(left);
  }
  return parts;
}

bool isFalse(const std::vector<TruthSpan>& truth, const Alarm& alarm) {
  for (const Alarm& part : outsideChatter(truth, alarm)) {
    for (const TruthSpan& span : truth) {
      const bool inside = overlap(part.begin.value, part.end.value, span.begin.value, span.end.value);
      if (span.kind == SpanKind::Quiet && inside) return true;
    }
  }
  return false;
}

}  // namespace

SpanKind kindOf(const std::string& asWritten) {
  std::string label = asWritten;
  for (char& c : label) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (label.starts_with("chatter") || label == "true-alarm" || label == "heard") return SpanKind::Chatter;
  for (const char* quiet : {"stable", "idle", "spindle_runup", "air", "quiet", "false-alarm", "entry_", "exit_"}) {
    if (label.starts_with(quiet)) return SpanKind::Quiet;
  }
  return SpanKind::Ignored;
}

void AlarmList::observe(Seconds time, const Verdict& verdict) {
  if (!verdict.alarming()) return;
  if (alarms_.empty() || time - alarms_.back().end > kAlarmPause) alarms_.push_back({time, time});
  alarms_.back().end = time;
}

double AlarmScore::falsePerHour() const {
  return quiet.value > 0.0 ? falseAlarms * 3600.0 / quiet.value : kNothing;
}

double AlarmScore::delayQuantile(double share) const {
  if (delays_s.empty()) return kNothing;
  std::vector<double> sorted = delays_s;
  std::sort(sorted.begin(), sorted.end());
  const double at = std::ceil(share * static_cast<double>(sorted.size())) - 1.0;
  return sorted[static_cast<std::size_t>(std::max(0.0, at))];
}

void AlarmScore::add(const AlarmScore& other) {
  spans += other.spans;
  found += other.found;
  alarms += other.alarms;
  falseAlarms += other.falseAlarms;
  quiet += other.quiet;
  delays_s.insert(delays_s.end(), other.delays_s.begin(), other.delays_s.end());
}

AlarmScore scoreAlarms(const std::vector<TruthSpan>& told, const std::vector<Alarm>& alarms, Seconds length) {
  // What is marked after the end was never judged.
  std::vector<TruthSpan> truth = told;
  if (length.value > 0.0) {
    for (TruthSpan& span : truth) span.end = std::min(span.end, length);
    std::erase_if(truth, [](const TruthSpan& s) { return s.end < s.begin; });
  }
  AlarmScore score;
  score.alarms = static_cast<int>(alarms.size());
  const bool listened = std::any_of(truth.begin(), truth.end(), [](const TruthSpan& s) { return s.touched; });
  if (listened) score.quiet = length;
  for (const TruthSpan& span : truth) {
    const Seconds spanned = span.end - span.begin;
    if (span.kind == SpanKind::Quiet && !listened) score.quiet += spanned;
    if (span.kind != SpanKind::Chatter) continue;
    if (listened) score.quiet = std::max(Seconds(), score.quiet - spanned);
    ++score.spans;
    const auto first = std::find_if(alarms.begin(), alarms.end(),
                                    [&span](const Alarm& a) { return a.end >= span.begin && a.begin <= span.end; });
    if (first == alarms.end()) continue;
    ++score.found;
    score.delays_s.push_back(std::max(0.0, (first->begin - span.begin).value));
  }
  for (const Alarm& alarm : alarms) score.falseAlarms += isFalse(truth, alarm) ? 1 : 0;
  return score;
}

}  // namespace stillcut::evaluate
