#include "ui/report/plot_frame.h"

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/plots/nice_ticks.h"

namespace stillcut::ui {
namespace {

constexpr double kTickText = 10;
constexpr int kMostTimes = 12;

double stepOf(const std::vector<double>& ticks) {
  return ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
}

}  // namespace

void PlotFrame::drawGrid(QPainter& painter, const PageStyle& style, int mostTicks) const {
  painter.fillRect(inside_, style.colors().raised);
  painter.setPen(QPen(style.colors().track, 0.8));
  for (const double y : niceTicks(y_.from, y_.to, mostTicks)) {
    painter.drawLine(QPointF(inside_.left(), atY(y)), QPointF(inside_.right(), atY(y)));
  }
  for (const double x : niceTicks(x_.from, x_.to, kMostTimes)) {
    painter.drawLine(QPointF(atX(x), inside_.top()), QPointF(atX(x), inside_.bottom()));
  }
}

void PlotFrame::drawEdge(QPainter& painter, const PageStyle& style, const QString& title, int mostTicks,
                         bool times) const {
  const ThemeColors& colors = style.colors();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.border, 1.0));
  painter.drawRect(inside_);
  const QFont font = style.font(kTickText);
  const std::vector<double> ys = niceTicks(y_.from, y_.to, mostTicks);
  for (const double y : ys) {
    const QRectF place(inside_.left() - 56, atY(y) - 8, 50, 16);
    drawLine(painter, place, number(y, decimalsFor(stepOf(ys))), font, colors.secondary,
             Qt::AlignRight | Qt::AlignVCenter);
  }
  if (times) {
    const std::vector<double> xs = niceTicks(x_.from, x_.to, kMostTimes);
    for (const double x : xs) {
      const QRectF place(atX(x) - 40, inside_.bottom() + 3, 80, 14);
      drawLine(painter, place, number(x, decimalsFor(stepOf(xs))), font, colors.secondary,
               Qt::AlignHCenter | Qt::AlignTop);
    }
    drawLine(painter, QRectF(inside_.right() - 100, inside_.bottom() + 17, 100, 14), tr("time [s]"), font,
             colors.secondary, Qt::AlignRight | Qt::AlignTop);
  }
  drawLine(painter, QRectF(inside_.left(), inside_.top() - 17, inside_.width(), 15), title, style.font(11, true),
           colors.text);
}

}  // namespace stillcut::ui
