#include "ui/models/advice_view.h"

#include <QStringList>
#include <cmath>
#include <numbers>

#include "ui/base/format.h"
#include "ui/base/reason_text.h"
#include "ui/base/say.h"

namespace stillcut::ui {
namespace {

// Where speed and feed shall go, whoever says so. 0: not moved.
struct Move {
  Rpm speed;
  MetresPerSecond feed;
};

// A command nearer to 100 % than the screen can tell has moved nothing.
bool moves(const CommandRecord& command) {
  const bool set = command.kind == CommandKind::Set;
  return set && (std::abs(command.speed.value - 1.0) > 0.004 || std::abs(command.feed.value - 1.0) > 0.004);
}

// The gate only repeats the numbers: it holds nothing back.
bool repeatsNumbers(ReasonCode code) {
  return code == ReasonCode::None || code == ReasonCode::GateInForce || code == ReasonCode::GateMoving;
}

// Told by the panel's own words already.
bool idle(ReasonCode code) {
  return code == ReasonCode::NothingToDo || code == ReasonCode::NothingToDoAt;
}

QString deltaText(const Move& move, const MachineState& machine) {
  if (!(machine.programmedSpeed.value > 0)) return {};
  const double change = move.speed.value - machine.programmedSpeed.value;
  return say("%1 rpm, %2").arg(withSign(change), overrideText(move.speed / machine.programmedSpeed));
}

// Time goes as 1 / feed; the cutting speed is pi D n.
QString costText(const Move& move, const Picture& picture) {
  QStringList parts;
  const MachineState& machine = picture.snapshot->machine;
  if (move.feed.value > 0 && machine.programmedFeed.value > 0) {
    const double change = (machine.programmedFeed / move.feed - 1.0) * 100.0;
    if (std::abs(change) < 0.05) {
      parts << say("Costs no time");
    } else {
      const QString amount = join(number(std::abs(change), 1), QStringLiteral("%"));
      parts << (change > 0 ? say("Costs %1 time") : say("Saves %1 time")).arg(amount);
    }
  }
  const Metres diameter = picture.info->setup.toolDiameter;
  if (move.speed.value > 0 && diameter.value > 0) {
    const MetresPerSecond edge(std::numbers::pi * diameter.value * move.speed.value / 60.0);
    parts << say("cutting speed %1").arg(cuttingSpeedText(edge, picture.units));
  }
  QString text = parts.join(say(", "));
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString feedSentence(const Move& move, UnitSystem units) {
  if (!(move.feed.value > 0)) return say("The feed stays as it is");
  return say("Feed follows: %1").arg(feedText(move.feed, units));
}

void fillMove(AdviceView& view, const Move& move, const Picture& picture) {
  if (move.speed.value > 0) {
    view.target = join(number(move.speed.value), QStringLiteral("rpm"));
    view.delta = deltaText(move, picture.snapshot->machine);
    view.feed = feedSentence(move, picture.units);
  } else {
    view.target = feedText(move.feed, picture.units);
    view.feed = say("The speed stays as it is");
  }
  view.cost = costText(move, picture);
}

AdviceView openAdvice(const Picture& picture) {
  const OverrideRequest& request = picture.snapshot->request;
  AdviceView view;
  view.mode = AdviceView::Mode::Open;
  view.title = say("ADVICE");
  if (picture.replay) {  // it was answered when it was live, or never
    view.mode = AdviceView::Mode::InForce;
    view.title = say("ADVICE IN THE REPLAY");
  }
  view.reason = reasonText(request.reason);
  if (request.kind == RequestKind::Release) {
    view.target = say("Back to 100 %");
    return view;
  }
  fillMove(view, {request.claimsSpeed ? request.speed : Rpm(), request.claimsFeed ? request.feed : MetresPerSecond()},
           picture);
  return view;
}

AdviceView commandInForce(const Picture& picture, const Reason& moveReason) {
  const Snapshot& s = *picture.snapshot;
  AdviceView view;
  view.mode = AdviceView::Mode::InForce;
  view.title = !s.machine.linkUp ? say("ASKED FOR, NOT CONFIRMED BY THE MACHINE")
               : s.operatorHold  ? say("IN FORCE, HELD BY YOU")
                                 : say("IN FORCE");
  fillMove(view, {s.machine.programmedSpeed * s.command.speed.value, s.machine.programmedFeed * s.command.feed.value},
           picture);
  // What the gate keeps back comes first; otherwise the strategy has the word.
  const bool strategySays = moveReason.code != ReasonCode::None && repeatsNumbers(s.command.reason.code);
  view.reason = reasonText(strategySays ? moveReason : s.command.reason);
  return view;
}

AdviceView nothing(const Picture& picture) {
  AdviceView view;
  view.title = say("WHAT TO DO");
  if (picture.over()) {
    view.target = say("No advice");
    view.reason = say("Another run begins on the page Set up: GUIDE or PROFILE");
    return view;
  }
  if (!picture.snapshot || picture.stale) {
    view.target = say("No advice");
    view.reason = say("There is no live picture to advise on");
    return view;
  }
  const Snapshot& s = *picture.snapshot;
  const bool alarm = picture.verdict().alarming();
  const bool quiet = picture.verdict().valid && !alarm;
  view.target = quiet ? say("Nothing to do") : say("No advice");
  view.reason = idle(s.request.reason.code) ? QString() : reasonText(s.request.reason);
  const bool wishes = s.request.kind == RequestKind::Set;  // and nobody asks for its reasons
  if (s.authority == Authority::Off && (view.reason.isEmpty() || wishes))
    view.reason = say("Authority is off: Stillcut only watches");
  if (view.reason.isEmpty() && !quiet && !alarm) view.reason = say("There is no verdict to act on");
  if (view.reason.isEmpty() && alarm) view.reason = say("The strategy has not decided yet");
  return view;
}

}  // namespace

QString AdviceView::spoken() const {
  QStringList parts{title, target, delta, reason, feed, cost};
  parts.removeAll(QString());
  return parts.join(QStringLiteral(". "));
}

AdviceView makeAdviceView(const Picture& picture, const Reason& moveReason) {
  if (!picture.snapshot || picture.stale || picture.over()) return nothing(picture);
  const Snapshot& s = *picture.snapshot;
  const bool isMove = s.request.kind == RequestKind::Set || s.request.kind == RequestKind::Release;
  if (s.adviceOpen && isMove) return openAdvice(picture);
  if (s.commanding && moves(s.command)) return commandInForce(picture, moveReason);
  return nothing(picture);
}

}  // namespace stillcut::ui
