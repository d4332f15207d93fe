#include "ui/widgets/painting.h"

#include <QFontMetricsF>
#include <QScreen>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace stillcut::ui {

int pixelsFor(double mm, const QWidget* widget) {
  const double logical = widget->logicalDpiY();
  // Screens that report no size or a wild one are taken at their logical density.
  const double physical = std::clamp<double>(widget->physicalDpiY(), logical, 2.0 * logical);
  return static_cast<int>(std::ceil(mm / 25.4 * physical));
}

int touchHeight(const Theme& theme, const QWidget* widget, double base) {
  return std::max(theme.px(base), pixelsFor(kTouchMm, widget));
}

void drawPanel(QPainter& p, const QRectF& rect, const Theme& theme, const QColor& back) {
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(QPen(back == theme.colors.panel ? theme.colors.border : back, 1.0));
  p.setBrush(back);
  p.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), theme.px(6), theme.px(6));
  p.restore();
}

double capHeight(const Theme& theme, double size, bool bold) {
  return QFontMetricsF(theme.font(size, bold)).capHeight();
}

namespace {

// Where there is no room for larger text it stays as small as it would be without.
double leastShare(const Theme& theme, const TextStyle& style) {
  return style.smallest * theme.px(style.size) / theme.textPx(style.size);
}

}  // namespace

QFont TextPainter::fit(double width, const QString& text, const TextStyle& style) {
  const double least = leastShare(theme_, style);
  const int smallest = static_cast<int>(std::lround(least * 100));
  for (int percent = 100; percent > smallest; percent -= 2) {
    const QFont font = theme_.font(style.size, style.bold, percent / 100.0);
    if (QFontMetricsF(font).horizontalAdvance(text) <= width) return font;
  }
  const QFont font = theme_.font(style.size, style.bold, least);
  if (QFontMetricsF(font).horizontalAdvance(text) > width) clipped_ = true;
  return font;
}

double TextPainter::line(double left, double top, double width, const QString& text, const TextStyle& style) {
  const double height = capHeight(theme_, style.size, style.bold);
  centred(QRectF(left, top, width, height), text, style);
  return top + height;
}

void TextPainter::centred(const QRectF& box, const QString& text, const TextStyle& style) {
  if (text.isEmpty()) return;
  const QFont font = fit(box.width(), text, style);
  const QFontMetricsF metrics(font);
  const bool whole = metrics.horizontalAdvance(text) <= box.width();
  const QString shown = whole ? text : metrics.elidedText(text, Qt::ElideRight, box.width());
  const double advance = metrics.horizontalAdvance(shown);
  double x = box.left();
  if (style.align & Qt::AlignRight) x = box.right() - advance;
  if (style.align & Qt::AlignHCenter) x = box.center().x() - advance / 2.0;
  p_.setFont(font);
  p_.setPen(style.color);
  p_.drawText(QPointF(x, box.center().y() + metrics.capHeight() / 2.0), shown);
}

double TextPainter::block(const QRectF& box, const QString& text, const TextStyle& style) {
  if (text.isEmpty()) return box.top();
  const int flags = Qt::TextWordWrap | static_cast<int>(style.align) | Qt::AlignTop;
  const double least = leastShare(theme_, style);
  for (double share = 1.0;; share -= 0.04) {
    const QFont font = theme_.font(style.size, style.bold, std::max(share, least));
    const QRectF needed =
        QFontMetricsF(font).boundingRect(QRectF(box.left(), box.top(), box.width(), 1e4), flags, text);
    const bool fits = needed.height() <= box.height() + 1.0 && needed.width() <= box.width() + 1.0;
    if (!fits && share > least) continue;
    clipped_ = clipped_ || !fits;
    p_.setFont(font);
    p_.setPen(style.color);
    p_.drawText(box, flags, text);
    return box.top() + needed.height();
  }
}

}  // namespace stillcut::ui
