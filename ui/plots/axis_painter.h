// Ticks with numbers along the left and the lower edge of a plot. GUI thread.
#pragma once

#include <QPainter>
#include <QRect>
#include <QString>

#include "ui/base/theme.h"

namespace stillcut::ui {

struct AxisRange {
  double low = 0.0, high = 1.0;
  double place(double value) const { return (value - low) / (high - low); }
};

// Numbers right-aligned left of the plot; the lowest carries the unit.
void drawLeftAxis(QPainter& p, const QRect& plot, const AxisRange& range, const QString& unit, const Theme& theme);
// What the widest of its numbers takes left of a plot of that height, ticks and air with it.
int leftAxisWidth(int plotHeight, const AxisRange& range, const QString& unit, const Theme& theme);
void drawBottomAxis(QPainter& p, const QRect& plot, const AxisRange& range, const QString& unit, const Theme& theme);

}  // namespace stillcut::ui
