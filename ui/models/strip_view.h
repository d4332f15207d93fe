// The status strip, the authority line and the intervention cards as values. GUI thread, pure functions.
#pragma once

#include <QString>
#include <vector>

#include "ui/models/session_info.h"
#include "ui/models/theme.h"

namespace stillcut::ui {

struct StripItem {
  QString label, value;
  Tone tone = Tone::Normal;
  bool operator==(const StripItem&) const = default;
};

std::vector<StripItem> makeStrip(const Picture& picture);

struct CommandView {
  Authority authority = Authority::Off;
  QString inCommand;  // "You are in command"
  QString since;      // "since 14:00:03"
  bool live = false;  // touches reach a session
  bool autoAllowed = false;
  bool autoNeedsSecondTouch = false;
  bool held = false;
  QString moved;  // "speed 97 %, feed 97 %" while the overrides are not 100 %
  bool operator==(const CommandView&) const = default;
};

CommandView makeCommandView(const Picture& picture);

struct CardView {
  quint64 number = 0;
  QString time, headline;
  QString speed, ratio, vibration;  // "8 800 -> 8 565 rpm" with a true arrow
  QString cost;                     // "time +21 %"; empty: none
  Tone tone = Tone::Normal;
  bool operator==(const CardView&) const = default;
};

// Newest first.
std::vector<CardView> makeCards(const Picture& picture);

// The newest thing that went wrong and what became of it, for half a minute; of the active table as long as it stays
// off; alarms are told by the verdict.
struct EventLine {
  QString text;  // "14:00:03  The machine has not answered for 1.2 s"; empty: nothing
  Tone tone = Tone::Normal;
  bool operator==(const EventLine&) const = default;
};

EventLine makeEventLine(const Picture& picture);

}  // namespace stillcut::ui
