// What a report says in words and tables, lengths and feeds in the units of the screen: pure functions of the summary.
// GUI thread.
#pragma once

#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

#include "core/model/session_summary.h"
#include "ui/base/units.h"
#include "ui/report/table.h"

namespace stillcut::ui {

using Facts = std::vector<std::pair<QString, QString>>;

Facts cutFacts(const SessionSummary& summary, UnitSystem units);
// Was there chatter, what was done, what became of it; and what the detectors say of it now, where they were asked.
QString whatHappened(const SessionSummary& summary, UnitSystem units);
Tone whatHappenedTone(const SessionSummary& summary);

std::vector<TableColumn> interventionColumns(UnitSystem units);
std::vector<TableRow> interventionRows(const SessionSummary& summary, UnitSystem units);
std::vector<TableColumn> sensorColumns();
std::vector<TableRow> sensorRows(const SessionSummary& summary);
std::vector<TableColumn> eventColumns();
std::vector<TableRow> eventRows(const SessionSummary& summary);
// What people have marked, during the cut and afterwards.
std::vector<TableColumn> markerColumns();
std::vector<TableRow> markerRows(const SessionSummary& summary);
// Parameters that were set during the cut.
std::vector<TableColumn> changeColumns();
std::vector<TableRow> changeRows(const SessionSummary& summary);
// The configuration it began with, one setting a line, under the names of its tables.
QStringList settingLines(const SessionSummary& summary);

}  // namespace stillcut::ui
