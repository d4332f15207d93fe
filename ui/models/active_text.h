// What the active work-holder is doing, as sentences: what it has earned on each line, how much of its stroke it uses,
// why it let go, and how good and how old the model of its path is. Pure functions, GUI thread.
#pragma once

#include <QString>
#include <QStringList>

#include "core/model/active_state.h"
#include "ui/base/theme.h"

namespace stillcut::ui {

struct ActiveAxisView {
  QString state;  // "on", "let go: the loop diverged"
  Tone tone = Tone::Normal;
  QString stroke;     // "stroke 42 %, limited 0 %"
  QStringList lines;  // "1 024 Hz  -24.9 dB"; empty: nothing known yet
  QString model;      // residual, phase left, delay, age; or that there is none
  bool modelSound = false;
  bool operator==(const ActiveAxisView&) const = default;
};

struct ActiveTableView {
  QString text;
  Tone tone = Tone::Normal;
  QString fault;  // a sentence; empty: none
  bool operator==(const ActiveTableView&) const = default;
};

ActiveAxisView makeActiveAxis(const ActiveSnapshot& snapshot, int axis);
QString activeReleaseText(ActuatorRelease why);
// Both axes in a few words for every page: "x 42 %, y 30 %" of the stroke while it moves; that of an axis that let go
// by itself goes before.
ActiveTableView makeActiveTable(const ActiveSnapshot& snapshot);
// The device: rate, block, loop's lost blocks; or how far the identification is.
QString activeDeviceText(const ActiveSnapshot& snapshot, const QString& device);

}  // namespace stillcut::ui
