#include "ui/plots/axis_painter.h"

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/plots/nice_ticks.h"

namespace stillcut::ui {
namespace {

QString label(double value, int decimals, bool first, const QString& unit) {
  const QString text = number(value, decimals);
  return first && !unit.isEmpty() ? join(text, unit) : text;
}

int decimalsOf(const std::vector<double>& ticks) {
  return ticks.size() > 1 ? decimalsFor(ticks[1] - ticks[0]) : 0;
}

std::vector<double> leftTicks(int plotHeight, const AxisRange& range, const Theme& theme) {
  return niceTicks(range.low, range.high, std::max(plotHeight / theme.px(30), 3));
}

}  // namespace

int leftAxisWidth(int plotHeight, const AxisRange& range, const QString& unit, const Theme& theme) {
  const QFontMetrics metrics(theme.font(type_size::kTick));
  const std::vector<double> ticks = leftTicks(plotHeight, range, theme);
  int widest = 0;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    widest = std::max(widest, metrics.horizontalAdvance(label(ticks[k], decimalsOf(ticks), k == 0, unit)));
  }
  return widest + theme.px(14);
}

void drawLeftAxis(QPainter& p, const QRect& plot, const AxisRange& range, const QString& unit, const Theme& theme) {
  p.setFont(theme.font(type_size::kTick));
  const QFontMetrics metrics = p.fontMetrics();
  p.setPen(theme.colors.secondary);
  const std::vector<double> ticks = leftTicks(plot.height(), range, theme);
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    const int y = static_cast<int>(std::lround(plot.bottom() + 1 - range.place(ticks[k]) * plot.height()));
    p.drawLine(plot.left() - theme.px(5), y, plot.left() - 1, y);
    const QString text = label(ticks[k], decimalsOf(ticks), k == 0, unit);
    const int lowest = plot.bottom() + metrics.capHeight() / 2;
    p.drawText(plot.left() - theme.px(9) - metrics.horizontalAdvance(text),
               std::clamp(y + metrics.capHeight() / 2, plot.top() + metrics.capHeight(), lowest), text);
  }
}

void drawBottomAxis(QPainter& p, const QRect& plot, const AxisRange& range, const QString& unit, const Theme& theme) {
  p.setFont(theme.font(type_size::kTick));
  const QFontMetrics metrics = p.fontMetrics();
  p.setPen(theme.colors.secondary);
  const std::vector<double> ticks = niceTicks(range.low, range.high, std::max(plot.width() / theme.px(80), 1));
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    const int x = static_cast<int>(std::lround(plot.left() + range.place(ticks[k]) * plot.width()));
    p.drawLine(x, plot.bottom() + 1, x, plot.bottom() + theme.px(5));
    const QString text = label(ticks[k], decimalsOf(ticks), k == 0, unit);
    const int width = metrics.horizontalAdvance(text);
    p.drawText(std::clamp(x - width / 2, plot.left() - theme.px(8), plot.right() + theme.px(8) - width),
               plot.bottom() + theme.px(8) + metrics.ascent(), text);
  }
}

}  // namespace stillcut::ui
