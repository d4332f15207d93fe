// Ticks with numbers along an axis of frequency, linear or logarithmic. GUI thread.
#pragma once

#include <QPainter>
#include <QRect>
#include <QString>

#include "ui/base/theme.h"
#include "ui/models/file/file_look.h"

namespace stillcut::ui {

// `per`: numbers for a hertz, as 1 / spindle for orders.
void drawFrequencyLeft(QPainter& p, const QRect& plot, const FrequencyScale& scale, double per, const QString& unit,
                       const Theme& theme);
void drawFrequencyBottom(QPainter& p, const QRect& plot, const FrequencyScale& scale, double per, const QString& unit,
                         const Theme& theme);

}  // namespace stillcut::ui
