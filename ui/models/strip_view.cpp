#include "ui/models/strip_view.h"

#include <algorithm>
#include <cmath>

#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"
#include "ui/models/active_text.h"
#include "ui/models/advice_view.h"
#include "ui/models/history/run_history.h"
#include "ui/models/named_chatter.h"
#include "ui/models/simulation_over.h"

namespace stillcut::ui {
namespace {

constexpr Seconds kEventShownFor{30.0};

// Stream time of the first sample.
Instant beganAt(const Snapshot& s) {
  return s.time - toDuration(s.health.blockLength * static_cast<double>(s.health.blocks));
}

// A machine that had never answered when the run began, and answers now.
bool onlyBegan(const Event& event, const Snapshot& s) {
  if (event.reason.code == ReasonCode::MachineNeverRead) return s.machine.linkUp;
  if (event.reason.code != ReasonCode::LinkLost || !s.machine.linkUp) return false;
  constexpr Seconds kRounding{1e-3};
  return secondsBetween(beganAt(s), event.time) <= Seconds(event.reason.n[0]) + kRounding;
}

// A link that is lost keeps the time of its last answer, though its state is not valid either.
bool neverRead(const MachineState& machine) {
  return !machine.valid && machine.time == Instant{};
}

StripItem linkItem(const Picture& p) {
  if (p.info->linkLabel.isEmpty()) return {say("Machine"), say("none"), Tone::Faint};
  const QString& label = p.info->linkLabel;
  if (!p.link.problem.isEmpty()) return {label, p.link.problem, Tone::Chatter};
  if (simulationOver(p)) return {label, say("ended"), Tone::Faint};
  if (!p.snapshot || neverRead(p.snapshot->machine)) return {label, say("not read yet"), Tone::Faint};
  // Read after the block was recorded: as new as can be.
  const Seconds age =
      std::max(Seconds(), secondsBetween(p.snapshot->machine.time, p.snapshot->time)) + (p.stale ? p.age : Seconds());
  // Nobody asks the machine: whether it would answer is not known.
  constexpr Seconds kStandsStill{1.0};
  const Seconds thread = p.snapshot->health.linkThreadAge;
  if (thread > kStandsStill)
    return {label, say("Stillcut itself stands still for %1").arg(duration(thread)), Tone::Chatter};
  if (p.link.notYetBack) return {label, say("not yet back"), Tone::Chatter};
  if (!p.snapshot->machine.linkUp) return {label, say("no answer for %1").arg(duration(age)), Tone::Chatter};
  if (!p.snapshot->machine.valid) return {label, say("not read yet"), Tone::Faint};
  const Tone tone = age.value > 1.0 ? Tone::Onset : Tone::Normal;
  const Seconds effect = p.snapshot->machine.link.effect;
  // An age that nobody would act on is no news.
  constexpr Seconds kWorthTelling{0.3};
  const bool fresh = age <= kWorthTelling;
  if (!(effect.value > 0.0)) return {label, fresh ? say("answers") : duration(age), tone};
  if (fresh) return {label, say("acts in %1").arg(duration(effect)), tone};
  return {label, say("%1 old, acts in %2").arg(duration(age), duration(effect)), tone};
}

StripItem sensorItem(const Picture& p) {
  const QString label = say("Sensor");
  if (!p.link.ended.isEmpty()) return {label, p.link.ended, p.mayRunAgain ? Tone::Faint : Tone::Chatter};
  if (!p.snapshot) return {label, say("no samples yet"), Tone::Faint};
  if (p.stale && !p.lags()) return {label, say("nothing for %1").arg(duration(p.age)), Tone::Chatter};
  switch (p.verdict().reason.code) {
    case ReasonCode::InputClipped:
      return {label, say("at its limit"), Tone::Onset};
    case ReasonCode::InputDead:
      return {label, say("dead"), Tone::Chatter};
    case ReasonCode::InputNotFinite:
      return {label, say("not a number"), Tone::Chatter};
    case ReasonCode::InputAbsurd:
      return {label, say("impossible values"), Tone::Chatter};
    case ReasonCode::InputGap:
      return {label, say("samples missing"), Tone::Onset};
    case ReasonCode::InputSilent:
      return {label, say("fell silent"), Tone::Chatter};
    case ReasonCode::InputLoose:
      return {label, say("loose"), Tone::Chatter};
    case ReasonCode::InputOffset:
      return {label, say("left its zero"), Tone::Chatter};
    case ReasonCode::InputHum:
      return {label, say("mains hum"), Tone::Onset};
    case ReasonCode::InputNoise:
      return {label, say("only noise"), Tone::Chatter};
    case ReasonCode::InputDoubled:
      return {label, say("one axis twice"), Tone::Chatter};
    case ReasonCode::InputRepeated:
    case ReasonCode::InputRate:
      return {label, say("wrong rate"), Tone::Chatter};
    case ReasonCode::Learning:  // its rate
      return {label, say("being checked"), Tone::Onset};
    case ReasonCode::InputAliased:
      return {label, say("aliased"), Tone::Chatter};
    default:
      return {label, say("ok"), Tone::Normal};
  }
}

StripItem counter(const QString& label, quint64 count) {
  return {label, number(static_cast<double>(count)), count > 0 ? Tone::Onset : Tone::Normal};
}

StripItem recordingItem(const RecorderView& recorder, quint64 lost) {
  switch (recorder.state) {
    case RecorderView::State::Off:
      return {say("Recording"), say("off"), Tone::Faint};
    case RecorderView::State::Recording:
      if (lost == 0 && recorder.waiting) return {say("Recording"), say("at the next event"), Tone::Normal};
      if (lost == 0) return {say("Recording"), stopwatch(recorder.length), Tone::Normal};
      return {say("Recording"), say("%1, %2 lost").arg(stopwatch(recorder.length), number(static_cast<double>(lost))),
              Tone::Onset};
    case RecorderView::State::Failed:
      return {say("Recording"), recorder.problem.isEmpty() ? say("stopped") : recorder.problem, Tone::Chatter};
  }
  return {};
}

QString change(const QString& before, const QString& after, const QString& unit) {
  return join(QStringLiteral("%1 \u2192 %2").arg(before, after), unit);
}

// What the gate says of a move that did not do what it was made for; empty: it did, or is not judged yet. Quiet that
// came later is told by the card, not by the move.
QString failureOf(const Intervention& i) {
  if (i.quiet || (i.outcome != MoveOutcome::NotHelped && i.outcome != MoveOutcome::Louder)) return {};
  QString how = i.outcome == MoveOutcome::Louder && i.timesAsLoud > 0.0
                    ? say("louder: %1 times as before the move").arg(number(i.timesAsLoud, 1))
                    : say("the move did not help");
  if (!i.endedAuto) return how;
  return say("%1; ended in Advise: %2 moves in a row without help").arg(how, number(i.withoutHelp));
}

// Where the feed is known and nothing is marked, it has not become chatter.
QString headlineOf(const Intervention& i, const Picture& picture) {
  const Hertz named = picture.snapshot ? namedChatter(*picture.snapshot, i.frequency) : i.frequency;
  const QString at = join(number(named.value), QStringLiteral("Hz"));
  const bool onset = i.feedBefore.value > 0.0 && !(i.marked.value > 0.0);
  if (onset && i.finished && i.quiet)
    return say("Onset %1, stable after %2, nothing marked").arg(at, duration(i.timeToStable));
  const QString what = (onset ? say("Onset %1") : say("Chatter %1")).arg(at);
  if (const QString failed = failureOf(i); !failed.isEmpty()) return say("%1, %2").arg(what, failed);
  const bool acts = picture.snapshot && picture.snapshot->authority == Authority::Auto;
  if (!i.finished) return (acts ? say("%1, acting") : say("%1, going on")).arg(what);
  if (!i.quiet) return say("%1 when the tool left the cut").arg(what);
  return say("%1, stable after %2, %3 marked").arg(what, duration(i.timeToStable), lengthText(i.marked, picture.units));
}

// An onset that nobody touched and that went by itself: nothing that a card would tell.
bool worthACard(const Intervention& i) {
  const bool onset = i.feedBefore.value > 0.0 && !(i.marked.value > 0.0);
  return !onset || i.commanded != Instant{};
}

// Something has been done or is over: until then there is a now, and no before and after.
bool hasAfter(const Intervention& i) {
  return i.finished || i.commanded != Instant{};
}

// What was cured is the chatter, told as its part of the vibration. The vibration itself may even have risen: at the
// quiet speed the teeth may excite a mode, and the cut may have become deeper meanwhile.
QString vibrationOf(const Intervention& i, const QString& unit) {
  if (!hasAfter(i)) return say("Vibration %1").arg(join(significant(i.vibrationAfter), unit));
  const QString moved = change(significant(i.vibrationBefore), significant(i.vibrationAfter), unit);
  // After the tool has left it swings in the air, which is no result.
  if (i.finished && !i.quiet) return say("Vibration %1").arg(join(significant(i.vibrationBefore), unit));
  if (!i.finished) return say("Vibration %1").arg(moved);
  constexpr double kLess = 0.9;  // what anybody hears
  if (i.vibrationAfter < kLess * i.vibrationBefore) return say("Vibration %1: the chatter is gone").arg(moved);
  const QString teeth = percent(std::floor(1e2 * (1.0 - std::clamp(i.severityAfter.value, 0.0, 1.0))) / 1e2);
  return say("Vibration %1: no chatter, %2 is the teeth").arg(moved, teeth);
}

// Where nothing was moved there is one speed.
QString speedOf(const Intervention& i) {
  constexpr double kSame = 0.003;
  if (!(i.speedBefore.value > 0.0)) return {};
  const bool moved = std::abs(i.speedAfter / i.speedBefore - 1.0) > kSame;
  if (moved) return change(number(i.speedBefore.value), number(i.speedAfter.value), rpmUnit());
  return join(number(i.speedBefore.value), rpmUnit());
}

CardView cardOf(const Intervention& i, const Picture& picture) {
  const SessionInfo& info = *picture.info;
  const std::string_view si =
      siUnit(info.setup.channels.empty() ? SensorQuantity::Acceleration : info.setup.channels.front().quantity);
  const QString unit = QString::fromUtf8(si.data(), static_cast<qsizetype>(si.size()));
  CardView card;
  card.number = i.number;
  card.time = clockTime(info.wallMs(i.began));
  card.headline = headlineOf(i, picture);
  card.speed = speedOf(i);
  const double longer = 1e2 * (i.cycleTime.value - 1.0);
  if (i.finished && longer >= 0.5) card.cost = say("time +%1").arg(join(number(longer), QStringLiteral("%")));
  const QString after = number(1e2 * i.severityAfter.value), percentSign = QStringLiteral("%");
  const bool left = i.finished && !i.quiet;
  card.ratio = say("chatter %1")
                   .arg(left          ? join(number(1e2 * i.severityBefore.value), percentSign)
                        : hasAfter(i) ? change(number(1e2 * i.severityBefore.value), after, percentSign)
                                      : join(after, percentSign));
  card.vibration = vibrationOf(i, unit);
  card.tone = i.quiet ? Tone::Normal : i.finished ? Tone::Chatter : Tone::Advice;
  return card;
}

}  // namespace

std::vector<StripItem> makeStrip(const Picture& picture) {
  std::vector<StripItem> items{linkItem(picture), sensorItem(picture)};
  const PathHealth health = picture.snapshot ? picture.snapshot->health : PathHealth{};
  items.push_back({say("Rate"), join(number(picture.info->setup.rate.value), QStringLiteral("Hz")), Tone::Normal});
  items.push_back(counter(say("Lost"), health.droppedBlocks));
  items.push_back(counter(say("Too slow"), health.overruns));
  if (health.leasesExpired > 0) items.push_back(counter(say("Leases run out"), health.leasesExpired));
  if (health.linkStalls > 0) items.push_back(counter(say("Standstills"), health.linkStalls));
  const Seconds blockAge = picture.stale ? picture.age : health.blockAge;
  // After the last block no age grows that anybody should mind.
  const bool aging = picture.snapshot != nullptr && !picture.over();
  items.push_back({say("Delay"), duration(aging ? blockAge : Seconds(std::nan(""))),
                   !aging          ? Tone::Faint
                   : picture.stale ? Tone::Chatter
                                   : Tone::Normal});
  if (picture.table != nullptr) {
    const ActiveTableView table = makeActiveTable(*picture.table);
    items.push_back({say("Table"), table.text, table.tone});
  }
  items.push_back(recordingItem(picture.recorder, health.tapDropped));
  return items;
}

CommandView makeCommandView(const Picture& picture) {
  CommandView view;
  view.autoNeedsSecondTouch = !picture.info->machineWatchdog;
  view.kept = picture.info->kept;
  view.machine = !picture.info->linkLabel.isEmpty();
  view.verdict = makeVerdictView(picture, Trend::Unknown);
  view.verdict.detail = view.verdict.marked = QString();  // there is room for a glance
  if (!picture.snapshot) {
    view.inCommand = say("You are in command");
    return view;
  }
  const Snapshot& s = *picture.snapshot;
  view.authority = s.authority;
  view.live = s.running;
  view.notYetBack = !simulationOver(picture) &&
                    (picture.link.notYetBack || (s.authority == Authority::Off && s.commanding && s.machine.linkUp));
  view.autoAllowed = s.autoAllowed;
  view.held = s.operatorHold;
  if (const AdviceView advice = makeAdviceView(picture); advice.mode == AdviceView::Mode::Open) {
    view.advice = advice.target;
    view.adviceNumber = s.adviceNumber;
  }
  const MachineState& m = s.machine;
  const auto differs = [](Ratio r) { return std::abs(r.value - 1.0) > 0.004; };
  if (m.valid && (differs(m.speedOverride) || differs(m.feedOverride))) {
    view.moved = QStringLiteral("%1, %2").arg(overrideText(m.speedOverride.value), overrideText(m.feedOverride.value));
  }
  view.inCommand = s.authority == Authority::Auto     ? say("Stillcut is in command")
                   : s.authority == Authority::Advise ? say("You are in command, Stillcut advises")
                                                      : say("You are in command");
  // An authority that nobody has changed is as old as the run.
  view.since = say("since %1").arg(clockTime(picture.info->wallMs(std::max(s.authoritySince, beganAt(s)))));
  if (s.authority == Authority::Auto && picture.info->simulatedMachine) {
    view.since = say("%1, on this simulated machine").arg(view.since);
  }
  if (!view.machine) view.since = say("no machine link: advice is for your hand");
  if (picture.stale) {
    view.since = picture.lags() ? say("%1 behind").arg(duration(picture.age))
                                : say("as last heard, %1 ago").arg(duration(picture.age));
    if (picture.lags()) view.autoAllowed = false;  // nothing is handed to what sees the cut too late
  }
  if (s.operatorHold) view.since = say("held by you, %1").arg(view.since);
  if (picture.over()) {  // with the samples every lease has ended: nobody but the machine's own knobs commands
    view.authority = Authority::Off;
    view.live = view.autoAllowed = view.held = false;
    view.over = true;
    if (!view.notYetBack) view.moved.clear();
    view.inCommand = say("You are in command");
    view.since = picture.link.ended;
  }
  if (view.notYetBack) {  // whoever is in command is not yet in command of what he set
    view.inCommand = view.moved.isEmpty() ? say("NOT YET BACK") : say("NOT YET BACK: now %1").arg(view.moved);
    view.since = say("released, and the machine has not shown it yet");
  }
  if (picture.replay) view.since = say("live, %1").arg(view.since);
  return view;
}

NewestAlarm makeNewestAlarm(const Picture& picture) {
  const auto judged = [&](Instant began) {
    return picture.history != nullptr ? picture.history->marks().of(began) : AlarmJudgement::None;
  };
  if (!picture.snapshot || picture.snapshot->interventionCount == 0) return {0, {}, {}, judged({})};
  const Snapshot& s = *picture.snapshot;
  const Intervention& newest = s.interventions[(s.interventionCount - 1) % kInterventionsShown];
  return {s.interventionCount, clockTime(picture.info->wallMs(newest.began)), newest.began, judged(newest.began)};
}

std::vector<CardView> makeCards(const Picture& picture) {
  std::vector<CardView> cards;
  if (!picture.snapshot) return cards;
  const Snapshot& s = *picture.snapshot;
  const quint64 kept = std::min<quint64>(s.interventionCount, kInterventionsShown);
  for (quint64 k = 0; k < kept; ++k) {
    const quint64 number = s.interventionCount - 1 - k;
    const Intervention& intervention = s.interventions[number % kInterventionsShown];
    if (!worthACard(intervention)) continue;
    cards.push_back(cardOf(intervention, picture));
    if (k > 0) cards.back().vibration.clear();  // it is about now
  }
  return cards;
}

EventLine makeEventLine(const Picture& picture) {
  // Stays until the table is started anew: the cut that it held is no longer held.
  if (picture.table != nullptr) {
    const ActiveTableView table = makeActiveTable(*picture.table);
    if (!table.fault.isEmpty()) return {table.fault, Tone::Chatter};
  }
  if (!picture.link.notice.isEmpty()) return {picture.link.notice, Tone::Onset};
  if (!picture.snapshot) return {};
  const Snapshot& s = *picture.snapshot;
  const quint64 kept = std::min<quint64>(s.eventCount, kEventsShown);
  for (quint64 k = 0; k < kept; ++k) {
    const Event& event = s.events[(s.eventCount - 1 - k) % kEventsShown];
    if (secondsBetween(event.time, s.time) > kEventShownFor) break;
    if (event.level == EventLevel::Info || event.reason.code == ReasonCode::ChatterBegan) continue;
    if (onlyBegan(event, s)) continue;
    if (event.reason.code == ReasonCode::MachineNeverRead && picture.info->linkLabel.isEmpty()) continue;
    return {clockTime(picture.info->wallMs(event.time)) + u' ' + reasonText(event.reason),
            event.level == EventLevel::Fault ? Tone::Chatter : Tone::Onset};
  }
  return {};
}

}  // namespace stillcut::ui
