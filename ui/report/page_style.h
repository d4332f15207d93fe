// Type and colours of everything on paper: the light theme, in units of 1/96 inch. GUI thread.
#pragma once

#include <QPainter>
#include <QString>

#include "ui/base/theme.h"

namespace stillcut::ui {

class PageStyle {
 public:
  PageStyle() : theme_(makeTheme(ThemeKind::Light, 1.0)) {}

  const ThemeColors& colors() const { return theme_.colors; }
  const Theme& theme() const { return theme_; }
  // Without hinting: widths on paper are those of the design, whatever the resolution.
  QFont font(double size, bool bold = false) const;

 private:
  Theme theme_;
};

// One line of text inside `area`, cut with an ellipsis where it is too long.
void drawLine(QPainter& painter, const QRectF& area, const QString& text, const QFont& font, const QColor& color,
              Qt::Alignment align = Qt::AlignLeft | Qt::AlignVCenter);
// Words over as many lines as needed from the top of `area`; returns the height they took.
double drawWords(QPainter& painter, const QRectF& area, const QString& text, const QFont& font, const QColor& color);

}  // namespace stillcut::ui
