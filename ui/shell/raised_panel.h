// How a panel looks that lies above the page for a while. Thread: GUI.
#pragma once

#include <QPainter>

#include "ui/widgets/painting.h"

namespace stillcut::ui {

inline void drawRaised(QPainter& p, const QRectF& rect, const Theme& theme) {
  drawPanel(p, rect, theme, theme.colors.raised);
  p.setPen(QPen(theme.colors.secondary, 1.5));
  p.setBrush(Qt::NoBrush);
  p.drawRoundedRect(rect.adjusted(1, 1, -1, -1), theme.px(6), theme.px(6));
}

}  // namespace stillcut::ui
