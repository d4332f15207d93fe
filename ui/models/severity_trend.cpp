#include "ui/models/severity_trend.h"

namespace stillcut::ui {
namespace {

constexpr Seconds kWindow{0.5};
constexpr Seconds kLeast{0.1};   // less says nothing about a trend
constexpr double kChange = 0.1;  // of the energy ratio per second: a change smaller than this is called steady

}  // namespace

void SeverityTrend::add(const Verdict& verdict) {
  if (!verdict.alarming()) {
    points_.clear();
    return;
  }
  if (!points_.empty() && verdict.time <= points_.back().time) return;
  points_.push_back({verdict.time, verdict.severity.value});
  while (secondsBetween(points_.front().time, verdict.time) > kWindow) points_.pop_front();
}

Trend SeverityTrend::trend() const {
  if (points_.empty() || secondsBetween(points_.front().time, points_.back().time) < kLeast) return Trend::Unknown;
  // Slope of the least-squares line.
  const auto n = static_cast<double>(points_.size());
  double st = 0, sy = 0, stt = 0, sty = 0;
  for (const Point& p : points_) {
    const double t = secondsBetween(points_.front().time, p.time).value;
    st += t;
    sy += p.severity;
    stt += t * t;
    sty += t * p.severity;
  }
  const double slope = (n * sty - st * sy) / (n * stt - st * st);
  return slope > kChange ? Trend::Growing : slope < -kChange ? Trend::Fading : Trend::Steady;
}

}  // namespace stillcut::ui
