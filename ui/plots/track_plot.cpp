#include "ui/plots/track_plot.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"

namespace stillcut::ui {
namespace {

// The state is told by height as well as by colour: nothing, low, half, full.
double heightOf(const TrackPoint& point) {
  if (!point.judged) return 0.0;
  switch (point.state) {
    case CutState::AirCutting:
      return 0.0;
    case CutState::Stable:
      return 0.2;
    case CutState::Onset:
      return 0.6;
    case CutState::Chatter:
      return 1.0;
  }
  return 0.0;
}

QColor colorOf(const TrackPoint& point, const Theme& theme) {
  if (point.state == CutState::Chatter) return theme.back(Tone::Chatter);
  if (point.state == CutState::Onset) return theme.back(Tone::Onset);
  return theme.colors.fill;
}

// A ratio has a scale of one; what grows beyond has as much as it needs.
double fullScale(const std::deque<TrackPoint>& track) {
  double full = 1.0;
  for (const TrackPoint& point : track) {
    if (point.judged && std::isfinite(point.indicator))
      full = std::max(full, std::abs(static_cast<double>(point.indicator)));
  }
  return full;
}

}  // namespace

TrackPlot::TrackPlot(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("DETECTORS"), parent) {
  setLegend(tr("low: stable, half: onset, full: chatter; line: first indicator"));
  setToolTip(tr("Low: stable. Half: onset. Full: chatter. Hatched: no verdict. The line is the first indicator."));
}

void TrackPlot::seeLimits(Instant now, const std::vector<double>& limits) {
  limits_.resize(std::max(limits_.size(), limits.size()));
  for (std::size_t k = 0; k < limits.size(); ++k) {
    std::deque<Limit>& known = limits_[k];
    const bool same = !known.empty() &&
                      (known.back().value == limits[k] || (std::isnan(known.back().value) && std::isnan(limits[k])));
    if (!same) known.push_back({now, limits[k]});
    while (known.size() > 1 && secondsBetween(known[1].from, now) > RunHistory::kKept) known.pop_front();
  }
}

double TrackPlot::limitAt(std::size_t track, Instant t) const {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (track >= limits_.size()) return value;
  for (const Limit& limit : limits_[track]) {
    if (limit.from > t && std::isfinite(value)) break;
    value = limit.value;
  }
  return value;
}

void TrackPlot::restart() {
  limits_.clear();
  display(nullptr, {}, 0);
}

void TrackPlot::display(const RunHistory* history, std::vector<Row> rows, int inCharge) {
  history_ = history;
  rows_ = std::move(rows);
  inCharge_ = inCharge;
  update();
}

QSize TrackPlot::minimumSizeHint() const {
  return {theme().px(420), theme().px(static_cast<double>(60 + 26 * std::max<std::size_t>(rows_.size(), 1)))};
}

void TrackPlot::drawPlot(QPainter& p, const QRect& plot) {
  if (history_ == nullptr || history_->tracks().empty()) return;
  const auto& tracks = history_->tracks();
  clipped_ = false;
  const double height = plot.height() / static_cast<double>(tracks.size()), gap = theme().px(4);
  for (std::size_t k = 0; k < tracks.size(); ++k) {
    const QRectF row(plot.left(), plot.top() + height * static_cast<double>(k) + gap / 2, plot.width(), height - gap);
    p.save();
    p.setClipRect(row);
    const double full = fullScale(tracks[k]);
    const Row about = k < rows_.size() ? rows_[k] : Row();
    drawTrack(p, row, tracks[k], full);
    p.restore();
    drawScale(p, row, full);
    drawLimit(p, row, full, about.limit, k);
    drawReadings(p, row, tracks[k]);
    p.setPen(theme().colors.text);
    const QString& name = about.name;
    const double room = theme().px(68);
    p.setFont(fitting(name, static_cast<int>(k) == inCharge_, room));
    p.drawText(QRectF(plot.left() - room - theme().px(4), row.top(), room, row.height()),
               Qt::AlignRight | Qt::AlignVCenter | Qt::TextWordWrap, name);
  }
}

// The largest type in which the longest word of the name fits; names wrap, words do not.
QFont TrackPlot::fitting(const QString& name, bool bold, double room) {
  const QStringList words = name.split(u' ');
  QFont font;
  double widest = 0.0;
  for (int halves = static_cast<int>(2.0 * type_size::kTick); halves * theme().text > 18.0; --halves) {
    font = theme().font(0.5 * halves, bold);
    widest = 0.0;
    for (const QString& word : words) widest = std::max(widest, QFontMetricsF(font).horizontalAdvance(word));
    if (widest <= room) break;
  }
  clipped_ = clipped_ || widest > room;
  return font;
}

void TrackPlot::drawTrack(QPainter& p, const QRectF& row, const std::deque<TrackPoint>& track, double full) const {
  if (track.empty()) return;
  const auto first = std::lower_bound(track.begin(), track.end(), view().from(),
                                      [](const TrackPoint& point, Instant t) { return point.time < t; });
  std::vector<QPolygonF> curves(1);  // one between two gaps
  p.setRenderHint(QPainter::Antialiasing, false);
  for (auto it = first == track.begin() ? first : first - 1; it != track.end() && it->time <= view().to();) {
    const TrackPoint& begin = *it;
    const double left = xOf(begin.time);
    if (begin.afterGap && it != track.begin()) {
      // What the screen slept through besides is no gap of the samples.
      constexpr Seconds kLate{0.3};
      const bool late = secondsBetween((it - 1)->time, begin.time) > kLate;
      const double since = late ? left - 2.0 : xOf((it - 1)->time);
      p.fillRect(QRectF(since, row.top(), left - since, row.height()), theme().colors.gap);
      if (!curves.back().isEmpty()) curves.emplace_back();
    }
    // One rectangle for a whole run of the same state; of the curve one point for each pixel.
    const auto same = [&](const TrackPoint& t) {
      return t.time <= view().to() && t.judged == begin.judged && t.state == begin.state &&
             (&t == &begin || !t.afterGap);
    };
    for (; it != track.end() && same(*it); ++it) {
      QPolygonF& curve = curves.back();
      const double x = xOf(it->time);
      const bool shown = it->judged && std::isfinite(it->indicator) && (curve.isEmpty() || x > curve.last().x() + 1.0);
      if (shown) curve << QPointF(x, row.bottom() - row.height() * std::abs(it->indicator) / full);
    }
    const bool goesOn = it != track.end() && !it->afterGap;
    const double right = goesOn ? xOf(it->time) : xOf((it - 1)->time) + 1.0;
    if (begin.judged) {
      const double high = row.height() * heightOf(begin);
      p.fillRect(QRectF(left, row.bottom() - high, right - left, high), colorOf(begin, theme()));
    } else {
      p.fillRect(QRectF(left, row.top(), right - left, row.height()), QBrush(theme().colors.hatch, Qt::BDiagPattern));
    }
  }
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(theme().colors.text, 1));  // thin lines are drawn directly, thick ones as polygons: see SpectrumPlot
  p.setBrush(Qt::NoBrush);
  for (const QPolygonF& curve : curves) {
    p.drawPolyline(curve);
    p.drawPolyline(curve.translated(0.0, 1.0));
  }
}

