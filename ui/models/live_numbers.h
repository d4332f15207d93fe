// The words for what a detector sees: states, and the numbers it reports. GUI thread.
#pragma once

#include <QString>

#include "core/model/verdict.h"
#include "ui/facade/session_info.h"

namespace stillcut::ui {

QString stateText(CutState state);
// Of the names in DetectorInfo::indicators ("gamma_max"); an unknown one is shown as it is.
QString indicatorText(const QString& name);
// Not a number: it has no limit.
double limitOfIndicator(const QString& name, const LimitMarks& limits);

}  // namespace stillcut::ui
