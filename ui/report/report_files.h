// A summary on paper and as a picture. The files appear only when they are complete. GUI thread.
#pragma once

#include <QSize>
#include <QString>

#include "core/base/result.h"
#include "core/model/session_summary.h"
#include "ui/base/units.h"

namespace stillcut::ui {

// A4, as many pages as needed: what was cut, what happened, the plots; interventions with before and after,
// markers, events; sensor check and settings.
Status writeReport(const SessionSummary& summary, const QString& path, UnitSystem units);

// The same content for a browser: one file, the plots inside it as a drawing.
Status writeWebReport(const SessionSummary& summary, const QString& path, UnitSystem units);

// The plots alone; .png or .svg by the suffix. `size` in pixels.
Status writePicture(const SessionSummary& summary, const QString& path, QSize size);

// A report (.pdf, .html) or the plots, by the suffix; a picture in a size for a page of text.
Status writeByName(const SessionSummary& summary, const QString& path, UnitSystem units);

}  // namespace stillcut::ui