// Beside the row: its upper end.
void TrackPlot::drawScale(QPainter& p, const QRectF& row, double full) const {
  p.setFont(theme().font(type_size::kTick));
  const QFontMetrics metrics = p.fontMetrics();
  const double left = row.right() + theme().px(6), high = metrics.capHeight();
  p.setPen(theme().colors.secondary);
  p.drawLine(QPointF(row.right() + 1, row.top() + 0.5), QPointF(row.right() + theme().px(5), row.top() + 0.5));
  p.drawText(QPointF(left, row.top() + high), significant(full));
}

// As lines across, each for as long as it decided: the past was not judged by what is set now. The number is of
// today's.
void TrackPlot::drawLimit(QPainter& p, const QRectF& row, double full, double limit, std::size_t track) const {
  const auto heightAt = [&](double value) { return row.bottom() - row.height() * value / full; };
  const std::deque<Limit> always{{Instant::min(), limit}};
  const bool seen = track < limits_.size() && !limits_[track].empty() && limits_[track].back().value == limit;
  const std::deque<Limit>& known = seen ? limits_[track] : always;
  p.setPen(QPen(theme().colors.onsetText, 1, Qt::DashLine));
  for (std::size_t k = 0; k < known.size(); ++k) {
    if (!std::isfinite(known[k].value) || known[k].value > full) continue;
    const bool first = k == 0, last = k + 1 == known.size();
    const double from = first ? row.left() : std::max(row.left(), xOf(known[k].from));
    const double to = last ? row.right() + theme().px(5) : std::min(row.right(), xOf(known[k + 1].from));
    const double y = heightAt(known[k].value);
    if (to > from) p.drawLine(QPointF(from, y), QPointF(to, y));
  }
  if (!std::isfinite(limit) || limit > full) return;
  p.setFont(theme().font(type_size::kTick));
  const double high = p.fontMetrics().capHeight(), left = row.right() + theme().px(6), y = heightAt(limit);
  p.setPen(theme().colors.onsetText);
  if (y - row.top() > high + theme().px(3))
    p.drawText(QPointF(left, std::min(y + high / 2, row.bottom())), significant(limit));
}

// The indicator at each cursor, beside its line.
void TrackPlot::drawReadings(QPainter& p, const QRectF& row, const std::deque<TrackPoint>& track) const {
  for (const AnalyseView::Cursor c : {AnalyseView::A, AnalyseView::B}) {
    const auto t = view().cursor(c);
    if (!t || *t < view().from() || *t > view().to()) continue;
    const auto after = std::upper_bound(track.begin(), track.end(), *t,
                                        [](Instant at, const TrackPoint& point) { return at < point.time; });
    if (after == track.begin()) continue;
    const TrackPoint& point = *(after - 1);
    const QString text = number(point.judged ? static_cast<double>(point.indicator) : std::nan(""), 2);
    drawReading(p, row, *t, text);
  }
}

}  // namespace stillcut::ui
