// What the Tap test page says: what to do now, what became of each hit, the modes, and what follows from them.
// GUI thread; pure functions.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "ui/base/theme.h"
#include "ui/base/units.h"
#include "ui/facade/tap_controller.h"
#include "ui/models/machine_view.h"
#include "ui/models/tap/tick_table.h"

namespace stillcut::ui {

// In large letters, and what stands below it.
struct TapSign {
  QString text, detail;
  Tone tone = Tone::Normal;
};
TapSign tapSign(const TapController& controller);

// A question and an example of its answer.
struct TapQuestionText {
  QString asked, example;
};
TapQuestionText tapQuestion(TapQuestion question);

QString tapFaultText(TapFault fault);
QStringList hitHeader(bool withForce);
std::vector<TickRow> hitRows(const std::vector<TapHitRow>& hits, bool withForce);

QStringList modeHeader(bool withForce);
std::vector<TickRow> modeRows(const TapResponse& response);

// The level of one channel on a scale that grows by 1, 2, 5.
BarView tapMeter(const TapChannel& channel);

// What is recommended, in large letters and below them.
TapSign tapAnswer(const TapLobes& lobes, UnitSystem units);

}  // namespace stillcut::ui
