// The status strip, the authority line and the intervention cards as values. GUI thread, pure functions.
#pragma once

#include <QString>
#include <vector>

#include "ui/base/theme.h"
#include "ui/facade/session_info.h"
#include "ui/models/alarm_marks.h"
#include "ui/models/verdict_view.h"

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
  bool kept = false;  // this program's death alone leaves nothing standing
  bool held = false;
  QString moved;            // "97 %, 97 %", speed and feed, while the overrides are not 100 %
  bool notYetBack = false;  // what was released has not been read back
  bool over = false;        // nothing more will come: nobody advises any more
  bool machine = false;     // there is one that could be moved
  // For the pages that do not show them large.
  VerdictView verdict;
  QString advice;  // "8 565 rpm" that waits for an answer; empty: none
  std::uint32_t adviceNumber = 0;
  bool operator==(const CommandView&) const = default;
};

CommandView makeCommandView(const Picture& picture);

struct CardView {
  quint64 number = 0;
  QString time, headline;
  QString speed, ratio;  // "8 800 -> 8 565 rpm" with a true arrow
  QString cost;          // "time +21 %"; empty: none
  QString vibration;     // of the newest: before and after, and what became of the chatter
  Tone tone = Tone::Normal;
  bool operator==(const CardView&) const = default;
};

// What a judgement is of, whether or not it has a card.
struct NewestAlarm {
  quint64 count = 0;  // alarms so far
  QString time;       // "14:00:03"; empty: there was none
  Instant began{};
  AlarmJudgement judged = AlarmJudgement::None;
  bool operator==(const NewestAlarm&) const = default;
};

NewestAlarm makeNewestAlarm(const Picture& picture);

// Newest first, of those that are worth one.
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
