// What happened in a run, to be read afterwards: every event, every move of speed and feed with who made it and why,
// and the machine's numbers over time. Of a run it is fed with every snapshot; of a recording it is made from its
// summary. Plain values, GUI thread.
#pragma once

#include <QString>
#include <deque>
#include <vector>

#include "core/model/session_summary.h"
#include "ui/base/units.h"

namespace stillcut::ui {

struct RunEvent {
  enum class What {
    Event,        // what core says: `reason`
    OurMove,      // the overrides that Stillcut asks for were moved: speed in rpm from `before` to `after`
    OurFeedMove,  // the same where only the feed was moved [m/s]
    Released,     // and let go of
    SpeedKnob,    // the operator's own override was moved, as a ratio
    FeedKnob,
    ProgrammedSpeed,  // the programme asks for another speed [rpm]
    Setting,          // somebody set a parameter: `words` = its value
  };
  Instant time{};
  What what = What::Event;
  EventLevel level = EventLevel::Info;
  Reason reason{};
  double before = 0.0, after = 0.0;
  QString words{};
  bool onset = false;  // an alarm that has not become chatter so far
};

// One sentence, with why where that is known: "Speed 8 800 to 8 565 rpm: centre of the next stable pocket".
QString eventSentence(const RunEvent& event, UnitSystem units);

// The machine as last read. Speeds in rpm, feed in m/s, overrides as ratios.
struct MachinePoint {
  Instant time{};
  Rpm programmed{}, actual{};
  MetresPerSecond feed{};
  Ratio speedOverride{1.0}, feedOverride{1.0};
};

class EventLog {
 public:
  void see(const Snapshot& snapshot);

  const std::deque<RunEvent>& events() const { return events_; }        // by time
  const std::deque<MachinePoint>& machine() const { return machine_; }  // one for each change, and one a second
  std::uint64_t version() const { return version_; }                    // another one: there are more events

 private:
  void seeState(const Snapshot& snapshot);
  void seeMoves(const Snapshot& snapshot);
  void add(const RunEvent& event);
  void addMachine(const Snapshot& snapshot);

  std::deque<RunEvent> events_;
  std::deque<MachinePoint> machine_;
  std::uint64_t nextEvent_ = 0, version_ = 0;
  Instant moved_{};  // the newest step of the newest move
  bool commanding_ = false;
  Ratio ourSpeed_{1.0}, ourFeed_{1.0};
  MachineState before_;
};

// Whether the alarm that began then became no chatter, as its card tells: known feed, and nothing marked.
bool stayedOnset(const SessionSummary& summary, Instant began);

// Of a whole recording, times from its first sample.
std::vector<RunEvent> eventsOf(const SessionSummary& summary);

}  // namespace stillcut::ui
