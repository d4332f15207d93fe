// The shape of a verdict, so that colour never speaks alone: ring, circle, triangle, octagon.
#pragma once

#include <QPainter>

#include "ui/base/theme.h"
#include "ui/models/verdict_view.h"

namespace stillcut::ui {

// In `front` on a surface of `back`.
void drawVerdictShape(QPainter& p, const QRectF& box, Shape shape, const Theme& theme, const QColor& front,
                      const QColor& back);

}  // namespace stillcut::ui
