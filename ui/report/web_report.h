// A summary as one page of HTML: what stands in the pages of paper, without scripts and without anything to fetch. GUI
// thread, pure.
#pragma once

#include <QString>

#include "core/model/session_summary.h"
#include "ui/base/units.h"

namespace stillcut::ui {

// `plots`: an <svg> element.
QString webReport(const SessionSummary& summary, const QString& plots, UnitSystem units);

}  // namespace stillcut::ui
