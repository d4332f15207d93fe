#include "ui/models/history/event_log.h"

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

constexpr std::size_t kMostEvents = 5000;
constexpr std::size_t kMostPoints = 20'000;  // some five hours of a machine that stands
constexpr Seconds kPointEvery{1.0};
constexpr Seconds kOneMove{2.0};
constexpr double kMove = 0.004;  // of an override: less is not shown anywhere
constexpr double kSpindleWanders = 0.005;

bool differ(double a, double b, double share) {
  return std::abs(a - b) > share * std::max({std::abs(a), std::abs(b), 1e-9});
}

QString arrow(const QString& before, const QString& after) {
  return QStringLiteral("%1 \u2192 %2").arg(before, after);
}

// Length is marked in chatter alone, and where the feed is known: none is no measure.
QString endText(const Reason& reason) {
  constexpr double kShown_mm = 0.05;
  if (reason.n[1] >= kShown_mm) return reasonText(reason);
  return say("Stable again after %1").arg(join(number(reason.n[0], 2), QStringLiteral("s")));
}

QString because(const QString& what, const Reason& reason) {
  const QString why = reasonWords(reason);
  return why.isEmpty() ? what : QStringLiteral("%1: %2").arg(what, why);
}

}  // namespace

QString eventSentence(const RunEvent& event, UnitSystem units) {
  const QString rpm = rpmUnit();
  switch (event.what) {
    case RunEvent::What::Event:
      if (event.reason.code == ReasonCode::ChatterEnded) return endText(event.reason);
      return event.onset ? onsetText(event.reason) : reasonText(event.reason);
    case RunEvent::What::OurMove:
      return because(
          say("Stillcut moves the speed %1").arg(join(arrow(number(event.before), number(event.after)), rpm)),
          event.reason);
    case RunEvent::What::OurFeedMove:
      return because(say("Stillcut moves the feed %1")
                         .arg(arrow(feedText(MetresPerSecond(event.before), units),
                                    feedText(MetresPerSecond(event.after), units))),
                     event.reason);
    case RunEvent::What::Released:
      return because(say("Stillcut lets go: back to the operator's overrides"), event.reason);
    case RunEvent::What::SpeedKnob:
      return say("The operator moves the speed override %1")
          .arg(arrow(overrideText(event.before), overrideText(event.after)));
    case RunEvent::What::FeedKnob:
      return say("The operator moves the feed override %1")
          .arg(arrow(overrideText(event.before), overrideText(event.after)));
    case RunEvent::What::ProgrammedSpeed:
      return say("The program asks for another speed: %1")
          .arg(join(arrow(number(event.before), number(event.after)), rpm));
    case RunEvent::What::Setting:
      return say("Somebody has set %1").arg(event.words);
  }
  return {};
}

// A ramp is one move: steps that follow each other end where the last one ends.
void EventLog::add(const RunEvent& event) {
  const bool goesOn = event.what != RunEvent::What::Event && event.what != RunEvent::What::Released &&
                      !events_.empty() && events_.back().what == event.what &&
                      secondsBetween(moved_, event.time) < kOneMove;
  moved_ = event.time;
  if (goesOn) {
    events_.back().after = event.after;
    ++version_;
    return;
  }
  // Moves are told by the machine's numbers, whose stamps may be older than the block they came with.
  auto place = events_.end();
  while (place != events_.begin() && (place - 1)->time > event.time) --place;
  events_.insert(place, event);
  if (events_.size() > kMostEvents) events_.pop_front();
  ++version_;
}

void EventLog::see(const Snapshot& snapshot) {
  const std::uint64_t oldest = snapshot.eventCount > kEventsShown ? snapshot.eventCount - kEventsShown : 0;
  for (std::uint64_t k = std::max(nextEvent_, oldest); k < snapshot.eventCount; ++k) {
    const Event& event = snapshot.events[k % kEventsShown];
    RunEvent told{event.time, RunEvent::What::Event, event.level, event.reason};
    told.onset = event.reason.code == ReasonCode::ChatterBegan;
    add(told);
  }
  nextEvent_ = snapshot.eventCount;
  seeState(snapshot);
  seeMoves(snapshot);
  addMachine(snapshot);
}

// An alarm begins as an onset; where it has become chatter it is called so.
void EventLog::seeState(const Snapshot& s) {
  const Verdict& verdict = s.verdicts[static_cast<std::size_t>(s.inCharge)];
  if (!verdict.valid || verdict.state != CutState::Chatter) return;
  for (auto event = events_.rbegin(); event != events_.rend(); ++event) {
    if (event->what != RunEvent::What::Event || event->reason.code != ReasonCode::ChatterBegan) continue;
    if (event->onset) ++version_;
    event->onset = false;
    return;
  }
}

