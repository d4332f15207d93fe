#include "ui/models/live_numbers.h"

#include <array>
#include <limits>

#include "ui/base/say.h"

namespace stillcut::ui {

QString stateText(CutState state) {
  switch (state) {
    case CutState::AirCutting:
      return say("no cut");
    case CutState::Stable:
      return say("stable");
    case CutState::Onset:
      return say("onset");
    case CutState::Chatter:
      return say("chatter");
  }
  return {};
}

QString indicatorText(const QString& name) {
  struct Word {
    const char* name;
    QString text;
  };
  const std::array words{Word{"er", say("energy ratio")},
                         Word{"frequency_hz", say("frequency [Hz]")},
                         Word{"changed", say("changes from turn to turn")},
                         Word{"floor", say("learned noise floor")},
                         Word{"evidence", say("evidence of growth")},
                         Word{"purity", say("purity of the line")},
                         Word{"gamma_max", say("coherence")},
                         Word{"energy", say("vibration energy")},
                         Word{"lead_s", say("warned ahead by [s]")},
                         Word{"variance", say("noise variance")},
                         Word{"h", say("perturbation power")},
                         Word{"root", say("largest root")},
                         Word{"part", say("part outside the harmonics")},
                         Word{"peak", say("highest line")}};
  for (const Word& word : words) {
    if (name == QLatin1String(word.name)) return word.text;
  }
  return name;
}

double limitOfIndicator(const QString& name, const LimitMarks& limits) {
  if (name == QLatin1String("er")) return limits.energyRatio;
  if (name == QLatin1String("gamma_max")) return limits.coherence;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace stillcut::ui
