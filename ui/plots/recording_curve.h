// What a timeline reads out of a recording's summary. GUI thread, pure functions.
#pragma once

#include <QString>
#include <vector>

#include "core/model/session_summary.h"
#include "ui/facade/session_controller.h"

namespace stillcut::ui {

// Highest vibration, in vibrationUnit().
double loudest(const SessionSummary& summary);
// SI unit of the first channel; empty where there is none.
QString vibrationUnit(const SessionSummary& summary);
// Where onset or chatter was recorded, from the first sample.
std::vector<AlarmSpan> recordedAlarms(const SessionSummary& summary);

}  // namespace stillcut::ui
