// Speed and feed in absolute values, and the bars with their limits. GUI thread, pure functions.
#pragma once

#include <QString>
#include <vector>

#include "ui/base/theme.h"
#include "ui/facade/session_info.h"

namespace stillcut::ui {

struct OverrideRow {
  QString label, programmed, overridden, actual, unit;
  Tone tone = Tone::Normal;  // Advice: we have moved it
  bool old = false;          // the machine has not answered of late

  bool operator==(const OverrideRow&) const = default;
};

struct MachineView {
  OverrideRow speed, feed;
  // The operator's own knobs (speed, feed), with the feed per tooth where ours do not hold it; or what keeps the
  // overrides from working.
  QString note;
  bool warning = false;  // the note is about something that is wrong
  bool operator==(const MachineView&) const = default;
};

MachineView makeMachineView(const Picture& picture);

struct BarView {
  QString label, value;
  double fraction = 0.0;  // of the bar's length, 0..1
  bool known = false;
  std::vector<double> marks;  // limits, as fractions
  Tone tone = Tone::Normal;
  bool counts = true;     // what the verdict goes by; else it is only shown
  double without = -1.0;  // of the bar's length: what it would be without Stillcut; below 0: not known
  QString withoutText{};  // "without Stillcut 9.2 m/s2"
  QString full{};         // what the whole length stands for: "1", "20 m/s²"

  bool operator==(const BarView&) const = default;
};

// Full scale of the vibration bar: 1, 2 or 5 times a power of ten; it grows at once and never shrinks during a run.
class VibrationScale {
 public:
  double fullFor(double rms, double limit);

 private:
  double full_ = 0.0;
};

// Energy ratio, vibration, and coherence when that detector runs.
std::vector<BarView> makeBars(const Picture& picture, VibrationScale& scale);

}  // namespace stillcut::ui
