// The frame of one curve: scales, grid, numbers and a title. What is inside is drawn by others. GUI thread.
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QRectF>
#include <QString>

#include "ui/report/page_style.h"

namespace stillcut::ui {

struct PlotScale {
  double from = 0.0;
  double to = 1.0;
};

class PlotFrame {
  Q_DECLARE_TR_FUNCTIONS(PlotFrame)

 public:
  // `inside` is the area of the curve; numbers stand left of it and below it.
  PlotFrame(const QRectF& inside, PlotScale x, PlotScale y) : inside_(inside), x_(x), y_(y) {}

  const QRectF& inside() const { return inside_; }
  double atX(double value) const { return inside_.left() + (value - x_.from) / (x_.to - x_.from) * inside_.width(); }
  double atY(double value) const { return inside_.bottom() - (value - y_.from) / (y_.to - y_.from) * inside_.height(); }

  void drawGrid(QPainter& painter, const PageStyle& style, int mostTicks) const;
  // On top of what was drawn inside: edge, numbers (times only where asked for) and title.
  void drawEdge(QPainter& painter, const PageStyle& style, const QString& title, int mostTicks, bool times) const;

 private:
  QRectF inside_;
  PlotScale x_, y_;
};

}  // namespace stillcut::ui
