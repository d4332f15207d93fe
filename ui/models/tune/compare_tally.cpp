#include "ui/models/tune/compare_tally.h"

#include "ui/base/format.h"
#include "ui/base/say.h"

namespace stillcut::ui {

QString tallyText(const SideTally& tally) {
  if (!(tally.inForce.value > 0.0)) return say("not tried yet");
  return say("%1 active, alarms: %2, in alarm %3, energy ratio to %4")
      .arg(duration(tally.inForce))
      .arg(tally.alarms)
      .arg(duration(tally.alarming), significant(tally.highest));
}

}  // namespace stillcut::ui
