// stillcut --report RECORDING OUT: a report (.pdf) or the plots (.png, .svg) of a recording, without a display.
#pragma once

#include <QSize>
#include <QStringList>

#include "core/base/result.h"
#include "ui/base/units.h"

namespace stillcut::app {

// `files`: the recording, and what to write, with its lengths and feeds in `units`. Runs under a QGuiApplication or
// QApplication.
Status makeReport(const QStringList& files, QSize pictureSize, ui::UnitSystem units);

}  // namespace stillcut::app
