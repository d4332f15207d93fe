// The spectrogram of a whole recording, with chatter marks, gaps and the scale of its colours. GUI thread.
#pragma once

#include <QImage>
#include <QPainter>
#include <QRectF>

#include "core/model/session_summary.h"
#include "ui/report/page_style.h"

namespace stillcut::ui {

// Levels that the palette spans: from the noise floor to the strongest line [dB].
struct LevelSpan {
  double low = -80.0;
  double high = 0.0;
};
LevelSpan levelSpan(const SessionSummary& summary);

// Up to where there is something to see: nearly all of the power, and chatter with its first harmonics.
Hertz visibleTop(const SessionSummary& summary);

// One pixel a column and a bin from 0 to `top`, low frequencies at the bottom; null without columns.
QImage spectrogramImage(const SessionSummary& summary, Hertz top, const LevelSpan& levels, QRgb gap);

// Into `inside`, with the scale of levels to its right (50 wide).
void drawSpectrogram(QPainter& painter, const QRectF& inside, const SessionSummary& summary, Hertz top,
                     const PageStyle& style);

}  // namespace stillcut::ui
