// A whole session on one time axis: what the detectors said, the spectrogram, the vibration, the energy ratio and the
// spindle speed, with our moves marked in all of them. The same drawing goes to PDF, PNG and SVG. GUI thread.
#pragma once

#include <QPainter>
#include <QRectF>

#include "core/model/session_summary.h"
#include "ui/report/page_style.h"

namespace stillcut::ui {

// Fills `area`, which wants a width of 600 and a height of 420 at least [1/96 inch].
void drawSessionPlots(QPainter& painter, const QRectF& area, const SessionSummary& summary, const PageStyle& style);

}  // namespace stillcut::ui
