// stillcut --report RECORDING OUT: a report (.pdf) or the plots (.png, .svg) of a recording, without a display.
#pragma once

#include <QSize>
#include <QStringList>

#include "core/base/result.h"

namespace stillcut::app {

// True where the command line asks for it: then no window is made, and no display is needed.
bool asksForReport(int argc, char** argv);

// `files`: the recording, and what to write. Runs under a QGuiApplication or QApplication.
Status makeReport(const QStringList& files, QSize pictureSize);

}  // namespace stillcut::app
