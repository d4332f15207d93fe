#include "ui/plots/file/state_rows.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/format.h"

namespace stillcut::ui {
namespace {

double heightOf(const FileState& state) {
  switch (state.state) {
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

QColor colorOf(const FileState& state, const Theme& theme) {
  if (state.state == CutState::Chatter) return theme.back(Tone::Chatter);
  if (state.state == CutState::Onset) return theme.back(Tone::Onset);
  return theme.colors.fill;
}

// A ratio has a scale of one; what grows beyond has as much as it needs.
double fullScale(const FileCurve& curve) {
  double full = 1.0;
  for (const float value : curve.highest) {
    if (!std::isnan(value)) full = std::max(full, static_cast<double>(value));
  }
  return full;
}

}  // namespace

StateRows::StateRows(AnalyseView& view, QWidget* parent) : TimePlot(view, tr("STATES"), parent) {
  setLegend(tr("low: stable, half: onset, full: chatter, hatched: not judged; line: first indicator"));
}

void StateRows::display(std::vector<FileTrack> rows, int answering) {
  rows_ = std::move(rows);
  answering_ = answering;
  updateGeometry();
  update();
}

QSize StateRows::minimumSizeHint() const {
  return {theme().px(300), theme().px(static_cast<double>(56 + 20 * std::max<std::size_t>(rows_.size(), 4)))};
}

void StateRows::drawPlot(QPainter& p, const QRect& plot) {
  clipped_ = false;
  if (rows_.empty()) return;
  const double height = plot.height() / static_cast<double>(rows_.size()), gap = theme().px(3);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const QRectF row(plot.left(), plot.top() + height * static_cast<double>(k) + gap / 2, plot.width(), height - gap);
    p.save();
    p.setClipRect(row);
    p.setRenderHint(QPainter::Antialiasing, false);
    drawRow(p, row, rows_[k]);
    drawCurve(p, row, rows_[k].curve);
    p.restore();
    drawScale(p, row, rows_[k].curve);
    drawReadings(p, row, rows_[k].curve);
    const double room = theme().px(66);
    p.setPen(theme().colors.text);
    p.setFont(fitting(rows_[k].detector, static_cast<int>(k) == answering_, room));
    p.drawText(QRectF(plot.left() - room - theme().px(5), row.top(), room, row.height()),
               Qt::AlignRight | Qt::AlignVCenter,
               p.fontMetrics().elidedText(rows_[k].detector, Qt::ElideRight, int(room)));
  }
}

// Of several values at one pixel the largest.
void StateRows::drawCurve(QPainter& p, const QRectF& row, const FileCurve& curve) const {
  const auto values = static_cast<std::ptrdiff_t>(curve.highest.size());
  if (values == 0 || !(curve.step.value > 0.0)) return;
  const double full = fullScale(curve);
  const auto indexOf = [&](Instant t) {
    return std::clamp(static_cast<std::ptrdiff_t>(sinceEpoch(t).value / curve.step.value), std::ptrdiff_t{0}, values);
  };
  std::vector<QPolygonF> pieces(1);
  const std::ptrdiff_t end = std::min(indexOf(view().to()) + 2, values);
  for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(indexOf(view().from()) - 1, 0); k < end; ++k) {
    const float value = curve.highest[static_cast<std::size_t>(k)];
    if (std::isnan(value)) {
      if (!pieces.back().isEmpty()) pieces.emplace_back();
      continue;
    }
    const QPointF at(xOf(Instant{} + toDuration(curve.step * (static_cast<double>(k) + 0.5))),
                     row.bottom() - row.height() * value / full);
    QPolygonF& piece = pieces.back();
    if (!piece.isEmpty() && at.x() < piece.last().x() + 1.0) {
      piece.last().setY(std::min(piece.last().y(), at.y()));
    } else {
      piece << at;
    }
  }
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(theme().colors.text, 1));
  p.setBrush(Qt::NoBrush);
  for (const QPolygonF& piece : pieces) {
    p.drawPolyline(piece);
    p.drawPolyline(piece.translated(0.0, 1.0));
  }
}

// Beside the row its upper end; the limit as a line across.
void StateRows::drawScale(QPainter& p, const QRectF& row, const FileCurve& curve) const {
  if (curve.highest.empty()) return;
  const double full = fullScale(curve);
  p.setFont(theme().font(type_size::kTick));
  p.setPen(theme().colors.secondary);
  p.drawText(QPointF(row.right() + theme().px(6), row.top() + p.fontMetrics().capHeight()), significant(full));
  if (!std::isfinite(curve.limit) || curve.limit > full) return;
  const double y = row.bottom() - row.height() * curve.limit / full;
  p.setPen(QPen(theme().colors.onsetText, 1, Qt::DashLine));
  p.drawLine(QPointF(row.left(), y), QPointF(row.right() + theme().px(5), y));
}

void StateRows::drawReadings(QPainter& p, const QRectF& row, const FileCurve& curve) const {
  for (const AnalyseView::Cursor c : {AnalyseView::A, AnalyseView::B}) {
    const auto t = view().cursor(c);
    if (!t || *t < view().from() || *t > view().to() || !(curve.step.value > 0.0)) continue;
    const double index = std::floor(sinceEpoch(*t).value / curve.step.value);
    if (!(index >= 0.0) || index >= static_cast<double>(curve.highest.size())) continue;
    const float value = curve.highest[static_cast<std::size_t>(index)];
    if (!std::isnan(value)) drawReading(p, row, *t, significant(value));
  }
}

// The largest type in which the whole name fits.
QFont StateRows::fitting(const QString& name, bool bold, double room) {
  QFont font;
  for (int halves = static_cast<int>(2.0 * type_size::kTick); halves * theme().text > 17.0; --halves) {
    font = theme().font(0.5 * halves, bold);
    if (QFontMetricsF(font).horizontalAdvance(name) <= room) return font;
  }
  clipped_ = QFontMetricsF(font).horizontalAdvance(name) > room;
  return font;
}

void StateRows::drawRow(QPainter& p, const QRectF& row, const FileTrack& track) const {
  const auto from = sinceEpoch(view().from()), to = sinceEpoch(view().to());
  const auto first = std::lower_bound(track.states.begin(), track.states.end(), from,
                                      [](const FileState& state, Seconds t) { return state.end < t; });
  for (auto it = first; it != track.states.end() && it->begin < to; ++it) {
    const double left = xOf(Instant{} + toDuration(it->begin));
    // An alarm of a block in an hour is seen.
    const double right = std::max(xOf(Instant{} + toDuration(it->end)), left + 1.0);
    if (!it->judged) {
      p.fillRect(QRectF(left, row.top(), right - left, row.height()), QBrush(theme().colors.hatch, Qt::BDiagPattern));
      continue;
    }
    const double high = row.height() * heightOf(*it);
    p.fillRect(QRectF(left, row.bottom() - high, right - left, high), colorOf(*it, theme()));
  }
}

}  // namespace stillcut::ui
