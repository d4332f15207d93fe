#include "ui/plots/recording_curve.h"

#include <algorithm>

namespace stillcut::ui {
namespace {

bool alarming(const SummaryPoint& point) {
  return point.valid && (point.state == CutState::Onset || point.state == CutState::Chatter);
}

}  // namespace

double loudest(const SessionSummary& summary) {
  double top = 0.0;
  for (const SummaryPoint& point : summary.curve) top = std::max(top, point.vibration);
  return top;
}

QString vibrationUnit(const SessionSummary& summary) {
  if (summary.setup.channels.empty()) return {};
  const std::string_view si = siUnit(summary.setup.channels.front().quantity);
  return QString::fromUtf8(si.data(), static_cast<qsizetype>(si.size()));
}

std::vector<AlarmSpan> recordedAlarms(const SessionSummary& summary) {
  std::vector<AlarmSpan> spans;
  const auto& curve = summary.curve;
  const Seconds step(curve.size() > 1 ? curve[1].time.value - curve[0].time.value : 0.1);
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (!alarming(curve[k])) continue;
    if (k == 0 || !alarming(curve[k - 1])) spans.push_back({curve[k].time, curve[k].time});
    spans.back().end = curve[k].time + step;
  }
  return spans;
}

}  // namespace stillcut::ui
