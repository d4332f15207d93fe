// The signs of the stability diagram: where the cut is, what is asked, what is advised, and what they mean, in one row
// above the plot. GUI thread, while a chart is painted.
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QPolygonF>

#include "core/base/units.h"
#include "ui/base/theme.h"

namespace stillcut::ui {

inline constexpr double kLobeLegend = 26.0;  // height of the row above the plot, before scaling

// Points of a regular shape of this many corners, one of them or an edge up.
QPolygonF cornered(const QPointF& centre, double radius, int corners);

class LobeMarks {
  Q_DECLARE_TR_FUNCTIONS(LobeMarks)

 public:
  // `plot`: the area inside the axes. All outlive this.
  LobeMarks(QPainter& painter, const Theme& theme, const QRectF& plot) : p_(painter), theme_(theme), plot_(plot) {}

  void cross(const QPointF& at) const;
  void ring(const QPointF& at) const;
  // From where the cut is to `target` on the axis of speeds.
  void advice(const QPointF& at, double target, Rpm speed) const;
  // False: it does not fit.
  bool legend() const;

 private:
  QPainter& p_;
  const Theme& theme_;
  QRectF plot_;
};

}  // namespace stillcut::ui
