#include "ui/plots/file/frequency_axis.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/base/format.h"
#include "ui/plots/axis_painter.h"

namespace stillcut::ui {
namespace {

// 1, 2 and 5 times the powers of ten; `most` is met by leaving out 5 and 2.
std::vector<double> logTicks(double low, double high, int most) {
  std::vector<double> ticks;
  for (const std::size_t leads : {3U, 1U}) {
    ticks.clear();
    for (double decade = std::pow(10.0, std::floor(std::log10(low))); decade <= high; decade *= 10.0) {
      for (std::size_t k = 0; k < leads; ++k) {
        const double tick = decade * (k == 0 ? 1.0 : k == 1 ? 2.0 : 5.0);
        if (tick >= low && tick <= high) ticks.push_back(tick);
      }
    }
    if (static_cast<int>(ticks.size()) <= most) break;
  }
  return ticks;
}

QString label(double tick, bool first, const QString& unit) {
  const QString text = tick < 1.0 ? number(tick, 2) : number(tick);
  return first ? join(text, unit) : text;
}

}  // namespace

void drawFrequencyLeft(QPainter& p, const QRect& plot, const FrequencyScale& scale, double per, const QString& unit,
                       const Theme& theme) {
  if (!scale.log()) return drawLeftAxis(p, plot, {scale.low() * per, scale.high() * per}, unit, theme);
  p.setFont(theme.font(type_size::kTick));
  p.setPen(theme.colors.secondary);
  const QFontMetrics metrics = p.fontMetrics();
  bool first = true;
  for (const double tick : logTicks(scale.low() * per, scale.high() * per, std::max(plot.height() / theme.px(24), 3))) {
    const double y = plot.bottom() + 1 - scale.placeOf(tick / per) * plot.height();
    p.drawLine(QPointF(plot.left() - theme.px(5), y), QPointF(plot.left() - 1, y));
    const QString text = label(tick, first, unit);
    first = false;
    const double baseline = std::clamp<double>(y + metrics.capHeight() / 2.0, plot.top() + metrics.capHeight(),
                                               plot.bottom() + metrics.capHeight() / 2.0);
    p.drawText(QPointF(plot.left() - theme.px(9) - metrics.horizontalAdvance(text), baseline), text);
  }
}

void drawFrequencyBottom(QPainter& p, const QRect& plot, const FrequencyScale& scale, double per, const QString& unit,
                         const Theme& theme) {
  if (!scale.log()) return drawBottomAxis(p, plot, {scale.low() * per, scale.high() * per}, unit, theme);
  p.setFont(theme.font(type_size::kTick));
  p.setPen(theme.colors.secondary);
  const QFontMetrics metrics = p.fontMetrics();
  bool first = true;
  for (const double tick : logTicks(scale.low() * per, scale.high() * per, std::max(plot.width() / theme.px(56), 2))) {
    const double x = plot.left() + scale.placeOf(tick / per) * plot.width();
    p.drawLine(QPointF(x, plot.bottom() + 1), QPointF(x, plot.bottom() + theme.px(5)));
    const QString text = label(tick, first, unit);
    first = false;
    const double w = metrics.horizontalAdvance(text);
    p.drawText(QPointF(std::clamp(x - w / 2.0, plot.left() - 8.0, plot.right() + 8.0 - w),
                       plot.bottom() + theme.px(8) + metrics.ascent()),
               text);
  }
}

}  // namespace stillcut::ui