void EventLog::seeMoves(const Snapshot& s) {
  const CommandRecord& command = s.command;
  const bool commands = s.commanding && command.kind == CommandKind::Set;
  const Ratio speed = commands ? command.speed : Ratio(1.0), feed = commands ? command.feed : Ratio(1.0);
  const Rpm base = s.machine.valid ? s.machine.programmedSpeed * s.machine.operatorSpeed.value : Rpm();
  const MetresPerSecond baseFeed = s.machine.programmedFeed * s.machine.operatorFeed.value;
  const Reason why = s.request.reason;
  if (!commands && commanding_) {
    add({s.time, RunEvent::What::Released, EventLevel::Info, {}});
  } else if (differ(speed.value, ourSpeed_.value, kMove) && base.value > 0.0) {
    add({s.time, RunEvent::What::OurMove, EventLevel::Info, why, base.value * ourSpeed_.value,
         base.value * speed.value});
  } else if (differ(feed.value, ourFeed_.value, kMove) && baseFeed.value > 0.0) {
    add({s.time, RunEvent::What::OurFeedMove, EventLevel::Info, why, baseFeed.value * ourFeed_.value,
         baseFeed.value * feed.value});
  }
  commanding_ = commands;
  ourSpeed_ = speed;
  ourFeed_ = feed;
  const MachineState& m = s.machine;
  if (!m.valid) return;
  if (before_.valid) {
    const auto knob = [&](Ratio was, Ratio is, RunEvent::What what) {
      if (differ(was.value, is.value, kMove)) add({m.time, what, EventLevel::Info, {}, was.value, is.value});
    };
    knob(before_.operatorSpeed, m.operatorSpeed, RunEvent::What::SpeedKnob);
    knob(before_.operatorFeed, m.operatorFeed, RunEvent::What::FeedKnob);
    if (differ(before_.programmedSpeed.value, m.programmedSpeed.value, kMove)) {
      add({m.time,
           RunEvent::What::ProgrammedSpeed,
           EventLevel::Info,
           {},
           before_.programmedSpeed.value,
           m.programmedSpeed.value});
    }
  }
  before_ = m;
}

void EventLog::addMachine(const Snapshot& snapshot) {
  const MachineState& m = snapshot.machine;
  if (!m.valid) return;
  const MachinePoint now{m.time, m.programmedSpeed, m.actualSpeed, m.actualFeed, m.speedOverride, m.feedOverride};
  if (!machine_.empty()) {
    const MachinePoint& last = machine_.back();
    if (now.time <= last.time) return;
    const bool same = !differ(now.programmed.value, last.programmed.value, kMove) &&
                      !differ(now.actual.value, last.actual.value, kSpindleWanders) &&
                      !differ(now.feed.value, last.feed.value, kSpindleWanders) &&
                      !differ(now.speedOverride.value, last.speedOverride.value, kMove) &&
                      !differ(now.feedOverride.value, last.feedOverride.value, kMove);
    if (same && secondsBetween(last.time, now.time) < kPointEvery) return;
  }
  machine_.push_back(now);
  if (machine_.size() > kMostPoints) machine_.pop_front();
}

bool stayedOnset(const SessionSummary& summary, Instant began) {
  const auto card = std::ranges::find(summary.interventions, began, &Intervention::began);
  return card != summary.interventions.end() && card->feedBefore.value > 0.0 && !(card->marked.value > 0.0);
}

std::vector<RunEvent> eventsOf(const SessionSummary& summary) {
  std::vector<RunEvent> out;
  for (const Event& event : summary.events) {
    out.push_back({event.time, RunEvent::What::Event, event.level, event.reason});
    out.back().onset = event.reason.code == ReasonCode::ChatterBegan && stayedOnset(summary, event.time);
  }
  for (const Intervention& i : summary.interventions) {
    if (i.commanded < i.began || !differ(i.speedBefore.value, i.speedAfter.value, kMove)) continue;
    out.push_back(
        {i.commanded, RunEvent::What::OurMove, EventLevel::Info, {}, i.speedBefore.value, i.speedAfter.value});
  }
  for (const SettingChange& set : summary.settingChanges) {
    if (set.key.empty()) continue;
    const QString words =
        QStringLiteral("%1 = %2").arg(QString::fromStdString(set.key), QString::fromStdString(set.value));
    out.push_back({Instant{} + toDuration(set.time), RunEvent::What::Setting, EventLevel::Info, {}, 0.0, 0.0, words});
  }
  std::ranges::stable_sort(out, {}, &RunEvent::time);
  return out;
}

}  // namespace stillcut::ui
