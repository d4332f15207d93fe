// What the sensors deliver, as sentences: each channel's level and whether it can be believed, and the rate the device
// really keeps. Pure function, GUI thread.
#pragma once

#include <QStringList>

#include "ui/facade/session_info.h"

namespace stillcut::ui {

struct SensorView {
  QString headline;      // the sensors as a whole
  bool sick = false;     // and whether something is wrong with them
  QStringList channels;  // "x  3.1 m/s², peak 12 m/s²", one line each
  QStringList findings;  // "x: delivers a constant"; empty: every channel can be believed
  QString rate;          // told and measured, and what was lost
  bool operator==(const SensorView&) const = default;
};

SensorView makeSensorView(const Picture& picture);

}  // namespace stillcut::ui
