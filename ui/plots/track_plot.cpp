#include "ui/plots/track_plot.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace stillcut::ui {
namespace {

// The state is told by height as well as by colour: nothing, low, half, full.
double heightOf(const TrackPoint& point) {
  if (!point.valid) return 0.0;
  switch (point.state) {
    case CutState::Air:
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

}  // namespace

TrackPlot::TrackPlot(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("DETECTORS"), parent) {
  setToolTip(tr("Low: stable. Half: onset. Full: chatter. Hatched: no verdict. The line is the first indicator."));
}

void TrackPlot::display(const RunHistory* history, const QStringList& names, int inCharge) {
  history_ = history;
  names_ = names;
  inCharge_ = inCharge;
  update();
}

QSize TrackPlot::minimumSizeHint() const {
  return {theme().px(420), theme().px(static_cast<double>(60 + 26 * std::max<qsizetype>(names_.size(), 1)))};
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
    drawTrack(p, row, tracks[k]);
    p.restore();
    p.setPen(theme().colors.text);
    const QString name = names_.value(static_cast<qsizetype>(k));
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
  for (double size = type_size::kTick; size > 9.0; size -= 0.5) {
    font = theme().font(size, bold);
    widest = 0.0;
    for (const QString& word : words) widest = std::max(widest, QFontMetricsF(font).horizontalAdvance(word));
    if (widest <= room) break;
  }
  clipped_ = clipped_ || widest > room;
  return font;
}

void TrackPlot::drawTrack(QPainter& p, const QRectF& row, const std::deque<TrackPoint>& track) const {
  if (track.empty()) return;
  double largest = 1.0;
  for (const TrackPoint& point : track) {
    if (point.valid && std::isfinite(point.indicator))
      largest = std::max(largest, std::abs(static_cast<double>(point.indicator)));
  }
  const auto first = std::lower_bound(track.begin(), track.end(), view().from(),
                                      [](const TrackPoint& point, Instant t) { return point.time < t; });
  QPolygonF curve;
  p.setRenderHint(QPainter::Antialiasing, false);
  for (auto it = first == track.begin() ? first : first - 1; it != track.end() && it->time <= view().to();) {
    const TrackPoint& begin = *it;
    const double left = xOf(begin.time);
    // One rectangle for a whole run of the same state; of the curve one point for each pixel.
    for (; it != track.end() && it->time <= view().to() && it->valid == begin.valid && it->state == begin.state; ++it) {
      const double x = xOf(it->time);
      const bool shown = it->valid && std::isfinite(it->indicator) && (curve.isEmpty() || x > curve.last().x() + 1.0);
      if (shown) curve << QPointF(x, row.bottom() - row.height() * std::abs(it->indicator) / largest);
    }
    const double right = it != track.end() ? xOf(it->time) : xOf(track.back().time) + 1.0;
    if (begin.valid) {
      const double high = row.height() * heightOf(begin);
      p.fillRect(QRectF(left, row.bottom() - high, right - left, high), colorOf(begin, theme()));
    } else {
      p.fillRect(QRectF(left, row.top(), right - left, row.height()), QBrush(theme().colors.hatch, Qt::BDiagPattern));
    }
  }
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(theme().colors.text, 1));  // thin lines are drawn directly, thick ones as polygons: see SpectrumPlot
  p.setBrush(Qt::NoBrush);
  p.drawPolyline(curve);
  p.drawPolyline(curve.translated(0.0, 1.0));
}

}  // namespace stillcut::ui
